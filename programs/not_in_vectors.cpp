#include "programs/not_in_vectors.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <string_view>
#include <vector>

#include "interp/visibility/image_space.h"
#include "programs/warnings.h"

namespace displayfile {

namespace {

/// Whether something of a visible segment has what its instructions store of vertices.
template <class Stored>
bool has_stored(const DisplayFile& drawn, Stored stored) {
  return std::ranges::any_of(drawn.segments(), [&](const Segment& segment) {
    return segment.visible && !((*segment.entered()).*stored)().empty();
  });
}

}  // namespace

void NotInVectors::note(const GraphicsSystem& system, const DrawOptions& options,
                        PictureKind kind) {
  if (kind != PictureKind::vector) return;
  const DisplayFile& drawn = system.display_file();
  if (options.pens && drawn.has_texts()) texts_ = true;
  const HiddenMethod by = drawing_method(system, options, kind);
  const bool fills = !finds_lines(by) && (!options.pens || options.pens->hatching);
  if (fills && has_stored(drawn, &Instructions::stored_normals)) phong_ = true;
  const bool by_map = by == HiddenMethod::map || is_image_space(by);
  const bool each_segment = options.scope == HiddenScope::segment && by == HiddenMethod::map;
  if (fills && drawn.has_shadows() && (!by_map || each_segment)) shadows_ = true;
  if (options.samples > 1) samples_ = true;
}

void NotInVectors::warn(const std::string& output) const {
  std::vector<std::string_view> left_out;
  if (phong_) left_out.emplace_back("Phong shading (drawn as Gouraud shading)");
  if (shadows_) left_out.emplace_back("shadows (those of map are drawn, of all segments)");
  if (samples_) left_out.emplace_back("--samples");
  if (texts_) left_out.emplace_back("texts, whose letters no pen draws");
  if (left_out.empty()) return;
  warnings() << fmt::format("{}: vectors leave out {}\n", output, fmt::join(left_out, ", "));
}

}  // namespace displayfile
