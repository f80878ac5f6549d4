#include "displayfile/mesh/section.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <span>

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

/// The loops of an object.
class FlatObject {
 public:
  void add(const FlatLoop& loop, std::size_t number) {
    loops_.push_back(&loop);
    numbers_.push_back(number);
    low_ = glm::min(low_, loop.low);
    high_ = glm::max(high_, loop.high);
    area_ += loop.area;
  }
  double area() const { return area_; }
  std::span<const std::size_t> numbers() const { return numbers_; }  ///< of the section's loops

  /// True if all that is inside this object's outlines is material of the other one, without holes
  /// of the other.
  bool is_within(const FlatObject& other) const {
    if (numbers_.empty() || glm::any(glm::lessThan(low_, other.low_)) ||
        glm::any(glm::greaterThan(high_, other.high_))) {
      return false;
    }
    return std::ranges::all_of(loops_, [&](auto* loop) { return other.has_inside(*loop); }) &&
           std::ranges::none_of(other.loops_, [&](auto* loop) { return has_inside(*loop); });
  }

 private:
  /// By the even-odd rule.
  bool has_inside(const Point2& p) const {
    return std::ranges::count_if(loops_, [&](auto* of) { return is_inside(p, of->points); }) % 2 ==
           1;
  }
  /// True if most of the loop's vertices and midpoints of sides are inside. Some of them are on the
  /// outline where the loop touches it; if the loop runs along the outline all the way, either
  /// answer is valid.
  bool has_inside(const FlatLoop& loop) const {
    std::size_t inside = 0;
    Point2 from = loop.points.back();
    for (const Point2& to : loop.points) {
      if (has_inside(to)) ++inside;
      if (has_inside(0.5 * (from + to))) ++inside;
      from = to;
    }
    return inside > loop.points.size();
  }

  std::vector<const FlatLoop*> loops_;
  std::vector<std::size_t> numbers_;
  Point2 low_{HUGE_VAL}, high_{-HUGE_VAL};
  double area_ = 0.0;
};

/// A section's loops in the plane.
struct FlatSection {
  std::vector<FlatLoop> loops;
  std::vector<FlatObject> objects;

  FlatSection(const Section& section, const SectionPlane& plane) {
    int axis = 0;
    for (int k = 1; k < 3; ++k) {
      if (std::abs(plane.normal[k]) > std::abs(plane.normal[axis])) axis = k;
    }
    const double facing = plane.normal[axis] < 0.0 ? -1.0 : 1.0;
    loops.reserve(section.loops.size());
    for (const auto& loop : section.loops) loops.emplace_back(loop, axis, facing);
    for (std::size_t i = 0; i < loops.size(); ++i) {
      const std::size_t object = section.object_of[i];
      if (object >= objects.size()) objects.resize(object + 1);
      objects[object].add(loops[i], i);
    }
  }
};

}  // namespace

void turn_bodies_out(Section& section, const SectionPlane& plane) {
  const FlatSection flat(section, plane);
  const auto size = [](const FlatObject& object) { return std::abs(object.area()); };
  for (const FlatObject& object : flat.objects) {
    const FlatObject* outermost = &object;
    for (const FlatObject& other : flat.objects) {
      if (size(other) > size(*outermost) && object.is_within(other)) outermost = &other;
    }
    if (outermost->area() >= 0.0) continue;
    for (const std::size_t i : object.numbers()) std::ranges::reverse(section.loops[i]);
  }
}

std::vector<std::vector<Point3>> cap_polygons(const Section& section, const SectionPlane& plane) {
  const FlatSection flat(section, plane);
  const auto is_cavity = [](const FlatObject& object) { return object.area() < 0.0; };
  std::vector<std::vector<std::vector<Point3>>> faces(flat.objects.size());  // loops of each
  for (std::size_t k = 0; k < flat.objects.size(); ++k) {
    const FlatObject& object = flat.objects[k];
    std::size_t around = k;  // nothing
    for (std::size_t i = 0; is_cavity(object) && i < flat.objects.size(); ++i) {
      const FlatObject& other = flat.objects[i];
      if (is_cavity(other) || !object.is_within(other)) continue;
      if (around == k || other.area() < flat.objects[around].area()) around = i;
    }
    for (const std::size_t i : object.numbers()) faces[around].push_back(section.loops[i]);
  }
  std::vector<std::vector<Point3>> polygons;
  for (const auto& face : faces) {
    if (face.empty()) continue;
    polygons.push_back(joined_by_bridges<Point3>(face, [](const Point3& p) { return p; }));
  }
  return polygons;
}

}  // namespace displayfile
