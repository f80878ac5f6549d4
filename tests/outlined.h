#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "displayfile/looks/style.h"
#include "displayfile/segments/display_file.h"

namespace displayfile::test {

/// The scene as entered, every side and line in one style.
inline DisplayFile outlined(const DisplayFile& file, const LineStyle& style) {
  struct Copy {
    Segment& to;
    Point3 pen{0.0};
    std::vector<std::uint8_t> drawn{};

    void fill(const FillStyle& s) { to.set_style(s); }
    void line_style(const LineStyle&) {}
    void pick(std::int32_t id) { to.set_pick(id); }
    void move(const Point3& p) { pen = p; }
    void line(const Point3& p) {
      to.enter_line(pen, p);
      pen = p;
    }
    void polygon(std::span<const Point3> vertices, std::span<const std::int32_t> sides) {
      drawn.clear();
      for (const std::int32_t side : sides) drawn.push_back(side == op::line ? 1 : 0);
      to.enter_polygon(vertices, drawn);
      pen = vertices.back();
    }
  };
  DisplayFile all;
  for (const Segment& segment : file.segments()) {
    Segment& copy = all.create(segment.name());
    copy.image = segment.image;
    copy.set_style(style);
    segment.walk_entered(Copy{copy});
    copy.close();
  }
  return all;
}

}  // namespace displayfile::test
