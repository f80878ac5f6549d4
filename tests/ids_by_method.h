#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "displayfile/graphics_system.h"
#include "interp/draw/draw.h"
#include "interp/draw/world_views.h"
#include "interp/truth/truth.h"

// Item buffers by every method that decides surfaces exactly.

namespace displayfile::test {

inline constexpr HiddenMethod kSurfaceMethods[] = {
    HiddenMethod::z_buffer,   HiddenMethod::scan_line, HiddenMethod::scan_line_z,
    HiddenMethod::ray_cast,   HiddenMethod::warnock,   HiddenMethod::bsp,
    HiddenMethod::depth_sort, HiddenMethod::map,       HiddenMethod::world_ray_cast};

inline DrawOptions options_for_ids(int size, HiddenMethod method) {
  DrawOptions options{.samples = 1};
  options.width = options.height = size;
  options.surfaces.method = method;
  options.with_ids = true;
  return options;
}

/// The system must retain the scene.
inline std::vector<std::int32_t> ids_by(const GraphicsSystem& g, HiddenMethod method, int size) {
  const DrawOptions options = options_for_ids(size, method);
  if (method == HiddenMethod::world_ray_cast) {
    return draw(WorldViews(*g.retained(), g.display_file()).as_drawn(), options).ids;
  }
  return draw(g, options).ids;
}

inline std::size_t wrong_pixels(const std::vector<std::int32_t>& ids, const Picture& truth) {
  std::size_t wrong = 0;
  for (std::size_t k = 0; k < ids.size(); ++k) wrong += ids[k] != truth.ids[k] ? 1 : 0;
  return wrong;
}

}  // namespace displayfile::test
