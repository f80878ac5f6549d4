#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "displayfile/segments/viewed_scene.h"
#include "interp/scan/scan_edge.h"
#include "interp/visibility/fill_depths.h"

namespace displayfile {

/// The problem book's polygon list, by the first row that a polygon crosses; polygons that cross no
/// row are omitted.
class PolygonList {
 public:
  using Fill = ViewedScene::Fill;
  struct Entry {
    Fill fill;
    int last_row;
  };

  PolygonList() = default;
  PolygonList(const ViewedScene& scene, int height);

  /// The polygons whose first row this is, in order of entry.
  std::span<const Entry> first_in(int row) const { return between(row, row + 1); }
  std::span<const Entry> first_below(int row) const { return between(0, row); }

 private:
  std::span<const Entry> between(int row, int end) const {
    const std::uint32_t first = begin_[static_cast<std::size_t>(row)];
    return std::span(entries_).subspan(first, begin_[static_cast<std::size_t>(end)] - first);
  }

  std::vector<Entry> entries_;
  std::vector<std::uint32_t> begin_;  // of each row's entries, and the end
};

/// The active edge list of successive scan lines, by polygon: the runs of whole pixels in which
/// each polygon is IN (interp/visibility/scan_line.md). For one thread. It uses the same edges
/// (ScanEdge) as ScanConverter, which handles one polygon at a time and does not distinguish
/// polygons. ScanLineZ has its own list (interp/visibility/scan_line_z.cpp), since it needs a row's
/// polygons in order of entry and memory independent of the picture's height: here they are
/// unordered, and the list of polygons and that of resting ones have an entry per row.
class ActivePolygons {
 public:
  using Fill = ViewedScene::Fill;
  using Index = std::uint32_t;  ///< of an active polygon, while its row is processed

  /// A polygon of the list, with its data for every row.
  struct Polygon {
    PixelDepth depth;
    double error;  ///< of the depth
    Fill fill;
    int last_row;
    int stands_until;                ///< the row up to which no side enters or leaves
    int rests_until;                 ///< less than the row: it does not rest
    int stands_from, may_rest_from;  ///< the row since which its sides stand; see may_not_rest()
    std::uint32_t live, next, end;   ///< of its sides: active ones are live <= k < next
  };

  /// Starts with this row.
  ActivePolygons(const ViewedScene& scene, const FillDepths& depths, const PictureSize& size,
                 const PolygonList& list, int row_begin);

  /// Advances the list to the next row and calls in(index, first, end) for the columns first <= i <
  /// end in which a polygon is IN; empty runs are omitted.
  template <class In>
  void next_row(In&& in);

  const Polygon& operator[](Index polygon) const { return polygons_[polygon]; }

  /// A row, and where a polygon's two sides cross it: in pixel units, off by at most `error`.
  struct Width {
    int row;
    double left, right, error;
  };
  /// If the inside polygon is certain to lie within the other from this row to a later one, as far
  /// as they are on the picture: its width in this row and in the last such row that is examined.
  /// Both must be IN once in this row, the inside one within the other.
  std::optional<std::array<Width, 2>> stays_within(Index inside, Index other) const;

  /// The polygon cannot rest now: it is checked again after as many rows as its sides have been
  /// active.
  void may_not_rest(Index polygon) {
    Polygon& p = polygons_[polygon];
    p.may_rest_from = row_ + 1 + (row_ - p.stands_from);
  }
  /// The polygon need not be reported again up to this row.
  void rest(Index polygon, int last_row) { polygons_[polygon].rests_until = last_row; }

 private:
  struct Resting {
    PolygonList::Entry entry;
    std::uint32_t next;
  };
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  void enter_polygons();
  void enter(const PolygonList::Entry& entry);
  void make_edge_table(Fill fill);
  void update_active_edges(Polygon& polygon);
  bool let_go_or_rest(Index k);
  void remove(Index k);
  void compact_sides();
  struct Sides {
    const ScanEdge *left, *right;
  };
  std::optional<Sides> sides_until(const Polygon& polygon, int last) const;

  const ViewedScene* scene_;
  const FillDepths* depths_;
  const PolygonList* list_;
  PictureSize size_;
  int row_, row_begin_;
  std::vector<Polygon> polygons_;
  std::vector<ScanEdge> sides_;
  std::size_t sides_left_ = 0;  // of polygons that are gone
  std::vector<Resting> resting_;
  std::vector<std::uint32_t> wakes_;  // by row: the first of those that rest until then
  std::vector<int> columns_;
};

template <class In>
void ActivePolygons::next_row(In&& in) {
  ++row_;
  enter_polygons();
  for (Index k = 0; k < polygons_.size();) {
    Polygon& polygon = polygons_[k];
    if (polygon.stands_until < row_ || polygon.rests_until >= row_) [[unlikely]] {
      if (let_go_or_rest(k)) continue;
    }
    const std::uint32_t live = polygon.live;
    if (polygon.next - live == 2) [[likely]] {
      const int a = sides_[live].column(row_, size_), b = sides_[live + 1].column(row_, size_);
      if (a != b) in(k, std::min(a, b), std::max(a, b));
    } else {
      columns_.clear();
      for (std::uint32_t side = live; side < polygon.next; ++side) {
        columns_.push_back(sides_[side].column(row_, size_));
      }
      std::ranges::sort(columns_);
      for (std::size_t i = 0; i + 1 < columns_.size(); i += 2) {
        // A run that ends where the next begins is merged with it.
        const int first = columns_[i];
        while (i + 3 < columns_.size() && columns_[i + 1] == columns_[i + 2]) i += 2;
        if (first < columns_[i + 1]) in(k, first, columns_[i + 1]);
      }
    }
    ++k;
  }
}

}  // namespace displayfile
