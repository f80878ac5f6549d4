#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "interp/truth/true_lines.h"
#include "tests/truth_scenes.h"

// Small scenes of polygons and lines, for the tests of the truth of lines.

namespace displayfile::test {

using Parts = std::vector<TrueLine::Part>;

/// Polygons and lines of one segment; all are outlined.
class Drawing {
 public:
  Drawing() { segment().set_style(LineStyle{}); }
  Drawing& polygon(const Vertices& vertices) {
    enter(segment(), vertices);
    return *this;
  }
  Drawing& line(const Point3& from, const Point3& to) {
    segment().enter_line(from, to);
    return *this;
  }
  Segment& segment() { return file_.contains(1) ? file_.segment(1) : file_.create(1); }
  const DisplayFile& file() const { return file_; }

 private:
  DisplayFile file_;
};

inline Vertices rectangle(double x0, double y0, double x1, double y1, double z) {
  return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}
inline Vertices square(double z) { return rectangle(0.25, 0.25, 0.75, 0.75, z); }

/// Up to six polygons and three lines with their points on a grid of 5 x 5 x 3, so that most of
/// them touch.
inline std::vector<Vertices> on_coarse_grid(std::uint32_t seed) {
  Dice dice(seed);
  const auto point = [&] {
    const double x = dice.from(0, 4) / 4.0, y = dice.from(0, 4) / 4.0;
    return Point3{x, y, dice.from(0, 2) / 2.0};
  };
  std::vector<Vertices> items;
  const int polygons = dice.from(2, 6), lines = dice.from(0, 3);
  for (int k = 0; k < polygons; ++k) {
    items.push_back(polygon(dice.of(std::array{3, 3, 3, 4, 4, 5, 7}), point));
    if (dice.one_in(3)) {  // shares a side with the one before
      const Vertices& before = items[static_cast<std::size_t>(std::max(0, k - 1))];
      items.back()[0] = before[1];
      items.back()[1] = before[0];
    }
  }
  for (int k = 0; k < lines; ++k) items.push_back(polygon(2, point));
  return items;
}

inline DisplayFile drawn(const std::vector<Vertices>& items) {
  DisplayFile file;
  Segment& segment = file.create(1);
  for (const Vertices& item : items) {
    if (item.size() == 2) {
      segment.enter_line(item[0], item[1]);
    } else {
      enter(segment, item);
    }
  }
  return file;
}

}  // namespace displayfile::test
