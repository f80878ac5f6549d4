#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "displayfile/segments/display_file.h"
#include "tests/fuzz/fuzz_input.h"

namespace displayfile::fuzz {

/// A target's scene, made from its bytes: polygons, some concave or self-crossing, with vertices on
/// a grid and an ulp or two beside it.
struct PolygonsNearGrid {
  int most;              ///< polygons
  int every_second;      ///< half the steps of a grid whose every second line is one of centres
  LineStyle::Kind line;  ///< of their sides
  bool lines = false;    ///< now and then a line in place of a polygon
};

inline DisplayFile display_file_of(FuzzInput input, const PolygonsNearGrid& what) {
  const int grids[] = {4, 8, 2 * what.every_second, 7, 10, 64};
  DisplayFile file;
  Segment* segment = nullptr;
  int grid = 4;
  for (int k = 0; k < what.most && !input.empty(); ++k) {
    const int kind = input.byte();
    if (segment == nullptr || kind % 16 == 0) {
      segment = &file.create(k + 1);
      segment->set_style(LineStyle{what.line});
    }
    if (kind % 4 == 0) grid = grids[static_cast<std::size_t>(input.below(6))];
    if (what.lines && kind % 8 == 3) {
      const Point3 from = input.point_near_grid(grid);
      segment->enter_line(from, input.point_near_grid(grid));
      continue;
    }
    segment->set_style(FillStyle{kind >= 240 ? FillStyle::Kind::hollow : FillStyle::Kind::solid});
    segment->set_pick(k);
    std::vector<Point3> vertices;
    for (int sides = 3 + input.below(5); sides > 0; --sides) {
      vertices.push_back(input.point_near_grid(grid));
    }
    segment->enter_polygon(vertices, std::vector<std::uint8_t>(vertices.size(), 1));
  }
  return file;
}

}  // namespace displayfile::fuzz
