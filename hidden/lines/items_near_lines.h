#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hidden/lines/visible_lines.h"
#include "hidden/primitives.h"

namespace displayfile {

/// The items near some lines, in the projection: with few lines, most items hide nothing, and no
/// tables are made for them. With many lines, all items.
class ItemsNearLines {
 public:
  /// Names are sorted and unique. Throws Error for one that names no line. The arguments must
  /// outlive this.
  ItemsNearLines(const Primitives& items, std::span<const LineName> names,
                 std::span<const IntersectionLine> intersections, int threads);

  /// The near items, with the same points, including the lines' own items.
  const Primitives& items() const { return items_; }
  /// The lines, by their items' numbers here.
  std::span<const LineName> names() const { return names_; }
  std::span<const IntersectionLine> intersections() const { return intersections_; }

  /// The visible parts with the items' original indices.
  SeenLines by_all_items(SeenLines seen) const;

 private:
  void take(const Primitives& all, const std::vector<std::uint8_t>& near);

  Primitives items_;
  std::span<const LineName> names_;
  std::span<const IntersectionLine> intersections_;
  // Empty if all items are near.
  std::vector<std::uint32_t> number_;  // original index of each item
  std::vector<Primitives::Item> own_items_;
  std::vector<Primitives::PlanePoints> own_planes_;
  std::vector<Point3> own_rests_;
  std::vector<LineName> own_names_;
  std::vector<IntersectionLine> own_intersections_;
};

}  // namespace displayfile
