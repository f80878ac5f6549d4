#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "clip/base/budgeted_work.h"
#include "clip/base/work_budget.h"
#include "hidden/lines/cell_grid.h"
#include "hidden/lines/cell_walk.h"
#include "hidden/lines/side_table.h"
#include "hidden/map/map_edges.h"
#include "hidden/map/seen_along_line.h"

namespace displayfile {

/// Finds the edges of a map that lie on a line, line by line: where the item visible on its left
/// differs from that on its right, and one of the two is an owner of the line, a polygon with the
/// line as a side; or both are, for the line along which two polygons intersect.
///
/// An edge between two polygons lies on a side of one of them, or on their line of intersection.
/// Where several of their sides coincide, it belongs to the side with the lowest points.
template <class Carrier>
class EdgesAlongLine {
  using Seen = SeenAlongLine<Carrier>;
  using Place = typename Carrier::Place;
  using Stretch = typename Seen::Stretch;

 public:
  explicit EdgesAlongLine(const MapTable& map)
      : map_(map),
        seen_(map.lines, map.sides, Carrier(map.lines, map.sides)),
        looked_at_(map.lines.items(), 0) {}

  Carrier& line() { return seen_.line(); }
  Seen& seen() { return seen_; }

  /// The points of a side, as in the side table.
  struct SidePoints {
    std::uint32_t low, high;
    auto operator<=>(const SidePoints&) const = default;
  };
  static constexpr SidePoints kNoSide{0xffffffffu, 0xffffffffu};

  /// Must be called when the carrier is set to the line, before polygons are added; `own` are the
  /// points of its side.
  void begin(std::span<const std::uint32_t> owners, const SidePoints& own) {
    owners_ = owners;
    own_ = own;
    touches_.clear();
    claims_.clear();
    if (++number_ == 0) {  // all numbers were used
      std::ranges::fill(looked_at_, 0);
      number_ = 1;
    }
  }
  void add(std::uint32_t item) {
    steps_.step();
    looked_at_[item] = number_;
    if (look_at(item)) update();
  }
  /// Marks the polygon as added.
  void note_added(std::uint32_t item) {
    looked_at_[item] = number_;
    note_sides(item);
  }

  /// Adds the polygons that may be visible beside the line, and the edges.
  void find(const Extent& box, std::vector<MapEdge>& edges) {
    update();
    const CellGrid& grid = map_.grid;
    const Point2 from = grid.layout().in_cells(Point2(line().from()));
    const Point2 to = grid.layout().in_cells(Point2(line().to()));
    const auto levels = grid.levels();
    for (std::size_t k = levels.size(); k-- > 0 && !is_hidden_;) {
      const CellGrid::Level& level = levels[k];
      if (level.entries.empty()) continue;
      const double scale = std::ldexp(1.0, -static_cast<int>(k));
      walk_cells(level, from * scale, to * scale, [&](const CellsOfStretch& cells) {
        for (std::uint32_t j = cells.low; j <= cells.high && !is_hidden_; ++j) {
          add_those_in(level, cells.cell(j), box);
        }
        return !is_hidden_;
      });
    }
    if (!is_hidden_) add_edges(edges);
  }

 private:
  void add_those_in(const CellGrid::Level& level, std::size_t cell, const Extent& box) {
    const float behind =
        level.behind.empty() ? -std::numeric_limits<float>::infinity() : level.behind[cell];
    for (const CellGrid::Entry& entry : level.in_cell(cell)) {
      if (entry.z_max < least_ || entry.z_max < behind) break;  // and so are those after it
      if (!entry.meets(box) || looked_at_[entry.polygon] == number_) continue;
      add(entry.polygon);
      if (is_hidden_) return;
    }
  }

  bool look_at(std::uint32_t item) {
    return seen_.add(
        item, [&](const Place& at) { note_touch(at); },
        [&](std::uint32_t before, std::uint32_t corner) { note_side(item, before, corner); });
  }
  void note_touch(const Place& at) {
    if (line().compare(line().start(), at) < 0 && line().compare(at, line().end()) < 0) {
      touches_.push_back(at);
    }
  }
  /// A polygon whose boundary crosses itself on the line may have no end there, but has one beside
  /// it.
  void note_sides(std::uint32_t item) {
    const std::uint32_t sides = map_.lines.sides(item);
    std::uint32_t before = sides - 1;
    int side_before = line().side(map_.lines.corner(item, before));
    for (std::uint32_t k = 0; k < sides; before = k++) {
      const int side = line().side(map_.lines.corner(item, k));
      if (side == 0) note_touch(line().at_point(vertex(item, k)));
      if (side == 0 && side_before == 0) note_side(item, before, k);
      if (side * side_before < 0)
        note_touch(line().crossing(vertex(item, before), vertex(item, k)));
      side_before = side;
    }
  }
  std::uint32_t vertex(std::uint32_t item, std::uint32_t corner) const {
    return map_.sides.vertex(map_.lines.corner_point(item, corner));
  }

  /// Edges on a coincident side of the polygon belong to the lower side.
  void note_side(std::uint32_t item, std::uint32_t before, std::uint32_t corner) {
    const std::uint32_t p = vertex(item, before), q = vertex(item, corner);
    if (!(SidePoints{std::min(p, q), std::max(p, q)} < own_)) return;
    Place from = line().at_point(p), to = line().at_point(q);
    const int order = line().compare(from, to);
    if (order > 0) std::swap(from, to);
    if (order != 0) claims_.push_back({item, from, to});
  }

  bool is_owner(std::uint32_t item) const {
    return std::ranges::find(owners_, item) != owners_.end();
  }

  /// An edge on a side has one owner beside it, an edge on an intersection both.
  bool is_of_owners(bool left, bool right) const {
    return own_ == kNoSide ? left && right : left || right;
  }
  bool is_of_owners(std::uint32_t left, std::uint32_t right) const {
    return is_of_owners(is_owner(left), is_owner(right));
  }

  /// Updates the visibility of the owners, and the minimum depth of visible polygons.
  void update() {
    std::array<bool, 2> any{};
    float least = std::numeric_limits<float>::infinity();
    for (const auto side : {Seen::kLeft, Seen::kRight}) {
      for (const Stretch& stretch : seen_.seen(side)) {
        const std::uint32_t item = seen_.item(stretch);
        if (item == Seen::kNothing) {
          least = -std::numeric_limits<float>::infinity();
          continue;
        }
        any[side] = any[side] || is_owner(item);
        least = std::min(least, map_.lines.extent(item).z_min);
      }
    }
    is_hidden_ = !is_of_owners(any[Seen::kLeft], any[Seen::kRight]);
    least_ = least;
  }

  void add_edges(std::vector<MapEdge>& edges) {
    const auto &left = seen_.seen(Seen::kLeft), &right = seen_.seen(Seen::kRight);
    Place from = line().start();
    std::size_t i = 0, j = 0;
    while (i < left.size() && j < right.size()) {
      const int order = line().compare(left[i].to, right[j].to);
      const Place to = order < 0 ? left[i].to : right[j].to;
      const std::uint32_t on_left = seen_.item(left[i]), on_right = seen_.item(right[j]);
      if (on_left != on_right && is_of_owners(on_left, on_right)) {
        add_edges(left[i], right[j], from, to, edges);
      }
      from = to;
      if (order <= 0) ++i;
      if (order >= 0) ++j;
    }
    assert(i == left.size() && j == right.size());  // both reach the line's end
  }

  /// Ends edges where another's end touches them.
  void add_edges(const Stretch& left, const Stretch& right, const Place& from, const Place& to,
                 std::vector<MapEdge>& edges) {
    const std::uint32_t on_left = seen_.item(left), on_right = seen_.item(right);
    const auto is_within = [&](const Place& at) {
      return line().compare(from, at) < 0 && line().compare(at, to) < 0;
    };
    breaks_.clear();
    for (const Place& at : touches_) {
      if (is_within(at)) breaks_.push_back(at);
    }
    for (const auto& [at, face] : seen_.ends()) {
      if (is_within(at) && (seen_.touches(left, face, at) || seen_.touches(right, face, at))) {
        breaks_.push_back(at);
      }
    }
    const auto concerns = [&](const Claim& claim) {
      return (claim.item == on_left || claim.item == on_right) &&
             line().compare(claim.from, to) < 0 && line().compare(from, claim.to) < 0;
    };
    bool claimed = false;
    for (const Claim& claim : claims_) {
      if (!concerns(claim)) continue;
      claimed = true;
      if (is_within(claim.from)) breaks_.push_back(claim.from);
      if (is_within(claim.to)) breaks_.push_back(claim.to);
    }
    breaks_.push_back(to);
    if (breaks_.size() > 1) {
      std::ranges::sort(breaks_,
                        [&](const Place& p, const Place& q) { return line().compare(p, q) < 0; });
    }
    Place start = from;
    bool goes_on = false;
    for (const Place& end : breaks_) {
      if (line().compare(start, end) >= 0) continue;
      const bool is_others = claimed && std::ranges::any_of(claims_, [&](const Claim& claim) {
                               return concerns(claim) && line().compare(claim.from, start) <= 0 &&
                                      line().compare(end, claim.to) <= 0;
                             });
      if (!is_others) {
        edges.push_back({start.what, end.what, rounded(map_.lines, start.what),
                         rounded(map_.lines, end.what), on_left, on_right, goes_on});
      }
      goes_on = !is_others;
      start = end;
    }
  }

  struct Claim {
    std::uint32_t item;
    Place from, to;
  };

  const MapTable& map_;
  Seen seen_;
  std::span<const std::uint32_t> owners_;
  SidePoints own_ = kNoSide;
  bool is_hidden_ = false;  // no owner is visible
  float least_ = 0.0F;      // nothing visible is behind this depth
  std::vector<Place> touches_;
  std::vector<Claim> claims_;
  std::vector<Place> breaks_;
  std::vector<std::uint32_t> looked_at_;  // per polygon, the last line for which it was added
  std::uint32_t number_ = 0;              // of the line
  WorkSteps steps_;
};

}  // namespace displayfile
