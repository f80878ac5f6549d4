#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <vector>

#include "clip/base/budgeted_work.h"
#include "clip/base/work_budget.h"
#include "hidden/sort/polygon_table.h"
#include "hidden/sort/touching_vertices.h"
#include "hidden/sort/vertex_table.h"

namespace displayfile {

/// A polygon's position relative to a plane.
enum class PlaneSide : std::uint8_t { on, front, back, both };

/// Null observer; compiles to nothing.
struct Unobserved {
  static void put(bool /*in_e*/, const SideBuffer::Side& /*side*/) {}
};

/// COMPARE-POLYS with its cleanup routines (algorithms 9.10 to 9.12, 9.14, 9.15) at either
/// precision. Polygons may be concave or self-crossing: the part on one side of the plane is one
/// polygon by the even-odd rule, whose cut sides run along the plane and may overlap each other. An
/// Observer is notified of each side that a cut puts into the E buffer or the D buffer.
template <class Policy, class Observer = Unobserved>
class ComparePolys {
 public:
  using Index = PolygonTable::Index;

  ComparePolys(PolygonTable& table, VertexTable<Policy>& vertices, Observer observer = {})
      : table_(table), vertices_(vertices), observer_(std::move(observer)) {}

  /// The side of the plane on which the polygon lies. Keeps each vertex' sign for split.
  PlaneSide compare(Index test, std::uint32_t plane) {
    ++comparisons_;
    signs_.resize(table_[test].sides);
    return compare(test, plane, [this](std::uint32_t i, int sign) {
      signs_[i] = static_cast<std::int8_t>(sign);
    });
  }
  /// The side of the plane on which the polygon lies. Keeps no signs, so several threads may call
  /// it at once.
  PlaneSide where(Index test, std::uint32_t plane) const {
    return compare(test, plane, [](std::uint32_t, int) {});
  }

  struct Halves {
    Index front, back;
  };
  /// Cuts the polygon compared last, which lies on both sides: TEST becomes the half on its first
  /// side, a new entry the other. Throws Error if the table may not grow.
  Halves split(Index test, std::uint32_t plane) {
    if (table_.entries.size() >= table_.most_entries) {
      const auto& [what, instead] = work_in_force().done;
      throw LimitReached((what != nullptr ? what : "the sort of hidden surfaces") +
                         (" cuts polygons into more than " + std::to_string(table_.most_entries)) +
                         " pieces: expected " + (instead != nullptr ? instead : "fewer polygons") +
                         ", or a higher limit of pieces");
    }
    ++cuts_;
    steps_.step();
    if (cuts_ % kCutsBetweenCounts == 0) {
      require_bytes([this] {
        return table_.entries.capacity() * sizeof(PolygonTable::Entry) + table_.d.bytes() +
               vertices_.bytes();
      });
    }
    assert(lies_on_both_sides(table_[test].sides));
    const Index split_v = table_.d.free();
    table_.e.clear();
    const int first_side =
        table_[test].sides == 2 ? cut_line(test, plane) : cut_polygon(test, plane);
    const Index other = set_up_split_poly(test, split_v);
    adjust_original_poly(test);
    return first_side > 0 ? Halves{test, other} : Halves{other, test};
  }

  /// Undoes the count of a trial split.
  void take_back_split() { --cuts_; }

  std::uint64_t comparisons() const { return comparisons_; }
  std::uint64_t cuts() const { return cuts_; }

 private:
  using Side = SideBuffer::Side;

  template <class Keep>
  PlaneSide compare(Index test, std::uint32_t plane, const Keep& keep) const {
    const auto& entry = table_[test];
    if (vertices_.in_one_plane(entry.plane, plane)) return PlaneSide::on;
    if (vertices_.touching() > 0.0) return compare_touching(test, plane, keep);
    Signs signs;
    for (std::uint32_t i = 0; i < entry.sides; ++i) {
      const int sign = vertices_.side(table_.d.vertex(entry.start + i), plane);
      keep(i, sign);
      signs.note(sign);
    }
    return signs.side();
  }
  struct Signs {
    bool front = false, back = false;
    void note(int sign) {
      front |= sign > 0;
      back |= sign < 0;
    }
    PlaneSide side() const {
      if (front && back) return PlaneSide::both;
      return front ? PlaneSide::front : (back ? PlaneSide::back : PlaneSide::on);
    }
  };

  /// The same where viewing has moved vertices off their planes: vertices near the plane count as
  /// on it if the polygon extends far from it, and both ends of a line do
  /// (hidden/sort/touching_vertices.md).
  template <class Keep>
  PlaneSide compare_touching(Index test, std::uint32_t number, const Keep& keep) const {
    const auto& entry = table_[test];
    const Plane& plane = vertices_.plane(number);
    Signs signs;
    double farthest = 0.0;
    std::uint32_t near = 0;
    for (std::uint32_t i = 0; i < entry.sides; ++i) {
      const auto [size, sign, is_near] = vertices_.value(table_.d.vertex(entry.start + i), number);
      if (size > farthest) farthest = size;
      near += is_near ? 1 : 0;
      keep(i, sign);
      signs.note(sign);
    }
    const bool goes_far = farthest > plane.reach * vertices_.touching() * kFarFromPlane;
    if (near == 0 || goes_far || (near == 2 && entry.sides == 2)) return signs.side();
    for (std::uint32_t i = 0; i < entry.sides; ++i) {
      const std::uint32_t v = table_.d.vertex(entry.start + i);
      if (!vertices_.value(v, number).is_near) continue;
      const int sign = vertices_.side(v, number);
      keep(i, sign);
      signs.note(sign);
    }
    return signs.side();
  }

  /// Decides by the kept signs of the polygon compared last, with this many sides.
  bool lies_on_both_sides(std::uint32_t sides) const {
    Signs signs;
    for (const std::int8_t sign : signs_) signs.note(sign);
    return signs_.size() == sides && signs.side() == PlaneSide::both;
  }

  /// The half on the side of the first vertex off the plane goes to the E buffer, the other to
  /// the D buffer. Where the boundary crosses, the point goes to both: to the half that it leaves
  /// at the end of the side that is cut, to the other at the end of a side along the plane. (A
  /// clipper keeps one half and has its points; this is the textbook's listing, keeps both, and its
  /// points are defined, not computed.)
  int cut_polygon(Index test, std::uint32_t plane) {
    const auto [start, sides, item, own, front, back, on, whole] = table_[test];
    std::uint32_t cross_v = 0;
    while (signs_[cross_v] == 0) ++cross_v;
    const int first_side = signs_[cross_v];
    int side = first_side;
    std::uint32_t last = cross_v;
    for (std::uint32_t k = 1; k <= sides; ++k) {
      const std::uint32_t j = cross_v + k < sides ? cross_v + k : cross_v + k - sides;
      const Side here = table_.d[start + j];
      if (signs_[j] == -side) {
        const std::uint32_t from = table_.d.vertex(start + last);
        std::uint32_t crossing = from;  // a vertex on the plane: it is in this half already
        if (signs_[last] != 0) {
          crossing = vertices_.cut(from, here.vertex, here.line, own, plane);
          put(side == first_side, {crossing, here.line, here.visible});
        }
        side = -side;
        put(side == first_side, {crossing, SideLine::cut_by(plane), 0});
      }
      put(side == first_side, here);
      last = j;
    }
    return first_side;
  }

  /// A line has two halves of two points, each drawn at the second.
  int cut_line(Index test, std::uint32_t plane) {
    const auto [start, sides, item, own, front, back, on, whole] = table_[test];
    const Side a = table_.d[start], b = table_.d[start + 1];
    const std::uint32_t crossing = vertices_.cut(a.vertex, b.vertex, b.line, own, plane);
    put(true, a);
    put(true, {crossing, b.line, b.visible});
    put(false, {crossing, b.line, 0});
    put(false, b);
    return signs_[0];
  }

  void put(bool in_e, const Side& side) {
    observer_.put(in_e, side);
    if (in_e) {
      table_.e.put(side);
    } else {
      table_.d.put(side);
    }
  }

  /// Algorithm 9.11: the table's entry for the half that was put at the end of the D buffer.
  Index set_up_split_poly(Index test, Index split_v) {
    const Index other = table_.free();
    table_.entries.push_back(
        {split_v, table_.d.free() - split_v, table_[test].item, table_[test].plane});
    table_[other].whole = false;
    return other;
  }

  /// Algorithm 9.12: the half in the E buffer takes the polygon's place in the D buffer if it has
  /// room there, and a new one if not.
  void adjust_original_poly(Index test) {
    auto& entry = table_[test];
    const std::uint32_t sides = table_.e.free();
    assert(sides >= 3 || entry.sides == 2);
    if (sides <= entry.sides) {
      for (std::uint32_t j = 0; j < sides; ++j) table_.d.replace(entry.start + j, table_.e[j]);
    } else {
      entry.start = table_.d.free();
      for (std::uint32_t j = 0; j < sides; ++j) table_.d.put(table_.e[j]);
    }
    entry.sides = sides;
    entry.whole = false;
  }

  PolygonTable& table_;
  VertexTable<Policy>& vertices_;
  std::vector<std::int8_t> signs_;
  static constexpr std::uint64_t kCutsBetweenCounts = 4096;  // of bytes
  std::uint64_t comparisons_ = 0, cuts_ = 0;
  WorkSteps steps_;
  [[no_unique_address]] Observer observer_;
};

}  // namespace displayfile
