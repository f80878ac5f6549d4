#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "hidden/exact/support_plane.h"
#include "hidden/map/visible_map.h"
#include "tests/brute_force_truth.h"
#include "tests/rational_points.h"

// The definition of visibility, in rationals, and the comparison of a map with it. It shares no
// code with the map except the support vertices and the description of its vertices.

namespace displayfile::test {

class MapTruth {
 public:
  static constexpr std::uint32_t kNothing = VisibleMap::kNothing;

  explicit MapTruth(const Primitives& items) {
    for (std::size_t i = 0; i < items.points.size(); ++i) points_.push_back(exact(items.points[i]));
    for (std::uint32_t i = 0; i < items.items.size(); ++i) {
      const Primitives::Item& item = items.items[i];
      planes_.emplace_back();
      if (item.kind == Primitives::Kind::line) continue;
      const SupportVertices support = support_vertices(items.points_of(item));
      const bool is_own = items.has_own_plane(i);
      const auto at = [&](std::size_t k) {
        return points_[is_own ? items.point(item.first + support.index[k]) : items.planes[i][k]];
      };
      if (is_own ? support.edge_on : turn(at(0), at(1), at(2)) == 0) continue;
      const Point3 rest = items.plane_rest(i);
      const auto with_rest = [&](std::size_t k) {
        QPoint point = at(k);
        point.z += Q(rest[static_cast<int>(k)]);
        return point;
      };
      planes_.back().emplace_back(with_rest(0), with_rest(1), with_rest(2));
      if (item.kind != Primitives::Kind::solid) continue;
      Polygon polygon{i, {}, Point2(1e300), Point2(-1e300)};
      for (std::uint32_t k = 0; k < item.sides; ++k) {
        const std::uint32_t point = items.point(item.first + k);
        polygon.corners.push_back(points_[point]);
        polygon.low = glm::min(polygon.low, Point2(items.points[point]));
        polygon.high = glm::max(polygon.high, Point2(items.points[point]));
      }
      polygons_.push_back(std::move(polygon));
    }
  }

  /// The item visible right beside a point, in the direction (dx, dy).
  std::uint32_t seen_beside(const Q& x, const Q& y, const Q& dx, const Q& dy) const {
    std::uint32_t seen = kNothing;
    Q nearest, slope_of_nearest;
    const Point2 about(x.get_d(), y.get_d());
    const double off = 1e-9 * (std::abs(about.x) + std::abs(about.y) + 1.0);
    for (const Polygon& polygon : polygons_) {
      const bool apart = about.x < polygon.low.x - off || about.x > polygon.high.x + off ||
                         about.y < polygon.low.y - off || about.y > polygon.high.y + off;
      if (apart || !covers(polygon, x, y, dx, dy)) continue;
      const QPlane& plane = planes_[polygon.item].front();
      const Q z = plane.z(x, y), slope = -(plane.a * dx + plane.b * dy) / plane.c;
      if (seen == kNothing || z > nearest || (z == nearest && slope >= slope_of_nearest)) {
        nearest = z;
        slope_of_nearest = slope;
        seen = polygon.item;
      }
    }
    return seen;
  }

  /// The vertex as it is described, without z.
  QPoint point(const MapPlace& place) const {
    const auto& of = place.of;
    switch (place.kind) {
      case MapPlace::Kind::point: return points_[of[0]];
      case MapPlace::Kind::crossing: {
        const QPoint &a = points_[of[0]], &b = points_[of[1]];
        const Q at_a = turn(points_[of[2]], points_[of[3]], a);
        const Q at_b = turn(points_[of[2]], points_[of[3]], b);
        return a + (at_a / (at_a - at_b)) * (b - a);
      }
      case MapPlace::Kind::meeting: {
        const QPoint &a = points_[of[0]], &b = points_[of[1]];
        const auto apart = [&](const QPoint& p) -> Q {
          return planes_[of[2]].front().z(p.x, p.y) - planes_[of[3]].front().z(p.x, p.y);
        };
        const Q at_a = apart(a), at_b = apart(b);
        return a + (at_a / (at_a - at_b)) * (b - a);
      }
      case MapPlace::Kind::planes: break;
    }
    const auto met = meet(planes_[of[0]].front(), planes_[of[1]].front(), planes_[of[2]].front());
    return met ? *met : QPoint{};
  }

  struct Polygon {
    std::uint32_t item;
    std::vector<QPoint> corners;
    Point2 low, high;  // of the box around them
  };
  const std::vector<Polygon>& polygons() const { return polygons_; }

 private:
  static QPoint exact(const Point3& p) { return {scaled(p.x, 0), scaled(p.y, 0), scaled(p.z, 0)}; }

  /// Even-odd, of a point beside (x, y): where a comparison is undecided there, the way decides.
  static bool covers(const Polygon& polygon, const Q& x, const Q& y, const Q& dx, const Q& dy) {
    bool inside = false;
    const auto is_above = [&](const QPoint& p) { return p.y != y ? p.y > y : dy < 0; };
    const QPoint* p = &polygon.corners.back();
    for (const QPoint& q : polygon.corners) {
      if (is_above(*p) != is_above(q)) {
        Q left = (q.x - p->x) * (y - p->y) - (q.y - p->y) * (x - p->x);
        if (left == 0) left = (q.x - p->x) * dy - (q.y - p->y) * dx;
        if ((left > 0) == (q.y > p->y)) inside = !inside;
      }
      p = &q;
    }
    return inside;
  }

  std::vector<QPoint> points_;
  std::vector<std::vector<QPlane>> planes_;  // of each item, one or none
  std::vector<Polygon> polygons_;
};

/// Describes the errors in a map of the items; empty if there are none. As many random points as
/// given ones are tested too. In a large scene, only one in `every` edges and sides is tested for
/// the visible items beside it; all outlines must close, and all edges must meet at vertices.
inline std::string wrong_in_map(const Primitives& items, const VisibleMap& map,
                                std::span<const Point2> asked, std::size_t every = 1) {
  const MapTruth truth(items);
  std::ostringstream wrong;
  std::vector<QPoint> at;
  for (const MapPlace& place : map.places) at.push_back(truth.point(place));
  for (std::size_t v = 0; v < at.size(); ++v) {
    for (int axis = 0; axis < 2; ++axis) {
      const Q& exact = axis == 0 ? at[v].x : at[v].y;
      if (BruteForceTruth::nearest_double(exact) != map.points[v][axis]) {
        wrong << "vertex " << v << " is not rounded once\n";
      }
    }
  }
  // The visible items beside each edge are those that it names.
  const auto name = [](std::uint32_t item) {
    return item == VisibleMap::kNothing ? std::string("nothing") : std::to_string(item);
  };
  for (std::size_t e = 0; e < map.edges.size(); e += every) {
    const auto& [from, to, left, right] = map.edges[e];
    const Q dx = at[to].x - at[from].x, dy = at[to].y - at[from].y;
    if (dx == 0 && dy == 0) wrong << "edge " << e << " has no length\n";
    if (left == right) wrong << "edge " << e << " is none\n";
    for (const Q& t : {Q(1, 2), Q(3, 1000), Q(989, 1000)}) {
      const Q x = at[from].x + t * dx, y = at[from].y + t * dy;
      const std::uint32_t l = truth.seen_beside(x, y, dx / 1009 - dy, dy / 1009 + dx);
      const std::uint32_t r = truth.seen_beside(x, y, dx / 1009 + dy, dy / 1009 - dx);
      if (l == left && r == right) continue;
      wrong << "edge " << e << " at " << t.get_d() << ", (" << x.get_d() << ", " << y.get_d()
            << "): " << name(left) << " | " << name(right) << ", but seen are " << name(l) << " | "
            << name(r) << "\n";
      break;
    }
  }
  // Around each item its edges close.
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> open;  // by item and vertex
  for (const auto& [from, to, left, right] : map.edges) {
    ++open[{left, from}];
    --open[{left, to}];
    --open[{right, from}];
    ++open[{right, to}];
  }
  for (const auto& [where, count] : open) {
    if (count != 0) wrong << name(where.first) << " is open at vertex " << where.second << "\n";
  }
  // Edges meet at vertices only.
  for (std::size_t e = 0; e < map.edges.size(); ++e) {
    const QPoint &a = at[map.edges[e].from], &b = at[map.edges[e].to];
    const auto inside = [&](std::uint32_t v, const QPoint& p, const QPoint& q) {
      if (turn(p, q, at[v]) != 0) return false;
      const Q along = (at[v].x - p.x) * (q.x - p.x) + (at[v].y - p.y) * (q.y - p.y);
      const Q whole = (q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y);
      return along > 0 && along < whole;
    };
    const Point2 &fa = map.points[map.edges[e].from], &fb = map.points[map.edges[e].to];
    for (std::size_t f = e + 1; f < map.edges.size(); ++f) {
      const auto& [from, to, l, r] = map.edges[f];
      const Point2 &fc = map.points[from], &fd = map.points[to];
      const bool apart = std::max(fa.x, fb.x) < std::min(fc.x, fd.x) ||
                         std::max(fc.x, fd.x) < std::min(fa.x, fb.x) ||
                         std::max(fa.y, fb.y) < std::min(fc.y, fd.y) ||
                         std::max(fc.y, fd.y) < std::min(fa.y, fb.y);
      if (apart) continue;
      const QPoint &c = at[from], &d = at[to];
      const auto sign = [](const Q& q) { return sgn(q); };
      const bool cross = sign(turn(a, b, c)) * sign(turn(a, b, d)) < 0 &&
                         sign(turn(c, d, a)) * sign(turn(c, d, b)) < 0;
      if (cross || inside(from, a, b) || inside(to, a, b) || inside(map.edges[e].from, c, d) ||
          inside(map.edges[e].to, c, d) ||
          (turn(a, b, c) == 0 && turn(a, b, d) == 0 &&
           ((from == map.edges[e].from && to == map.edges[e].to) ||
            (from == map.edges[e].to && to == map.edges[e].from)))) {
        wrong << "edges " << e << " and " << f
              << " have more than a vertex in common: " << name(map.edges[e].left) << " | "
              << name(map.edges[e].right) << ", " << name(l) << " | " << name(r) << " from ("
              << c.x.get_d() << ", " << c.y.get_d() << ") to (" << d.x.get_d() << ", "
              << d.y.get_d() << ")\n";
      }
    }
  }
  // The visible items at places anywhere, found by counting edges, and along the polygons' sides.
  const auto in_map = [&](const Q& x, const Q& y, const Q& dx, const Q& dy) {
    std::map<std::uint32_t, int> crossed;
    for (const auto& [from, to, left, right] : map.edges) {
      const QPoint &p = at[from], &q = at[to];
      const auto is_above = [&](const QPoint& v) { return v.y != y ? v.y > y : dy < 0; };
      if (is_above(p) == is_above(q)) continue;
      Q beside = (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
      if (beside == 0) beside = (q.x - p.x) * dy - (q.y - p.y) * dx;
      if ((beside > 0) != (q.y > p.y)) continue;
      ++crossed[left];
      ++crossed[right];
    }
    std::uint32_t seen = VisibleMap::kNothing;
    int odd = 0;
    for (const auto& [item, count] : crossed) {
      if (count % 2 == 0 || item == VisibleMap::kNothing) continue;
      seen = item;
      ++odd;
    }
    return odd > 1 ? std::string("several") : name(seen);
  };
  const auto ask = [&](const Q& x, const Q& y, const Q& dx, const Q& dy) {
    const std::string found = in_map(x, y, dx, dy), right = name(truth.seen_beside(x, y, dx, dy));
    if (found != right) {
      wrong << "at (" << x.get_d() << ", " << y.get_d() << "), to (" << dx.get_d() << ", "
            << dy.get_d() << ") is seen " << right << ", in the map " << found << "\n";
    }
  };
  for (const Point2& p : asked) ask(scaled(p.x, 0), scaled(p.y, 0), 0, 0);
  for (std::size_t k = 0; k < truth.polygons().size(); k += every) {
    const MapTruth::Polygon& polygon = truth.polygons()[k];
    const QPoint* p = &polygon.corners.back();
    for (const QPoint& q : polygon.corners) {
      const Q dx = q.x - p->x, dy = q.y - p->y;
      for (const Q& t : {Q(3, 7), Q(1, 1000)}) {
        if (dx == 0 && dy == 0) continue;
        ask(p->x + t * dx, p->y + t * dy, dx / 1009 - dy, dy / 1009 + dx);
        ask(p->x + t * dx, p->y + t * dy, dx / 1009 + dy, dy / 1009 - dx);
      }
      p = &q;
    }
  }
  return wrong.str();
}

}  // namespace displayfile::test
