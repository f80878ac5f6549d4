#include "displayfile/mesh/cap_polygons.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <tuple>

#include "displayfile/mesh/joined_by_bridges.h"

namespace displayfile {

namespace {

using Outline = std::vector<Point2>;

/// A loop in the projection along the normal's largest component.
struct FlatLoop {
  Outline points;
  Point2 low{HUGE_VAL}, high{-HUGE_VAL};
  double area = 0.0;  ///< positive around solid

  FlatLoop(const std::vector<Point3>& loop, int axis, double facing) {
    for (const Point3& p : loop) {
      const Point2& flat = points.emplace_back(p[(axis + 1) % 3], p[(axis + 2) % 3]);
      low = glm::min(low, flat);
      high = glm::max(high, flat);
    }
    Point2 from = points.back() - points.front();
    for (const Point2& p : points) {
      const Point2 to = p - points.front();
      area += facing * (from.x * to.y - to.x * from.y) / 2.0;
      from = to;
    }
  }
};

bool is_inside(const Point2& p, const Outline& outline) {
  bool inside = false;
  Point2 from = outline.back();
  for (const Point2& to : outline) {
    if ((from.y > p.y) != (to.y > p.y)) {
      const double x = from.x + (to.x - from.x) * (p.y - from.y) / (to.y - from.y);
      if (p.x < x) inside = !inside;
    }
    from = to;
  }
  return inside;
}

/// Whether most of a hole's vertices and middles of sides are inside: some of them may be on the
/// outline.
bool is_within(const FlatLoop& hole, const FlatLoop& other) {
  if (glm::any(glm::lessThan(hole.low, other.low)) ||
      glm::any(glm::greaterThan(hole.high, other.high))) {
    return false;
  }
  std::size_t inside = 0;
  Point2 from = hole.points.back();
  for (const Point2& to : hole.points) {
    if (is_inside(to, other.points)) ++inside;
    if (is_inside(0.5 * (from + to), other.points)) ++inside;
    from = to;
  }
  return inside > hole.points.size();
}

std::vector<FlatLoop> flat_loops(const Section& section, const SectionPlane& plane) {
  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::abs(plane.normal[k]) > std::abs(plane.normal[axis])) axis = k;
  }
  const double facing = plane.normal[axis] < 0.0 ? -1.0 : 1.0;
  std::vector<FlatLoop> flat;
  flat.reserve(section.loops.size());
  for (const auto& loop : section.loops) flat.emplace_back(loop, axis, facing);
  return flat;
}

}  // namespace

void turn_bodies_out(Section& section, const SectionPlane& plane) {
  const std::vector<FlatLoop> flat = flat_loops(section, plane);
  std::vector<double> area_of_object;
  for (std::size_t i = 0; i < flat.size(); ++i) {
    const std::size_t object = section.object_of[i];
    if (object >= area_of_object.size()) area_of_object.resize(object + 1, 0.0);
    area_of_object[object] += flat[i].area;
  }
  const auto size = [&](std::size_t i) { return std::abs(flat[i].area); };
  for (std::size_t i = 0; i < flat.size(); ++i) {
    std::size_t outermost = i;
    for (std::size_t k = 0; k < flat.size(); ++k) {
      if (size(k) > size(outermost) && is_within(flat[i], flat[k])) outermost = k;
    }
    if (area_of_object[section.object_of[outermost]] < 0.0) {
      std::reverse(section.loops[i].begin(), section.loops[i].end());
    }
  }
}

std::vector<std::vector<Point3>> cap_polygons(const Section& section, const SectionPlane& plane) {
  const std::vector<FlatLoop> flat = flat_loops(section, plane);
  std::vector<std::vector<std::vector<Point3>>> faces(flat.size());  // a loop, and its holes
  for (std::size_t i = 0; i < flat.size(); ++i) {
    if (flat[i].area > 0.0) faces[i].push_back(section.loops[i]);
  }
  for (std::size_t i = 0; i < flat.size(); ++i) {
    if (flat[i].area > 0.0) continue;
    std::size_t around = i;  // nothing
    for (std::size_t k = 0; k < flat.size(); ++k) {
      if (!(flat[k].area > 0.0) || !is_within(flat[i], flat[k])) continue;
      const auto size = [&](std::size_t j) { return std::tuple(flat[j].area, faces[j].size()); };
      if (around == i || size(k) < size(around)) around = k;
    }
    faces[around].push_back(section.loops[i]);
  }
  std::vector<std::vector<Point3>> polygons;
  for (const auto& face : faces) {
    if (face.empty()) continue;
    polygons.push_back(joined_by_bridges<Point3>(face, [](const Point3& p) { return p; }));
  }
  return polygons;
}

}  // namespace displayfile
