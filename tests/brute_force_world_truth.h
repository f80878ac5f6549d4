#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "clip/view/transformation.h"
#include "clip/view/view_volume.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/retained_scene.h"
#include "tests/brute_force_truth.h"

// The result of interp/truth/world_truth.h, in rationals and in another way: nothing is clipped,
// but the ray through each pixel centre is intersected with each polygon. A polygon covers the
// centre if an odd number of the triangles of its fan do, and the point of its plane there is
// inside the view volume. A centre on an edge is moved by (e, -e^2), with e small enough: so left
// and top edges belong.

namespace displayfile::test {

class BruteForceWorldTruth {
 public:
  using Q = mpq_class;
  using Place = std::array<Q, 3>;  ///< in world coordinates

  /// A polygon of more than three sides must lie in a plane, if the front or the back plane or the
  /// eye clips it. Pick identifiers are all different.
  BruteForceWorldTruth(const RetainedScene& scene, const DisplayFile& file, int width, int height)
      : width_(width), height_(height) {
    for (const Segment& segment : file.segments()) {
      if (segment.visible) segment.walk_entered_drawn(Walk{vertices_drawn_});
    }
    for (const RetainedScene::Segment& part : scene.segments()) {
      const Segment& segment = file.segment(part.name);
      if (segment.visible) enter(scene, part, segment.image);
    }
  }

  Picture picture() const {
    Picture result;
    result.width = width_;
    result.height = height_;
    for (int row = height_ - 1; row >= 0; --row) {
      for (int column = 0; column < width_; ++column) {
        std::optional<Q> nearest;
        std::int32_t seen = -1;
        for (const Polygon& polygon : polygons_) {
          const std::optional<Q> depth = depth_at(polygon, Q(2 * column + 1, 2), Q(2 * row + 1, 2));
          if (!depth || (nearest && *nearest > *depth)) continue;
          nearest = depth;
          seen = polygon.pick;
        }
        result.ids.push_back(seen);
        result.depth.push_back(nearest ? BruteForceTruth::nearest_double(*nearest)
                                       : -std::numeric_limits<double>::infinity());
      }
    }
    return result;
  }

 protected:
  BruteForceWorldTruth(int width, int height) : width_(width), height_(height) {}

  /// Homogeneous; in the picture x and y are in pixels. `unit` is 1 for world coordinates.
  struct Vertex {
    Q x, y, z, w, unit = 1;
    Q u, v;    // x and y in the picture
    Q toward;  // z of view-plane coordinates
  };
  /// a + b e - c e^2: a value at the centre and its growth along x and along y.
  struct Value {
    Q at, along_x, along_y;
    int sign() const {
      if (at != 0) return sgn(at);
      return along_x != 0 ? sgn(along_x) : -sgn(along_y);
    }
  };
  struct Polygon {
    std::vector<Vertex> vertices;
    std::array<std::size_t, 3> support;
    std::optional<std::array<Vertex, 3>> plane;  // its depth is that of; nothing: of the support
    std::int32_t pick;
    std::optional<Q> back, front;  // where planes clip, in view-plane coordinates
    bool eye;
  };
  struct Walk {
    std::map<std::int32_t, std::vector<Point3>>& drawn;
    std::int32_t id = -1;
    void fill(const FillStyle&) {}
    void line_style(const LineStyle&) {}
    void pick(std::int32_t pick) { id = pick; }
    void move(const Point3&) {}
    void line(const Point3&) {}
    void polygon(std::span<const Point3> vertices, std::span<const std::int32_t>) {
      drawn[id].assign(vertices.begin(), vertices.end());
    }
  };

  void enter(const RetainedScene& scene, const RetainedScene::Segment& part,
             const ImageTransformation& image) {
    const ViewVolume volume(part.view);
    const View& view = part.view;
    for (std::uint32_t i = part.first; i < part.end; ++i) {
      if (scene[i].is_line() || scene.attributes(i).fill.kind != FillStyle::Kind::solid) continue;
      const Looking look{volume, view, image};
      Polygon polygon = seen_through(look, scene[i].pick);
      for (const Point3& p : scene.points(i)) {
        polygon.vertices.push_back(vertex(look, {Q(p.x), Q(p.y), Q(p.z)}));
      }
      if (scene.attributes(i).back_face_removal && turned_away(polygon)) continue;
      polygon.support = support_of(polygon);
      polygons_.push_back(polygon);
    }
  }

  struct Looking {
    const ViewVolume& volume;
    const View& view;
    const ImageTransformation& image;
  };
  static Polygon seen_through(const Looking& look, std::int32_t pick) {
    const View& view = look.view;
    Polygon polygon{{}, {0, 1, 2}, std::nullopt, pick, std::nullopt, std::nullopt, false};
    if (view.back_clipping) polygon.back = Q(view.distance - view.back);
    if (view.front_clipping) polygon.front = Q(view.distance - view.front);
    polygon.eye = !polygon.front && view.projection == View::Projection::perspective;
    return polygon;
  }
  Vertex vertex(const Looking& look, const Place& p) const {
    const glm::dmat4 &m = look.volume.matrix(), &plane = look.volume.view_plane();
    const Rectangle& port = look.view.viewport;
    const ImageMatrix on_image(look.image);
    const auto entry = [&](const HomogeneousPoint& basis, int row) {
      return Q(on_image.apply(basis)[row]);
    };
    const auto along = [&](const glm::dmat4& of, int r) -> Q {
      return Q(of[0][r]) * p[0] + Q(of[1][r]) * p[1] + Q(of[2][r]) * p[2] + Q(of[3][r]);
    };
    Vertex v{along(m, 0), along(m, 1), along(m, 2), along(m, 3), 1, 0, 0, along(plane, 2)};
    const Q x = Q(port.x_min) * (v.w - v.x) + Q(port.x_max) * v.x;
    const Q y = Q(port.y_min) * (v.w - v.y) + Q(port.y_max) * v.y;
    const auto on = [&](int r) -> Q {
      return entry({1, 0, 0, 0}, r) * x + entry({0, 1, 0, 0}, r) * y + entry({0, 0, 0, 1}, r) * v.w;
    };
    v.u = on(0) * width_;
    v.v = on(1) * height_;
    return v;
  }

  /// True if a triangle or a convex polygon faces away from the viewer.
  static bool turned_away(const Polygon& polygon) {
    const auto& v = polygon.vertices;
    for (std::size_t i = 2; i < v.size(); ++i) {
      const Q area = determinant({v[0].x, v[0].y, v[0].w}, {v[i - 1].x, v[i - 1].y, v[i - 1].w},
                                 {v[i].x, v[i].y, v[i].w});
      if (area != 0) return area < 0;
    }
    return true;
  }

  /// Those of the vertices in the display file, if all are there.
  std::array<std::size_t, 3> support_of(const Polygon& polygon) const {
    const auto& v = polygon.vertices;
    const auto found = vertices_drawn_.find(polygon.pick);
    if (v.size() > 3 && found != vertices_drawn_.end() && found->second.size() == v.size()) {
      const std::vector<Point3>& d = found->second;
      std::size_t q = 0, r = 0;
      double most = 0.0;
      for (std::size_t i = 1; i < d.size(); ++i) {
        const double x = d[i].x - d[0].x, y = d[i].y - d[0].y, here = x * x + y * y;
        if (here > most) most = here, q = i;
      }
      most = 0.0;
      for (std::size_t i = 1; i < d.size(); ++i) {
        const double here =
            std::abs((d[q].x - d[0].x) * (d[i].y - d[0].y) - (d[q].y - d[0].y) * (d[i].x - d[0].x));
        if (here > most) most = here, r = i;
      }
      // Clipping may leave as many vertices, but others.
      if (most > 0.0 && picture_determinant(v[0], v[q], v[r]) != 0) return {0, q, r};
    }
    for (std::size_t q = 1; q < v.size(); ++q) {
      for (std::size_t r = q + 1; r < v.size(); ++r) {
        if (picture_determinant(v[0], v[q], v[r]) != 0) return {0, q, r};
      }
    }
    return {0, 1, 2};
  }

  using Row = std::array<Q, 3>;
  static Q determinant(const Row& a, const Row& b, const Row& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  static Q picture_determinant(const Vertex& a, const Vertex& b, const Vertex& c) {
    return determinant({a.u, a.v, a.w}, {b.u, b.v, b.w}, {c.u, c.v, c.w});
  }

  /// The weights of the triangle's vertices that give the homogeneous point (x, y, 1) of the
  /// picture; nothing if the triangle is edge-on.
  static std::optional<std::array<Value, 3>> parts_at(const Vertex& a, const Vertex& b,
                                                      const Vertex& c, const Q& x, const Q& y) {
    const Q all = picture_determinant(a, b, c);
    if (all == 0) return std::nullopt;
    const auto part = [&](const Vertex& p, const Vertex& q) {
      const Row r = {p.u, p.v, p.w}, s = {q.u, q.v, q.w};
      return Value{determinant({x, y, 1}, r, s) / all, determinant({1, 0, 0}, r, s) / all,
                   determinant({0, 1, 0}, r, s) / all};
    };
    return std::array{part(b, c), part(c, a), part(a, b)};
  }

  static Value sum(const std::array<Value, 3>& parts, const Q& a, const Q& b, const Q& c) {
    const auto of = [&](Q Value::*m) -> Q {
      return parts[0].*m * a + parts[1].*m * b + parts[2].*m * c;
    };
    return {of(&Value::at), of(&Value::along_x), of(&Value::along_y)};
  }

  /// Nothing if the centre is not covered.
  static std::optional<Q> depth_at(const Polygon& polygon, const Q& x, const Q& y) {
    const auto& v = polygon.vertices;
    const auto& [p, q, r] = polygon.support;
    const auto on_plane = parts_at(v[p], v[q], v[r], x, y);
    if (!on_plane) return std::nullopt;
    bool covered = false;
    for (std::size_t i = 2; i < v.size(); ++i) {
      const auto parts = parts_at(v[0], v[i - 1], v[i], x, y);
      if (!parts) continue;
      covered ^= std::ranges::all_of(*parts, [](const Value& part) { return part.sign() > 0; });
    }
    if (!covered) return std::nullopt;
    const auto &of_p = v[p], &of_q = v[q], &of_r = v[r];
    const auto value = [&](auto&& of) { return sum(*on_plane, of(of_p), of(of_q), of(of_r)); };
    const auto is_outside = [&](auto&& of) { return value(of).sign() < 0; };
    if (is_outside([](const Vertex& a) -> Q { return a.x; }) ||
        is_outside([](const Vertex& a) -> Q { return a.w - a.x; }) ||
        is_outside([](const Vertex& a) -> Q { return a.y; }) ||
        is_outside([](const Vertex& a) -> Q { return a.w - a.y; })) {
      return std::nullopt;
    }
    if (polygon.back &&
        is_outside([&](const Vertex& a) -> Q { return a.toward - *polygon.back * a.unit; })) {
      return std::nullopt;
    }
    if (polygon.front &&
        is_outside([&](const Vertex& a) -> Q { return *polygon.front * a.unit - a.toward; })) {
      return std::nullopt;
    }
    if (polygon.eye && is_outside([](const Vertex& a) -> Q { return a.w - Q(1e-6) * a.unit; })) {
      return std::nullopt;
    }
    if (!polygon.plane) return value([](const Vertex& a) -> Q { return a.z; }).at;
    const auto& [a, b, c] = *polygon.plane;
    const auto parts = parts_at(a, b, c, x, y);
    return sum(*parts, a.z, b.z, c.z).at;
  }

  int width_, height_;
  std::map<std::int32_t, std::vector<Point3>> vertices_drawn_;  // by pick identifier
  std::vector<Polygon> polygons_;                               // in order of entry
};

}  // namespace displayfile::test
