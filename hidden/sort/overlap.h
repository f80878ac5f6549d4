#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "hidden/sort/vertex_table.h"
#include "hidden/triangles/convex_turning.h"

namespace displayfile {

/// A polygon, a line or a piece of one in the projection.
struct Outline {
  std::span<const std::uint32_t> vertices;
  int turning;  ///< 1 counterclockwise and convex, -1 clockwise and convex, 0 anything else
};

/// The orientation of the vertices (Outline::turning), decided by the table's policy.
template <class Policy>
int convex_turning(const VertexTable<Policy>& table, std::span<const std::uint32_t> v) {
  return convex_turning(
      v.size(),
      [&](std::size_t i, std::size_t j, std::size_t k) { return table.turn(v[i], v[j], v[k]); },
      [&](std::size_t i, std::size_t j) { return table.direction(v[i], v[j]); });
}

/// The outermost vertices in about eight directions of a polygon with many vertices; all vertices
/// of one with few. A line with parts of the polygon on both sides usually has some of these
/// vertices on both sides.
class OutermostVertices {
 public:
  static constexpr std::size_t kFew = 16;

  /// The vertices must outlive it.
  template <class Policy>
  OutermostVertices(const VertexTable<Policy>& table, std::span<const std::uint32_t> vertices)
      : all_(vertices) {
    if (are_all()) return;
    std::array<double, kDirections> farthest;
    farthest.fill(-std::numeric_limits<double>::infinity());
    outermost_.fill(vertices.front());
    for (const std::uint32_t v : vertices) {
      const Point3 p = table.near(v).p;
      const std::array out{p.x, p.y, p.x + p.y, p.x - p.y};
      for (std::size_t k = 0; k < kDirections; ++k) {
        const double way = k % 2 == 0 ? out[k / 2] : -out[k / 2];
        if (way <= farthest[k]) continue;
        farthest[k] = way;
        outermost_[k] = v;
      }
    }
  }
  std::span<const std::uint32_t> vertices() const {
    return are_all() ? all_ : std::span<const std::uint32_t>(outermost_);
  }
  bool are_all() const { return all_.size() < kFew; }

 private:
  static constexpr std::size_t kDirections = 8;
  std::array<std::uint32_t, kDirections> outermost_{};
  std::span<const std::uint32_t> all_;
};

/// A side that has all of its polygon on one side of its line, or on the line (inside is 0).
struct HullSide {
  std::uint32_t from, to;
  int inside;
};

/// An outline to be compared with many others: the data for comparisons are computed once.
class ComparedOutline {
 public:
  /// Finds the outermost vertices. The outline's vertices must outlive it.
  template <class Policy>
  ComparedOutline(const VertexTable<Policy>& table, const Outline& outline)
      : outline_(outline), outermost_(table, outline.vertices) {}

  /// Also finds the sides on the convex hull: worthwhile for comparisons with several others.
  template <class Policy>
  void find_hull_sides(const VertexTable<Policy>& table) {
    assert(!hull_);
    auto& sides = hull_.emplace();
    std::uint32_t from = outline_.vertices.back();
    for (const std::uint32_t to : outline_.vertices) {
      const auto inside = inside_of(table, from, to, [](int) { return true; });
      if (inside) sides.push_back({from, to, *inside});
      from = to;
    }
  }

  const Outline& outline() const { return outline_; }
  const OutermostVertices& outermost() const { return outermost_; }
  /// Nothing unless find_hull_sides was called.
  const std::optional<std::vector<HullSide>>& hull() const { return hull_; }

  /// The side of the line on which all of the polygon is; 0 if all of it is on the line; nothing if
  /// it has points on both sides, or if `matters` returns false for the side of the outermost
  /// vertices.
  template <class Policy, class Matters>
  std::optional<int> inside_of(const VertexTable<Policy>& table, std::uint32_t from,
                               std::uint32_t to, const Matters& matters) const {
    int inside = 0;
    const auto have_one_side = [&](std::span<const std::uint32_t> vertices) {
      for (const std::uint32_t v : vertices) {
        const int turn = table.turn(from, to, v);
        if (turn == 0) continue;
        if (inside == -turn) return false;
        inside = turn;
      }
      return true;
    };
    if (!have_one_side(outermost_.vertices())) return {};
    if (inside != 0 && !matters(inside)) return {};
    if (!outermost_.are_all() && !have_one_side(outline_.vertices)) return {};
    return inside;
  }

  /// True if no vertex is on the side `inside` of the line. `strictly`: nor on the line.
  template <class Policy>
  bool is_beyond(const VertexTable<Policy>& table, const HullSide& side, bool strictly) const {
    return outermost_are_beyond(table, side, strictly) &&
           (outermost_.are_all() || are_beyond(table, outline_.vertices, side, strictly));
  }
  /// The same for the outermost vertices only.
  template <class Policy>
  bool outermost_are_beyond(const VertexTable<Policy>& table, const HullSide& side,
                            bool strictly) const {
    return are_beyond(table, outermost_.vertices(), side, strictly);
  }

 private:
  template <class Policy>
  static bool are_beyond(const VertexTable<Policy>& table, std::span<const std::uint32_t> vertices,
                         const HullSide& side, bool strictly) {
    const auto [from, to, inside] = side;
    for (const std::uint32_t v : vertices) {
      const int turn = strictly ? table.turn(from, to, v) : table.turn_beyond(from, to, v);
      if (turn == inside || (strictly && turn == 0)) return false;
    }
    return true;
  }

  Outline outline_;
  OutermostVertices outermost_;
  std::optional<std::vector<HullSide>> hull_;
};

/// True if a side of `a` separates: all of `a` is on one side of its line and all of `b` on the
/// other, so that their interiors do not intersect in the projection. Points on the line are
/// allowed; with `strictly`, not for `b`, so that not even b's boundary touches.
template <class Policy>
bool separated_by_side_of(const VertexTable<Policy>& table, const ComparedOutline& a,
                          const ComparedOutline& b, bool strictly) {
  const auto separates = [&](std::uint32_t from, std::uint32_t to, int inside) {
    if (inside != 0) return b.is_beyond(table, {from, to, inside}, strictly);
    // A line has no inside, and a side of length 0 has no direction.
    return table.direction(from, to) != 0 && (b.is_beyond(table, {from, to, 1}, strictly) ||
                                              b.is_beyond(table, {from, to, -1}, strictly));
  };
  if (a.hull()) {
    return std::ranges::any_of(*a.hull(), [&](const HullSide& side) {
      return separates(side.from, side.to, side.inside);
    });
  }
  const auto [vertices, turning] = a.outline();
  assert(!vertices.empty());
  std::uint32_t from = vertices.back();
  for (const std::uint32_t to : vertices) {
    const std::uint32_t first = from;
    from = to;
    const auto matters = [&](int inside) {
      return b.outermost_are_beyond(table, {first, to, inside}, strictly);
    };
    const auto inside =
        turning != 0 ? std::optional<int>(turning) : a.inside_of(table, first, to, matters);
    if (inside && separates(first, to, *inside)) return true;
  }
  return false;
}

/// A triangle of points as entered, in the projection; turning is 0 if it is not one.
struct EnteredTriangle {
  std::array<Point2, 3> p{};
  int turning = 0;
};
template <class Policy>
EnteredTriangle entered_triangle(const VertexTable<Policy>& table, const Outline& a) {
  EnteredTriangle triangle;
  if (a.vertices.size() != 3 || a.turning == 0) return triangle;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point3* p = table.in_projection(a.vertices[k]);
    if (p == nullptr) return triangle;
    triangle.p[k] = *p;
  }
  triangle.turning = a.turning;
  return triangle;
}

/// separated_by_side_of for triangles, the usual case.
template <class Policy>
bool separated_by_side_of(const VertexTable<Policy>& table, const EnteredTriangle& a,
                          const EnteredTriangle& b) {
  assert(a.turning != 0);
  for (std::size_t i = 0; i < 3; ++i) {
    if (table.none_turns(a.p[i], a.p[i == 2 ? 0 : i + 1], b.p, a.turning)) return true;
  }
  return false;
}
template <class Policy>
bool overlap_in_projection(const VertexTable<Policy>& table, const EnteredTriangle& a,
                           const EnteredTriangle& b) {
  return !separated_by_side_of(table, a, b) && !separated_by_side_of(table, b, a);
}

/// The maximum number of orientation tests in separated_by_side_of; and the number that is too
/// many.
inline std::size_t most_turns(const Outline& a, const Outline& b) {
  const std::size_t na = a.vertices.size(), nb = b.vertices.size();
  return na * (a.turning != 0 ? nb : na + nb);
}
inline constexpr std::size_t kMostTurns = 1 << 16;

/// False only if no point of the projection is inside both. Symmetric. Polygons with too many sides
/// to compare, and non-convex ones that only several lines would separate, count as overlapping.
template <class Policy>
bool overlap_in_projection(const VertexTable<Policy>& table, const ComparedOutline& a,
                           const ComparedOutline& b) {
  const Outline &oa = a.outline(), &ob = b.outline();
  // A line is drawn where a polygon's boundary is, and then the order matters.
  const bool line = oa.vertices.size() == 2 || ob.vertices.size() == 2;
  if (most_turns(oa, ob) <= kMostTurns && separated_by_side_of(table, a, b, line)) return false;
  if (most_turns(ob, oa) <= kMostTurns && separated_by_side_of(table, b, a, line)) return false;
  return true;
}

/// The same for outlines that are compared once.
template <class Policy>
bool overlap_in_projection(const VertexTable<Policy>& table, const Outline& a, const Outline& b) {
  return overlap_in_projection(table, ComparedOutline(table, a), ComparedOutline(table, b));
}

}  // namespace displayfile
