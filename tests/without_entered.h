#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "displayfile/segments/display_file.h"

namespace displayfile::test {

/// The same display file without the entered polygons, as one read from a dump: all begins at its
/// own coordinates. Its surfaces, if it has any, come first; texts and shading are left out.
inline DisplayFile without_entered(const DisplayFile& file) {
  struct Copy {
    Segment& segment;
    std::optional<Point3> pen = {};
    void fill(const FillStyle& style) { segment.set_style(style); }
    void line_style(const LineStyle& style) { segment.set_style(style); }
    void pick(std::int32_t id) { segment.set_pick(id); }
    void line_pick(std::int32_t id) { segment.set_line_pick(id); }
    void move(const Point3& p) { pen = p; }
    void line(const Point3& p) {
      segment.enter_line(*pen, p);
      pen = p;
    }
    void polygon(std::span<const Point3> vertices, std::span<const std::int32_t> sides) {
      std::vector<std::uint8_t> visible;
      for (const std::int32_t side : sides) visible.push_back(side == op::line ? 1 : 0);
      segment.enter_polygon(vertices, visible);
      pen = vertices.back();
    }
  };
  DisplayFile all;
  for (const Segment& segment : file.segments()) {
    Segment& same = all.create(segment.name());
    for (const SurfaceMark& mark : segment.entered()->surfaces()) same.mark_surface(mark);
    segment.walk_entered(Copy{same});
    same.image = segment.image;
    same.visible = segment.visible;
    same.close();
  }
  return all;
}

}  // namespace displayfile::test
