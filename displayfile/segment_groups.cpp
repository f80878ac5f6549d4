#include "displayfile/segment_groups.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "hidden/extents.h"

namespace displayfile {

namespace {

/// Takes in every point that is drawn.
struct ExtentVisitor {
  Extent& extent;
  void fill(const FillStyle&) {}
  void line_style(const LineStyle&) {}
  void pick(std::int32_t) {}
  void move(const Point3& p) { extent.include(p); }
  void line(const Point3& p) { extent.include(p); }
  void polygon(std::span<const Point3> vertices, std::span<const std::int32_t>) {
    for (const Point3& p : vertices) extent.include(p);
  }
};

/// Sets that are joined, each with its smallest member as its name.
class Sets {
 public:
  explicit Sets(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }
  std::uint32_t of(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t i, std::uint32_t j) {
    const std::uint32_t a = of(i), b = of(j);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace

std::vector<SegmentGroup> overlapping_groups(std::span<const Segment* const> segments) {
  std::vector<Extent> extents(segments.size(), Extent::nothing());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    segments[i]->walk_entered_drawn(ExtentVisitor{extents[i]});
  }
  const ExtentIndex index(extents);
  Sets sets(segments.size());
  index.pairs(0, index.leaves(), [&](std::uint32_t p, std::uint32_t q) {
    sets.join(index.order()[p], index.order()[q]);
  });
  std::vector<SegmentGroup> groups;
  std::vector<std::size_t> group_of(segments.size());
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    const std::uint32_t first = sets.of(i);
    if (first == i) {
      group_of[i] = groups.size();
      groups.emplace_back();
    }
    groups[group_of[first]].push_back(segments[i]);
  }
  return groups;
}

}  // namespace displayfile
