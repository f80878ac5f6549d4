#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "clip/surfaces.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/retained_scene.h"
#include "displayfile/segments/sorted_scene.h"

namespace displayfile::test {

inline constexpr LineKinds kOutline = kinds_of(LineKind::outline);
inline constexpr LineKinds kBoundary = kinds_of(LineKind::boundary);
inline constexpr LineKinds kCrease = kinds_of(LineKind::crease);
inline constexpr LineKinds kMaterial = kinds_of(LineKind::material);
inline constexpr LineKinds kAll = kinds_of(LineKind::all);

struct Less {
  bool operator()(const Point3& a, const Point3& b) const {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  }
};
struct LessSide {
  bool operator()(const std::pair<Point3, Point3>& a, const std::pair<Point3, Point3>& b) const {
    if (a.first != b.first) return Less{}(a.first, b.first);
    return Less{}(a.second, b.second);
  }
};
/// Sides by their ends, the smaller first, whichever polygons have them, and of which kinds.
using Sides = std::map<std::pair<Point3, Point3>, LineKinds, LessSide>;

inline void add(Sides& sides, const Point3& a, const Point3& b, LineKinds kinds) {
  if (kinds == 0) return;
  LineKinds& of_side = sides[Less{}(a, b) ? std::pair(a, b) : std::pair(b, a)];
  of_side = static_cast<LineKinds>(of_side | kinds);
}
inline std::size_t count(const Sides& sides, LineKinds kind) {
  std::size_t n = 0;
  for (const auto& [ends, kinds] : sides) n += (kinds & kind) != 0 ? 1 : 0;
  return n;
}

/// The sides that a retained scene's segments draw, in world coordinates.
inline Sides sides_in_view(const RetainedScene& scene, const Eye& eye) {
  std::vector<LineKinds> of_corners;
  scene.sides_in_view(eye, of_corners);
  Sides sides;
  for (std::uint32_t i = 0; i < scene.size(); ++i) {
    const PointRow points = scene.points(i);
    for (std::uint32_t k = 0; k < points.size(); ++k) {
      const Point3& before = points[k == 0 ? points.size() - 1 : k - 1];
      add(sides, before, points[k], of_corners[scene[i].first + k]);
    }
  }
  return sides;
}

/// Those that instructions draw, in device coordinates.
struct DrawnSides {
  Sides sides;
  std::map<LineKinds, double>
      lengths;  ///< in the projection, of each polygon's sides by themselves
  std::span<const LineKinds> kinds;
  void fill(const FillStyle&) {}
  void line_style(const LineStyle&) {}
  void pick(std::int32_t) {}
  void move(const Point3&) {}
  void line(const Point3&) {}
  void side_kinds(std::span<const LineKinds> of_sides) { kinds = of_sides; }
  void polygon(std::span<const Point3> points, std::span<const std::int32_t> codes) {
    for (std::size_t k = 0; k < points.size(); ++k) {
      const bool drawn = codes[k] == op::line;
      EXPECT_TRUE(kinds.empty() || drawn == (kinds[k] != 0));
      if (!drawn) continue;
      const LineKinds of_side = kinds.empty() ? kDrawn : kinds[k];
      const Point3 &from = points[k == 0 ? points.size() - 1 : k - 1], &to = points[k];
      add(sides, from, to, of_side);
      lengths[of_side] += std::hypot(to.x - from.x, to.y - from.y);
    }
    kinds = {};
  }
};
inline DrawnSides drawn(const DisplayFile& file) {
  DrawnSides drawn;
  if (file.sorted() != nullptr) {
    file.sorted()->walk(drawn);
  } else {
    for (const Segment& segment : file.segments()) segment.walk_drawn(drawn);
  }
  return drawn;
}
inline Sides drawn_sides(const DisplayFile& file) { return drawn(file).sides; }

}  // namespace displayfile::test
