#include "hidden/lines/items_near_lines.h"

#include <algorithm>
#include <cassert>

#include "clip/base/parallel.h"
#include "clip/geometry/rectangle.h"
#include "hidden/lines/cells_of_lines.h"
#include "hidden/lines/line_table.h"

namespace displayfile {

namespace {

/// Consecutive items are often close to each other, and are rejected together if far from all
/// lines.
constexpr std::size_t kItemsTogether = 32;

/// The bounding rectangle of all corners of some items, in the projection.
Rectangle rectangle_around(const Primitives& items, std::span<const Primitives::Item> some) {
  Rectangle all = Rectangle::nothing();
  for (const Primitives::Item& item : some) {
    for (std::uint32_t k = 0; k < item.sides; ++k) {
      all.include(Point2(items.points[items.point(item.first + k)]));
    }
  }
  return all;
}

bool come_near(const CellsOfLines& cells, const Rectangle& box) {
  return !box.is_nothing() && cells.come_near(box);
}

/// For each item 1 if it comes near a line.
std::vector<std::uint8_t> near_items(const Primitives& items, const CellsOfLines& cells,
                                     int threads) {
  const std::size_t count = items.items.size();
  std::vector<std::uint8_t> near(count, 0);
  constexpr std::size_t kGroupsOfAPart = 64, kOfAPart = kGroupsOfAPart * kItemsTogether;
  in_parallel(threads, (count + kOfAPart - 1) / kOfAPart, [&](std::size_t part) {
    const std::size_t end = std::min(count, (part + 1) * kOfAPart);
    for (std::size_t first = part * kOfAPart; first < end; first += kItemsTogether) {
      const auto group = items.items.subspan(first, std::min(kItemsTogether, end - first));
      if (!come_near(cells, rectangle_around(items, group))) continue;
      for (std::size_t k = 0; k < group.size(); ++k) {
        near[first + k] = come_near(cells, rectangle_around(items, group.subspan(k, 1)));
      }
    }
  });
  return near;
}

}  // namespace

ItemsNearLines::ItemsNearLines(const Primitives& items, std::span<const LineName> names,
                               std::span<const IntersectionLine> intersections, int threads)
    : items_(items), names_(names), intersections_(intersections) {
  LineTable::require_names(items, names);
  const CellsOfLines cells(items, names, intersections);
  if (cells.are_everywhere()) return;
  std::vector<std::uint8_t> near = near_items(items, cells, threads);
  for (const LineName& name : names) near[name.item] = 1;
  for (const IntersectionLine& line : intersections) near[line.item_a] = near[line.item_b] = 1;
  take(items, near);
}

void ItemsNearLines::take(const Primitives& all, const std::vector<std::uint8_t>& near) {
  for (std::uint32_t k = 0; k < near.size(); ++k) {
    if (near[k] == 0) continue;
    number_.push_back(k);
    own_items_.push_back(all.items[k]);
    if (!all.planes.empty()) own_planes_.push_back(all.planes[k]);
    if (!all.plane_rests.empty()) own_rests_.push_back(all.plane_rests[k]);
  }
  const auto here = [&](std::uint32_t item) {
    const auto found = std::ranges::lower_bound(number_, item);
    assert(found != number_.end() && *found == item);
    return static_cast<std::uint32_t>(found - number_.begin());
  };
  for (const auto& [item, corner] : names_) own_names_.push_back({here(item), corner});
  own_intersections_.assign(intersections_.begin(), intersections_.end());
  for (IntersectionLine& line : own_intersections_) {
    line.item_a = here(line.item_a);
    line.item_b = here(line.item_b);
  }
  items_.items = own_items_;
  items_.planes = own_planes_;
  items_.plane_rests = own_rests_;
  items_.surfaces = {};
  items_.numbers = number_;
  names_ = own_names_;
  intersections_ = own_intersections_;
}

SeenLines ItemsNearLines::by_all_items(SeenLines seen) const {
  if (number_.empty()) return seen;
  for (VisiblePiece& piece : seen.pieces) piece.item = number_[piece.item];
  return seen;
}

}  // namespace displayfile
