#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "hidden/lines/visible_lines.h"
#include "tests/rational_points.h"
#include "tests/sort_scenes.h"

// The definition of hidden lines (hidden/lines/README.md) at sampled points, in rationals and as
// naively as it can be read: it shares nothing with the methods.

namespace displayfile::test {

class LineJudge {
 public:
  explicit LineJudge(const ItemList& list) : list_(list) {
    Shift shift;
    for (const Point3& p : list.points) shift.include(p);
    for (const Point3& p : list.points) points_.push_back(exact(p, shift.value()));
    for (std::size_t i = 0; i < list.items.size(); ++i) planes_.push_back(support(i));
  }

  /// Which of the samples of a line are wrong in these pieces, in words; empty if none. Those too
  /// close to an end of a piece are not asked about.
  std::string judged(const LineName& line, std::span<const VisiblePiece> pieces,
                     int samples) const {
    constexpr double kCrumb = 1e-12;
    for (int k = 0; k < samples; ++k) {
      Q t(97 * k + 31, 97 * samples);  // where a grid has no crossings
      t.canonicalize();
      bool claimed = false, close = false;
      for (const VisiblePiece& piece : pieces) {
        if (LineName{piece.item, piece.corner} != line) continue;
        const double at = t.get_d();
        claimed = claimed || (piece.from < at && at < piece.to);
        close = close || std::abs(piece.from - at) < kCrumb || std::abs(piece.to - at) < kCrumb;
      }
      const bool is_seen = seen(line, t);
      if (close || is_seen == claimed) continue;
      std::ostringstream text;
      text << "item " << line.item << ", corner " << line.corner << " at " << t << ": "
           << (is_seen ? "seen, but no piece has it" : "hidden, but a piece has it");
      return text.str();
    }
    return "";
  }

  bool seen(const LineName& line, const Q& t) const {
    const auto [a, b] = ends(line);
    if (list_.items[line.item].kind == ItemList::Kind::line) return seen_by_ends(a, b, t);
    // A side is seen where it is for one of the polygons that share it.
    for (std::uint32_t i = 0; i < list_.items.size(); ++i) {
      if (list_.items[i].kind == ItemList::Kind::line) continue;
      for (std::uint32_t corner = 0; corner < list_.items[i].sides; ++corner) {
        const auto [p, q] = ends({i, corner});
        const bool same =
            (same_point(p, a) && same_point(q, b)) || (same_point(p, b) && same_point(q, a));
        if (same && seen_for(i, a, b, t)) return true;
      }
    }
    return false;
  }

 private:
  struct Ends {
    QPoint a, b;
  };
  Ends ends(const LineName& line) const {
    const auto& item = list_.items[line.item];
    const std::uint32_t before = line.corner == 0 ? item.sides - 1 : line.corner - 1;
    return {points_[item.first + before], points_[item.first + line.corner]};
  }
  static bool same_point(const QPoint& p, const QPoint& q) {
    return p.x == q.x && p.y == q.y && p.z == q.z;
  }

  /// The definition's support plane, by the definition's doubles; none of a polygon that is
  /// edge-on.
  std::optional<QPlane> support(std::size_t i) const {
    const auto v = list_.points_of(i);
    if (list_.items[i].kind == ItemList::Kind::line || v.size() < 3) return std::nullopt;
    std::size_t q = 1, r = 2;
    const auto square = [&](std::size_t k) {
      const double x = v[k].x - v[0].x, y = v[k].y - v[0].y;
      return x * x + y * y;
    };
    const auto area = [&](std::size_t k) {
      return std::abs((v[q].x - v[0].x) * (v[k].y - v[0].y) -
                      (v[q].y - v[0].y) * (v[k].x - v[0].x));
    };
    if (v.size() > 3) {
      q = r = 0;
      for (std::size_t k = 1; k < v.size(); ++k) q = square(k) > square(q) ? k : q;
      for (std::size_t k = 1; k < v.size(); ++k) r = area(k) > area(r) ? k : r;
    }
    const std::size_t first = list_.items[i].first;
    QPlane plane(points_[first], points_[first + q], points_[first + r]);
    if (area(r) == 0.0 || plane.c == 0) return std::nullopt;
    return plane;
  }

  bool seen_for(std::uint32_t polygon, const QPoint& a, const QPoint& b, const Q& t) const {
    const QPoint at = a + t * (b - a);
    if (!planes_[polygon]) return seen_by_ends(a, b, t);
    return seen_at(a, b, at, planes_[polygon]->z(at.x, at.y));
  }
  bool seen_by_ends(const QPoint& a, const QPoint& b, const Q& t) const {
    const QPoint at = a + t * (b - a);
    return seen_at(a, b, at, at.z);
  }
  /// So close beside the line that no side that the point is not on comes between.
  bool seen_at(const QPoint& a, const QPoint& b, const QPoint& at, const Q& depth) const {
    Q close(1);
    mpq_div_2exp(close.get_mpq_t(), close.get_mpq_t(), 900);
    const QPoint d = b - a;
    const QPoint left{at.x - close * d.y, at.y + close * d.x, 0};
    const QPoint right{at.x + close * d.y, at.y - close * d.x, 0};
    return !(is_covered(left, at, depth) && is_covered(right, at, depth));
  }
  /// By a solid polygon that is nearer at the point beside.
  bool is_covered(const QPoint& p, const QPoint& at, const Q& depth) const {
    for (std::size_t i = 0; i < list_.items.size(); ++i) {
      if (list_.items[i].kind != ItemList::Kind::solid || !planes_[i]) continue;
      if (planes_[i]->z(at.x, at.y) > depth && covers(i, p)) return true;
    }
    return false;
  }
  bool covers(std::size_t i, const QPoint& p) const {
    const auto& item = list_.items[i];
    bool inside = false;
    for (std::uint32_t k = 0; k < item.sides; ++k) {
      const QPoint& u = points_[item.first + k];
      const QPoint& v = points_[item.first + (k + 1) % item.sides];
      if ((u.y < p.y) == (v.y < p.y)) continue;
      if (u.x + (p.y - u.y) * (v.x - u.x) / (v.y - u.y) < p.x) inside = !inside;
    }
    return inside;
  }

  const ItemList& list_;
  std::vector<QPoint> points_;
  std::vector<std::optional<QPlane>> planes_;
};

}  // namespace displayfile::test
