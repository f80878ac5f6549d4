#include "hidden/boxes/extents.h"

#include <bit>
#include <cmath>
#include <limits>

#include "hidden/boxes/build_box_tree.h"
#include "hidden/boxes/space_tree.h"

namespace displayfile {

namespace {

constexpr float kUnbounded = std::numeric_limits<float>::infinity();

constexpr float kLargest = std::numeric_limits<float>::max();

/// The next float toward positive infinity, or toward negative infinity; the argument is finite.
float stepped_up(float f) {
  if (f == 0.0F) return std::numeric_limits<float>::denorm_min();
  const auto bits = std::bit_cast<std::uint32_t>(f);
  return std::bit_cast<float>(f < 0.0F ? bits - 1 : bits + 1);
}
float stepped_down(float f) { return -stepped_up(-f); }

float rounded_up(double v) {
  if (std::abs(v) > kLargest) return v > 0.0 ? kUnbounded : -kLargest;
  const auto f = static_cast<float>(v);
  return static_cast<double>(f) >= v ? f : stepped_up(f);
}

}  // namespace

float rounded_down(double v) {
  if (std::abs(v) > kLargest) return v > 0.0 ? kLargest : -kUnbounded;
  const auto f = static_cast<float>(v);
  return static_cast<double>(f) <= v ? f : stepped_down(f);
}

Extent Extent::nothing() {
  return {kUnbounded, -kUnbounded, kUnbounded, -kUnbounded, kUnbounded, -kUnbounded};
}

Extent Extent::between(const Point3& low, const Point3& high) {
  return {rounded_down(low.x), rounded_up(high.x),  rounded_down(low.y),
          rounded_up(high.y),  rounded_down(low.z), rounded_up(high.z)};
}

void Extent::include(const Point3& p, double radius) {
  const double more = 2.0 * radius;  // the sums below are rounded
  x_min = std::min(x_min, rounded_down(p.x - more));
  x_max = std::max(x_max, rounded_up(p.x + more));
  y_min = std::min(y_min, rounded_down(p.y - more));
  y_max = std::max(y_max, rounded_up(p.y + more));
  z_min = std::min(z_min, rounded_down(p.z - more));
  z_max = std::max(z_max, rounded_up(p.z + more));
}

void Extent::include(const Extent& o) {
  x_min = std::min(x_min, o.x_min);
  x_max = std::max(x_max, o.x_max);
  y_min = std::min(y_min, o.y_min);
  y_max = std::max(y_max, o.y_max);
  z_min = std::min(z_min, o.z_min);
  z_max = std::max(z_max, o.z_max);
}

FlatBox FlatBox::nothing() { return {kUnbounded, -kUnbounded, kUnbounded, -kUnbounded}; }

template <>
void ExtentTree::build(std::size_t items, const std::function<FlatBox(Item)>& box_of, int threads) {
  build_by<Halves<FlatBox>>(items, box_of, threads);
}

ExtentTree extent_tree(std::span<const Extent> extents, int threads) {
  ExtentTree tree;
  const auto box_of = [&](ExtentTree::Item i) { return FlatBox::of(extents[i]); };
  tree.build(extents.size(), box_of, threads);
  return tree;
}

template <>
void SpaceTree::build(std::size_t items, const std::function<Bounds(Item)>& box_of, int threads) {
  build_by<Halves<Bounds>>(items, box_of, threads);
}

}  // namespace displayfile
