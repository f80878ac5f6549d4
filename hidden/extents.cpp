#include "hidden/extents.h"

#include <cmath>
#include <limits>

namespace displayfile {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

constexpr float kLargest = std::numeric_limits<float>::max();

float rounded_down(double v) {
  if (std::abs(v) > kLargest) return v > 0.0 ? kLargest : -kInfinity;
  const auto f = static_cast<float>(v);
  return static_cast<double>(f) <= v ? f : std::nextafter(f, -kInfinity);
}
float rounded_up(double v) {
  if (std::abs(v) > kLargest) return v > 0.0 ? kInfinity : -kLargest;
  const auto f = static_cast<float>(v);
  return static_cast<double>(f) >= v ? f : std::nextafter(f, kInfinity);
}

/// 0 for what has no bounds, or holds nothing.
float twice_centre(float min, float max) {
  const float sum = min + max;
  return std::isnan(sum) ? 0.0f : sum;
}

}  // namespace

Extent Extent::nothing() {
  return {kInfinity, -kInfinity, kInfinity, -kInfinity, kInfinity, -kInfinity};
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

ExtentIndex::ExtentIndex(std::span<const Extent> extents) : order_(extents.size()) {
  struct Range {
    std::uint32_t first, end, parent;
    bool second_half;
  };
  /// A box while it is being put in order, with its centre (twice that).
  struct Placed {
    Box box;
    float x, y;
    std::uint32_t index;
  };
  std::vector<Placed> placed(extents.size());
  for (std::uint32_t i = 0; i < placed.size(); ++i) {
    const Extent& e = extents[i];
    placed[i] = {{e.x_min, e.x_max, e.y_min, e.y_max},
                 twice_centre(e.x_min, e.x_max),
                 twice_centre(e.y_min, e.y_max),
                 i};
  }
  nodes_.reserve(placed.size() / 2);
  std::vector<Range> waiting{{0, static_cast<std::uint32_t>(placed.size()), 0, false}};
  while (!waiting.empty()) {
    const auto [first, end, parent, second_half] = waiting.back();
    waiting.pop_back();
    const auto at = static_cast<std::uint32_t>(nodes_.size());
    if (second_half) nodes_[parent].right = at;
    Box all{kInfinity, -kInfinity, kInfinity, -kInfinity};
    for (std::uint32_t p = first; p < end; ++p) {
      const Box& box = placed[p].box;
      all = {std::min(all.x_min, box.x_min), std::max(all.x_max, box.x_max),
             std::min(all.y_min, box.y_min), std::max(all.y_max, box.y_max)};
    }
    nodes_.push_back({all, first, end, 0});
    if (end - first <= kLeaf) {
      // The halves are the same on every machine, but nth_element leaves their order open.
      std::sort(placed.begin() + first, placed.begin() + end,
                [](const Placed& a, const Placed& b) { return a.index < b.index; });
      leaves_.push_back(at);
      continue;
    }
    const std::uint32_t middle = first + (end - first) / 2;
    const auto begin = placed.begin();
    // Of equal centres the lower number first: the same order on every machine.
    if (all.x_max - all.x_min >= all.y_max - all.y_min) {
      std::nth_element(begin + first, begin + middle, begin + end,
                       [](const Placed& a, const Placed& b) {
                         return a.x != b.x ? a.x < b.x : a.index < b.index;
                       });
    } else {
      std::nth_element(begin + first, begin + middle, begin + end,
                       [](const Placed& a, const Placed& b) {
                         return a.y != b.y ? a.y < b.y : a.index < b.index;
                       });
    }
    waiting.push_back({middle, end, at, true});
    waiting.push_back({first, middle, at, false});
  }
  for (auto* bound : {&x_min_, &x_max_, &y_min_, &y_max_}) bound->resize(placed.size() + kLeaf);
  for (std::size_t p = 0; p < placed.size(); ++p) {
    order_[p] = placed[p].index;
    x_min_[p] = placed[p].box.x_min;
    x_max_[p] = placed[p].box.x_max;
    y_min_[p] = placed[p].box.y_min;
    y_max_[p] = placed[p].box.y_max;
  }
}

}  // namespace displayfile
