#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

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

/// Vertices that are farthest out in eight directions, about, of a polygon of many; all of a
/// polygon of few. A line that has some of the polygon on both sides mostly has some of these
/// there.
class OutermostVertices {
 public:
  /// The vertices must outlive it.
  template <class Policy>
  OutermostVertices(const VertexTable<Policy>& table, std::span<const std::uint32_t> vertices)
      : few_(vertices) {
    constexpr std::size_t kFew = 16;
    if (vertices.size() < kFew) return;
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
    few_ = outermost_;
  }
  OutermostVertices(const OutermostVertices&) = delete;
  OutermostVertices& operator=(const OutermostVertices&) = delete;
  std::span<const std::uint32_t> vertices() const { return few_; }
  bool are_all() const { return few_.data() != outermost_.data(); }

 private:
  static constexpr std::size_t kDirections = 8;
  std::array<std::uint32_t, kDirections> outermost_{};
  std::span<const std::uint32_t> few_;
};

/// True if a side of `a` separates: all of `a` is on one side of its line and all of `b` on the
/// other, so that their interiors do not intersect in the projection. Points on the line count for
/// neither; `strictly`: those of b do, and then b's boundary does not even touch.
template <class Policy>
bool separated_by_side_of(const VertexTable<Policy>& table, const Outline& a, const Outline& b,
                          bool strictly = false) {
  assert(!a.vertices.empty());
  const OutermostVertices outermost_a(table, a.vertices), outermost_b(table, b.vertices);
  std::uint32_t from = a.vertices.back();
  for (const std::uint32_t to : a.vertices) {
    const auto are_beyond = [&](std::span<const std::uint32_t> vertices, int inside) {
      for (const std::uint32_t v : vertices) {
        const int turn = strictly ? table.turn(from, to, v) : table.turn_beyond(from, to, v);
        if (turn == inside || (strictly && turn == 0)) return false;
      }
      return true;
    };
    const auto all_beyond = [&](int inside) {
      return are_beyond(outermost_b.vertices(), inside) &&
             (outermost_b.are_all() || are_beyond(b.vertices, inside));
    };
    if (a.turning != 0) {
      if (all_beyond(a.turning)) return true;
    } else {
      int inside = 0;
      const auto has_on_one_side = [&](std::span<const std::uint32_t> vertices) {
        for (const std::uint32_t v : vertices) {
          const int turn = table.turn(from, to, v);
          if (turn == 0) continue;
          if (inside == -turn) return false;
          inside = turn;
        }
        return true;
      };
      const auto may_separate = [&] {
        return inside == 0 || are_beyond(outermost_b.vertices(), inside);
      };
      const bool on_the_hull = has_on_one_side(outermost_a.vertices()) && may_separate() &&
                               (outermost_a.are_all() || has_on_one_side(a.vertices));
      if (on_the_hull && inside != 0 && all_beyond(inside)) return true;
      // A line has nothing on either side of it; nor have two corners in one point.
      const bool is_line = on_the_hull && inside == 0 && table.direction(from, to) != 0;
      if (is_line && (all_beyond(1) || all_beyond(-1))) return true;
    }
    from = to;
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
bool overlap_in_projection(const VertexTable<Policy>& table, const Outline& a, const Outline& b) {
  // A line is drawn where a polygon's boundary is, and then the order matters.
  const bool line = a.vertices.size() == 2 || b.vertices.size() == 2;
  if (most_turns(a, b) <= kMostTurns && separated_by_side_of(table, a, b, line)) return false;
  if (most_turns(b, a) <= kMostTurns && separated_by_side_of(table, b, a, line)) return false;
  return true;
}

}  // namespace displayfile
