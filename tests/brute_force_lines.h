#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "interp/truth/line_items.h"
#include "tests/brute_force_truth.h"
#include "tests/rational_points.h"

// The definition of the visible parts of a line (interp/truth/true_lines.md) in rationals, in the
// most naive form that can be compared with it: between any two places where a side meets the line
// or a plane its depth, the middle is judged by points that actually lie a little left and right of
// it. It shares nothing with interp/truth but the walk over the items. For few polygons.

namespace displayfile::test {

class BruteForceLines {
 public:
  /// Points beside a line are 2^-places of its length away from it: fewer than any feature of the
  /// scene needs.
  BruteForceLines(const LineItems& items, int places) : items_(items) {
    mpq_div_2exp(aside_.get_mpq_t(), Q(1).get_mpq_t(), static_cast<mp_bitcnt_t>(places));
    for (std::uint32_t item = 0; item < items.size(); ++item) {
      Polygon polygon;
      for (const Point3& p : items.points(item)) polygon.vertices.push_back({p.x, p.y, p.z});
      if (items.kind(item) != LineItems::Kind::line) polygon.plane = plane_of(item);
      polygon.covers = items.kind(item) == LineItems::Kind::solid && polygon.plane.has_value();
      polygons_.push_back(std::move(polygon));
    }
  }

  struct Part {
    double from, to;
    bool operator==(const Part&) const = default;
  };
  /// The visible parts of the line of the sharers, along the first; exact ends to the nearest
  /// double.
  std::vector<Part> visible(std::span<const LineId> sharers) const {
    const QPoint from = vertex(items_.from(sharers[0])), to = vertex(items_.to(sharers[0]));
    const std::vector<Q> places = breakpoints(sharers, from, to);
    std::vector<Part> parts;
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      const Part part{BruteForceTruth::nearest_double(places[k]),
                      BruteForceTruth::nearest_double(places[k + 1])};
      const Q middle = (places[k] + places[k + 1]) / 2;
      if (part.from == part.to || !is_seen(sharers, from, to, middle)) continue;
      if (!parts.empty() && parts.back().to == part.from) {
        parts.back().to = part.to;
      } else {
        parts.push_back(part);
      }
    }
    return parts;
  }

 private:
  struct Polygon {
    std::vector<QPoint> vertices;
    std::optional<QPlane> plane;
    bool covers = false;
  };

  static QPoint vertex(const Point3& p) { return {p.x, p.y, p.z}; }

  /// The plane that the polygon shares with others, unless that is seen edge-on; or else its own.
  std::optional<QPlane> plane_of(std::uint32_t item) const {
    std::optional<QPlane> found;
    const Point3 rest = items_.plane_rest(item);
    if (const auto* shared = items_.shared_plane(item)) found = plane(*shared, rest);
    return found ? found : plane(items_.points(item), rest);
  }

  static std::optional<QPlane> plane(std::span<const Point3> v, const Point3& rest) {
    const auto distance = [&](std::size_t i) {
      const double x = v[i].x - v[0].x, y = v[i].y - v[0].y;
      return x * x + y * y;
    };
    std::size_t q = 1, r = 2;
    const auto beside = [&](std::size_t i) {
      return std::abs((v[q].x - v[0].x) * (v[i].y - v[0].y) -
                      (v[q].y - v[0].y) * (v[i].x - v[0].x));
    };
    if (v.size() > 3) {
      q = r = 0;
      for (std::size_t i = 1; i < v.size(); ++i) q = distance(i) > distance(q) ? i : q;
      for (std::size_t i = 1; i < v.size(); ++i) r = beside(i) > beside(r) ? i : r;
    }
    const auto in_line = [&](std::size_t i) {
      return turn(vertex(v[0]), vertex(v[q]), vertex(v[i])) == 0;
    };
    for (std::size_t i = 0; i < v.size() && in_line(r); ++i) {
      if (!in_line(i)) r = i;
    }
    std::array<QPoint, 3> points{vertex(v[0]), vertex(v[q]), vertex(v[r])};
    for (std::size_t k = 0; k < 3; ++k) points[k].z += Q(rest[static_cast<int>(k)]);
    const QPlane plane(points[0], points[1], points[2]);
    if (plane.c == 0) return std::nullopt;
    return plane;
  }

  /// The sharer's depth at t along the line from one point to the other.
  Q depth(LineId sharer, const QPoint& from, const QPoint& to, const Q& t) const {
    const QPoint at = from + t * (to - from);
    const auto& plane = polygons_[sharer.item].plane;
    return plane ? plane->z(at.x, at.y) : at.z;
  }

  std::vector<Q> breakpoints(std::span<const LineId> sharers, const QPoint& from,
                             const QPoint& to) const {
    const QPoint along = to - from;
    const Q square = along.x * along.x + along.y * along.y;
    const auto foot = [&](const QPoint& p) -> Q {
      return ((p.x - from.x) * along.x + (p.y - from.y) * along.y) / square;
    };
    std::vector<Q> places{0, 1};
    for (const Polygon& polygon : polygons_) {
      if (!polygon.covers) continue;
      for (std::size_t k = 0; k < polygon.vertices.size(); ++k) {
        const QPoint& a = polygon.vertices[k];
        const QPoint& b = polygon.vertices[(k + 1) % polygon.vertices.size()];
        const Q of_a = turn(from, to, a), of_b = turn(from, to, b);
        if (of_a == 0) places.push_back(foot(a));
        if (of_b == 0) places.push_back(foot(b));
        if (of_a * of_b < 0) places.push_back(foot(a + of_a / (of_a - of_b) * (b - a)));
      }
      for (const LineId sharer : sharers) {
        const Q start = polygon.plane->z(from.x, from.y) - depth(sharer, from, to, 0);
        const Q end = polygon.plane->z(to.x, to.y) - depth(sharer, from, to, 1);
        if (start != end) places.push_back(start / (start - end));
      }
    }
    std::erase_if(places, [](const Q& t) { return t < 0 || t > 1; });
    std::ranges::sort(places, [](const Q& a, const Q& b) { return a < b; });
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
  }

  static bool is_inside(const Polygon& polygon, const Q& x, const Q& y) {
    bool inside = false;
    for (std::size_t k = 0; k < polygon.vertices.size(); ++k) {
      const QPoint& a = polygon.vertices[k];
      const QPoint& b = polygon.vertices[(k + 1) % polygon.vertices.size()];
      if ((a.y < y) == (b.y < y)) continue;
      if (a.x + (y - a.y) * (b.x - a.x) / (b.y - a.y) <= x) inside = !inside;
    }
    return inside;
  }

  bool is_seen(std::span<const LineId> sharers, const QPoint& from, const QPoint& to,
               const Q& t) const {
    const QPoint at = from + t * (to - from);
    const auto is_hidden_beside = [&](LineId sharer, const Q& x, const Q& y) {
      const Q own = depth(sharer, from, to, t);
      return std::ranges::any_of(polygons_, [&](const Polygon& polygon) {
        return polygon.covers && polygon.plane->z(at.x, at.y) > own && is_inside(polygon, x, y);
      });
    };
    const Q x = (to.y - from.y) * aside_, y = (from.x - to.x) * aside_;
    return std::ranges::any_of(sharers, [&](LineId sharer) {
      return !is_hidden_beside(sharer, at.x + x, at.y + y) ||
             !is_hidden_beside(sharer, at.x - x, at.y - y);
    });
  }

  const LineItems& items_;
  Q aside_;
  std::vector<Polygon> polygons_;
};

}  // namespace displayfile::test
