#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hidden/lines/visible_lines.h"
#include "hidden/primitives.h"

namespace displayfile {

/// The items that come near some lines, in the projection: where lines are few, most items
/// hide nothing of any, and no tables are made for them. Otherwise all.
class ItemsNearLines {
 public:
  /// The names are in order, each once. Throws Error for one that names no line. What is given must
  /// outlive this.
  ItemsNearLines(const Primitives& items, std::span<const LineName> names,
                 std::span<const IntersectionLine> intersections, int threads);

  /// Those near: the same points, and the items that the lines are of among them.
  const Primitives& items() const { return items_; }
  /// The lines, by their items' numbers here.
  std::span<const LineName> names() const { return names_; }
  std::span<const IntersectionLine> intersections() const { return intersections_; }

  /// What is seen of the lines, by the numbers that the items had.
  SeenLines by_all_items(SeenLines seen) const;

 private:
  void take(const Primitives& all, const std::vector<std::uint8_t>& near);

  Primitives items_;
  std::span<const LineName> names_;
  std::span<const IntersectionLine> intersections_;
  // Empty where all items are near.
  std::vector<std::uint32_t> number_;  // that an item had
  std::vector<Primitives::Item> own_items_;
  std::vector<Primitives::PlanePoints> own_planes_;
  std::vector<Point3> own_rests_;
  std::vector<LineName> own_names_;
  std::vector<IntersectionLine> own_intersections_;
};

}  // namespace displayfile
