#include "displayfile/segments/sorted_display_file.h"

#include <cstdint>

#include "hidden/boxes/extents.h"
#include "hidden/disjoint_sets.h"

namespace displayfile {

namespace {

/// Includes every drawn point in the extent.
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

}  // namespace

std::vector<SegmentGroup> overlapping_groups(std::span<const Segment* const> segments) {
  if (segments.size() == 1) return {{segments[0]}};
  std::vector<Extent> extents(segments.size(), Extent::nothing());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    segments[i]->walk_entered_drawn(ExtentVisitor{extents[i]});
  }
  const ExtentTree tree = extent_tree(extents, 1);
  DisjointSets sets(segments.size());
  tree.pairs(0, tree.leaves(), [&](std::uint32_t p, std::uint32_t q) {
    sets.join(tree.order()[p], tree.order()[q]);
  });
  std::vector<SegmentGroup> groups;
  std::vector<std::size_t> group_of(segments.size());
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    const std::uint32_t first = sets.name(i);
    if (first == i) {
      group_of[i] = groups.size();
      groups.emplace_back();
    }
    groups[group_of[first]].push_back(segments[i]);
  }
  return groups;
}

}  // namespace displayfile
