#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "displayfile/segments/display_file.h"
#include "interp/device/picture.h"

// The definition of truth (interp/truth/truth.md) in rationals, in the most naive way that can
// be read against it: every row, every polygon, every edge, every centre. It shares no line with
// interp/truth/truth.cpp or with any method. For small pictures and few polygons: about 10 ms for 8
// polygons at 32 x 32.

namespace displayfile::test {

class BruteForceTruth {
 public:
  using Rational = mpq_class;

  BruteForceTruth(const DisplayFile& file, int width, int height) : width_(width), height_(height) {
    for (const Segment& segment : file.segments()) {
      if (segment.visible) segment.walk_drawn(Walk{*this});
    }
  }

  /// Pick identifiers of the polygons that are exactly as near as the visible one and were entered
  /// before it, for each pixel, top row first.
  using Ties = std::vector<std::vector<std::int32_t>>;

  /// ids and depth, top row first; depth is the double nearest to the exact one.
  Picture picture(Ties* ties = nullptr) const {
    Picture result;
    result.width = width_;
    result.height = height_;
    for (int row = height_ - 1; row >= 0; --row) {
      std::vector<std::optional<Rational>> nearest(static_cast<std::size_t>(width_));
      std::vector<std::int32_t> seen(static_cast<std::size_t>(width_), -1);
      Ties tied(seen.size());
      for (const Polygon& polygon : polygons_) draw_row(polygon, row, nearest, seen, tied);
      if (ties != nullptr) ties->insert(ties->end(), tied.begin(), tied.end());
      for (std::size_t i = 0; i < seen.size(); ++i) {
        result.ids.push_back(seen[i]);
        result.depth.push_back(nearest[i] ? nearest_double(*nearest[i])
                                          : -std::numeric_limits<double>::infinity());
      }
    }
    return result;
  }

  static double nearest_double(const Rational& value) {
    double best = value.get_d();  // cut off toward zero
    for (double direction : {-1.0, 1.0}) {
      const double other =
          std::nextafter(value.get_d(), direction * std::numeric_limits<double>::infinity());
      if (!std::isfinite(other)) continue;
      const Rational from_best = abs(Rational(best) - value),
                     from_other = abs(Rational(other) - value);
      if (from_other < from_best || (from_other == from_best && is_even(other))) best = other;
    }
    return best;
  }

 private:
  struct Vertex {
    Rational x, y, z;  // x and y in pixels
  };
  struct Polygon {
    std::vector<Vertex> vertices;
    Vertex on_plane;
    Rational dz_dx, dz_dy;
    std::int32_t pick;
  };

  /// The last digit of the double is 0.
  static bool is_even(double value) {
    int exponent = 0;
    const double whole = std::ldexp(std::frexp(value, &exponent), 53);
    const bool subnormal = std::abs(value) < std::numeric_limits<double>::min();
    return std::fmod(subnormal ? std::ldexp(value, 1074) : whole, 2.0) == 0.0;
  }

  void enter(std::span<const Point3> drawn, std::int32_t pick) {
    std::size_t p = 0, q = 1, r = 2;
    const auto value_for_q = [&](std::size_t i) {
      const double x = drawn[i].x - drawn[p].x, y = drawn[i].y - drawn[p].y;
      return x * x + y * y;
    };
    const auto value_for_r = [&](std::size_t i) {
      return std::abs((drawn[q].x - drawn[p].x) * (drawn[i].y - drawn[p].y) -
                      (drawn[q].y - drawn[p].y) * (drawn[i].x - drawn[p].x));
    };
    if (drawn.size() > 3) {
      std::vector<double> of_q, of_r;
      for (std::size_t i = 0; i < drawn.size(); ++i) of_q.push_back(value_for_q(i));
      q = static_cast<std::size_t>(std::ranges::max_element(of_q) - of_q.begin());
      for (std::size_t i = 0; i < drawn.size(); ++i) of_r.push_back(value_for_r(i));
      r = static_cast<std::size_t>(std::ranges::max_element(of_r) - of_r.begin());
    }
    Polygon polygon{{}, {}, 0, 0, pick};
    for (const Point3& v : drawn) {
      polygon.vertices.push_back({Rational(v.x) * width_, Rational(v.y) * height_, Rational(v.z)});
    }
    const auto in_line = [&](std::size_t i) {
      const Vertex &a = polygon.vertices[p], &b = polygon.vertices[q], &c = polygon.vertices[i];
      return (b.x - a.x) * (c.y - a.y) == (c.x - a.x) * (b.y - a.y);
    };
    for (std::size_t i = 0; i < drawn.size() && in_line(r); ++i) {
      if (!in_line(i)) r = i;
    }
    // z - zp = dz_dx (x - xp) + dz_dy (y - yp) at q and r, by Cramer's rule.
    const Vertex &P = polygon.vertices[p], &Q = polygon.vertices[q], &R = polygon.vertices[r];
    const Rational qx = Q.x - P.x, qy = Q.y - P.y, qz = Q.z - P.z;
    const Rational rx = R.x - P.x, ry = R.y - P.y, rz = R.z - P.z;
    const Rational determinant = qx * ry - rx * qy;
    if (determinant == 0) return;
    polygon.on_plane = P;
    polygon.dz_dx = (qz * ry - rz * qy) / determinant;
    polygon.dz_dy = (qx * rz - rx * qz) / determinant;
    polygons_.push_back(std::move(polygon));
  }

  void draw_row(const Polygon& polygon, int row, std::vector<std::optional<Rational>>& nearest,
                std::vector<std::int32_t>& seen, Ties& tied) const {
    const Rational half(1, 2), cy = row + half;
    std::vector<Rational> crossings;
    for (std::size_t k = 0; k < polygon.vertices.size(); ++k) {
      const Vertex& a = polygon.vertices[k];
      const Vertex& b = polygon.vertices[(k + 1) % polygon.vertices.size()];
      if (std::min(a.y, b.y) < cy && cy <= std::max(a.y, b.y)) {
        crossings.push_back(a.x + (cy - a.y) * (b.x - a.x) / (b.y - a.y));
      }
    }
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const Rational cx = static_cast<int>(i) + half;
      const auto at_or_left = [&](const Rational& x) { return x <= cx; };
      if (std::ranges::count_if(crossings, at_or_left) % 2 == 0) continue;
      const Rational depth = polygon.on_plane.z + polygon.dz_dx * (cx - polygon.on_plane.x) +
                             polygon.dz_dy * (cy - polygon.on_plane.y);
      if (nearest[i] && *nearest[i] > depth) continue;
      if (nearest[i] && *nearest[i] == depth) {
        tied[i].push_back(seen[i]);
      } else {
        tied[i].clear();
      }
      nearest[i] = depth;
      seen[i] = polygon.pick;
    }
  }

  struct Walk {
    BruteForceTruth& truth;
    bool solid = true;
    std::int32_t id = -1;
    void fill(const FillStyle& style) { solid = style.kind == FillStyle::Kind::solid; }
    void line_style(const LineStyle&) {}
    void pick(std::int32_t pick) { id = pick; }
    void move(const Point3&) {}
    void line(const Point3&) {}
    void polygon(std::span<const Point3> vertices, std::span<const std::int32_t>) {
      if (solid) truth.enter(vertices, id);
    }
  };

  int width_, height_;
  std::vector<Polygon> polygons_;  // that may cover something, in order of entry
};

inline Picture brute_force_truth(const DisplayFile& file, int width, int height) {
  return BruteForceTruth(file, width, height).picture();
}

}  // namespace displayfile::test
