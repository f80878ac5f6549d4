#include "interp/visibility/world_rays.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <utility>

#include "clip/corners.h"
#include "clip/error.h"
#include "clip/view_volume.h"
#include "hidden/exact/ball.h"
#include "hidden/exact/exact_number.h"
#include "hidden/exact/plane.h"
#include "hidden/exact/support_plane.h"
#include "hidden/parallel.h"

namespace displayfile {

namespace {

// ---- One algorithm, two precisions: numbers are balls first, then exact ------------------------

constexpr int kUndecided = 2;
int sign_of(const Ball& a) { return decided(a) ? decided_sign(a.middle) : kUndecided; }
int sign_of(const ExactNumber& a) { return a.sign(); }

template <class Number>
Number number(double value);
template <>
Ball number(double value) {
  return {value, 0.0};
}
template <>
ExactNumber number(double value) {
  return ExactNumber(value);
}

/// World coordinates, homogeneous; w is positive.
template <class Number>
struct WorldPoint {
  Number x, y, z, w;
};

/// A x + B y + C z + D w.
template <class Number>
struct Linear {
  Number a, b, c, d;
  Number at(const WorldPoint<Number>& p) const { return a * p.x + b * p.y + c * p.z + d * p.w; }

  friend Linear operator+(const Linear& f, const Linear& g) {
    return {f.a + g.a, f.b + g.b, f.c + g.c, f.d + g.d};
  }
  friend Linear operator-(const Linear& f, const Linear& g) {
    return {f.a - g.a, f.b - g.b, f.c - g.c, f.d - g.d};
  }
  Linear times(const Number& s) const { return {a * s, b * s, c * s, d * s}; }
};

/// The rows of the view's matrix, those of x and y to the viewport: a point's device coordinates
/// are x / w, y / w and z / w.
template <class Number>
struct ViewRows {
  Linear<Number> x, y, z, w;
  std::vector<Linear<Number>> clip{};  // not negative in front of the eye, and between the planes

  ViewRows(const View& view, const ViewVolume& volume) {
    const glm::dmat4& m = volume.matrix();
    const auto row = [&](int i) -> Linear<Number> {
      return {number<Number>(m[0][i]), number<Number>(m[1][i]), number<Number>(m[2][i]),
              number<Number>(m[3][i])};
    };
    z = row(2);
    w = row(3);
    const auto between = [&](double low, double high, int i) {
      if (low == 0.0 && high == 1.0) return row(i);
      return w.times(number<Number>(low)) +
             row(i).times(number<Number>(high) - number<Number>(low));
    };
    x = between(view.viewport.x_min, view.viewport.x_max, 0);
    y = between(view.viewport.y_min, view.viewport.y_max, 1);
    if (view.back_clipping) clip.push_back(z);
    if (view.front_clipping) {
      clip.push_back(w - z);
    } else if (view.projection == View::Projection::perspective) {
      Linear<Number> beyond = w;  // inside_distance's, of the plane at the eye
      const double least_w = -volume.inside_distance(ClipPlane::eye, HomogeneousPoint(0.0));
      beyond.d = beyond.d - number<Number>(least_w);
      clip.push_back(beyond);
    }
  }
};

/// A ray is where the plane through a column of pixel centres and the eye meets that through a
/// row. Points right of the column and above the row are on the positive sides.
template <class Number>
struct Ray {
  Linear<Number> column, row;
};
/// A device coordinate as a quotient of doubles, as that of a pixel's centre is exactly.
struct Quotient {
  double above, below;
};
Quotient centre(int pixel, int pixels) { return {2.0 * pixel + 1.0, 2.0 * pixels}; }

/// All points whose device coordinate is that; `along` is its row of the view's.
template <class Number>
Linear<Number> plane_at(const Linear<Number>& along, const Quotient& at, const Linear<Number>& w) {
  return along.times(number<Number>(at.below)) - w.times(number<Number>(at.above));
}

template <class Number>
WorldPoint<Number> world_point(const Point3& p) {
  return {number<Number>(p.x), number<Number>(p.y), number<Number>(p.z), number<Number>(1.0)};
}

/// A vertex moved along an axis on to the plane through p, q and r.
template <class Number>
WorldPoint<Number> moved_on_to_plane(const Point3& v, const std::array<Point3, 3>& plane,
                                     int axis) {
  const auto difference = [](const Point3& a, const Point3& b) -> std::array<Number, 3> {
    return {number<Number>(a.x) - number<Number>(b.x), number<Number>(a.y) - number<Number>(b.y),
            number<Number>(a.z) - number<Number>(b.z)};
  };
  const auto e = difference(plane[1], plane[0]), f = difference(plane[2], plane[0]);
  const auto to = difference(v, plane[0]);
  std::array<Number, 3> n{e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2],
                          e[0] * f[1] - e[1] * f[0]};
  Number off = n[0] * to[0] + n[1] * to[1] + n[2] * to[2];
  const auto k = static_cast<std::size_t>(axis);
  Number scale = n[k];
  if (sign_of(scale) < 0) scale = -scale, off = -off;
  std::array<Number, 3> moved{number<Number>(v.x) * scale, number<Number>(v.y) * scale,
                              number<Number>(v.z) * scale};
  moved[k] = moved[k] - off;
  return {moved[0], moved[1], moved[2], scale};
}

/// Sutherland and Hodgman's step; false where it is undecided what is cut. It is not the clip
/// pipeline's, which divides and rounds: here exact numbers must say the same as rounded ones.
template <class Number>
bool clip(const Linear<Number>& inside, std::vector<WorldPoint<Number>>& points,
          std::vector<WorldPoint<Number>>& cut) {
  cut.clear();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const WorldPoint<Number>& a = points[previous_corner(i, points.size())];
    const WorldPoint<Number>& b = points[i];
    const Number at_a = inside.at(a), at_b = inside.at(b);
    const int sign_a = sign_of(at_a), sign_b = sign_of(at_b);
    if (sign_a == kUndecided || sign_b == kUndecided) return false;
    if ((sign_a < 0) != (sign_b < 0)) {
      const Number s = sign_a < 0 ? -at_a : at_a, t = sign_a < 0 ? at_b : -at_b;  // not negative
      cut.push_back({b.x * s + a.x * t, b.y * s + a.y * t, b.z * s + a.z * t, b.w * s + a.w * t});
    }
    if (sign_b >= 0) cut.push_back(b);
  }
  points.swap(cut);
  return true;
}

/// Even-odd, as interp/truth/truth.md defines it: 1, 0, or kUndecided.
template <class Number>
int covers(const std::vector<WorldPoint<Number>>& points, const Ray<Number>& ray) {
  if (points.empty()) return 0;
  bool covered = false;
  Number from_u = ray.column.at(points.back()), from_v = ray.row.at(points.back());
  int from_side = sign_of(from_v);
  for (const WorldPoint<Number>& point : points) {
    Number u = ray.column.at(point), v = ray.row.at(point);
    const int side = sign_of(v);
    if (side == kUndecided || from_side == kUndecided) return kUndecided;
    if ((from_side < 0) != (side < 0)) {
      const int crossing = sign_of(from_u * v - u * from_v);
      if (crossing == kUndecided) return kUndecided;
      if ((from_side < 0 ? crossing : -crossing) <= 0) covered = !covered;
    }
    from_u = std::move(u);
    from_v = std::move(v);
    from_side = side;
  }
  return covered ? 1 : 0;
}

/// Where a ray meets a plane: the sum of three of its points, each weighted by what the ray's
/// planes make of the other two.
template <class Number>
struct Hit {
  Number z, w;                ///< the depth in the view is z / w
  Number nearness, of_world;  ///< what hides what is less, is their quotient
};
template <class Number>
Number cross(const Number& au, const Number& av, const Number& bu, const Number& bv) {
  return au * bv - av * bu;
}
template <class Number>
Hit<Number> hit_of(const std::array<Point3, 3>& plane, const Ray<Number>& ray,
                   const ViewRows<Number>& view, bool perspective) {
  std::array<WorldPoint<Number>, 3> p;
  std::array<Number, 3> u, v;
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = world_point<Number>(plane[i]);
    u[i] = ray.column.at(p[i]);
    v[i] = ray.row.at(p[i]);
  }
  Hit<Number> hit{number<Number>(0.0), number<Number>(0.0), number<Number>(0.0),
                  number<Number>(0.0)};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const Number weight = cross(u[j], v[j], u[k], v[k]);
    hit.z = hit.z + weight * view.z.at(p[i]);
    hit.w = hit.w + weight * view.w.at(p[i]);
    hit.of_world = hit.of_world + weight;
  }
  hit.nearness = perspective ? -hit.w : hit.z;
  return hit;
}

/// The same point, rounded, in world coordinates.
Point3 point_hit(const std::array<Point3, 3>& plane, const Ray<ExactNumber>& ray) {
  std::array<ExactNumber, 3> u, v, sum;
  for (std::size_t i = 0; i < 3; ++i) {
    u[i] = ray.column.at(world_point<ExactNumber>(plane[i]));
    v[i] = ray.row.at(world_point<ExactNumber>(plane[i]));
  }
  ExactNumber weights;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const ExactNumber weight = cross(u[j], v[j], u[k], v[k]);
    weights = weights + weight;
    for (int axis = 0; axis < 3; ++axis) {
      auto& of_axis = sum[static_cast<std::size_t>(axis)];
      of_axis = of_axis + weight * ExactNumber(plane[i][axis]);
    }
  }
  return {rounded_quotient(sum[0], weights), rounded_quotient(sum[1], weights),
          rounded_quotient(sum[2], weights)};
}

/// The sign of a's depth less b's, or kUndecided. Neither is edge-on.
template <class Number>
int compare(const Hit<Number>& a, const Hit<Number>& b) {
  const int difference = sign_of(a.z * b.w - b.z * a.w);
  const int of_a = sign_of(a.w), of_b = sign_of(b.w);
  if (difference == kUndecided || of_a == kUndecided || of_b == kUndecided) return kUndecided;
  return difference * of_a * of_b;
}

/// A linear function over boxes none of whose coordinates is larger than `size`, wide enough for
/// all rounding.
class OverBoxes {
 public:
  OverBoxes(const Linear<Ball>& f, const Point3& size)
      : normal_{f.a.middle, f.b.middle, f.c.middle} {
    const double error = error_of(f.a) * size.x + error_of(f.b) * size.y + error_of(f.c) * size.z +
                         2.0 * error_of(f.d) + kTiny;
    least_offset_ = f.d.middle - 2.0 * error;
    most_offset_ = f.d.middle + 2.0 * error;
  }

  using EachBox = std::array<double, SpaceBoxes::kBoxes>;
  /// No point of a box has less; it is at a corner, known by the signs.
  EachBox least(const SpaceBoxes& boxes) const {
    return at_corners(boxes.low, boxes.high, least_offset_);
  }
  EachBox most(const SpaceBoxes& boxes) const {
    return at_corners(boxes.high, boxes.low, most_offset_);
  }

 private:
  /// Looks at one axis after the other, as rising or falling along it says.
  template <class Sides>
  EachBox at_corners(const Sides& rising, const Sides& falling, double offset) const {
    const auto& x = normal_[0] < 0.0 ? falling[0] : rising[0];
    const auto& y = normal_[1] < 0.0 ? falling[1] : rising[1];
    const auto& z = normal_[2] < 0.0 ? falling[2] : rising[2];
    EachBox values;
    for (std::size_t k = 0; k < values.size(); ++k) {
      values[k] = normal_[0] * x[k] + normal_[1] * y[k] + normal_[2] * z[k] + offset;
    }
    return values;
  }
  /// In place of the eight or fewer roundings of one unit that a term takes part in.
  static double error_of(const Ball& of) { return of.radius + 16.0 * kUnit * std::abs(of.middle); }

  std::array<double, 3> normal_;
  double least_offset_, most_offset_;
};

Point3 newell_normal(std::span<const Point3> polygon) {
  Point3 sum(0.0), from = polygon.back() - polygon[0];
  for (const Point3& vertex : polygon) {
    const Point3 to = vertex - polygon[0];
    sum += glm::cross(from, to);
    from = to;
  }
  return sum;
}

std::array<Point3, 3> plane_of(std::span<const Point3> points,
                               const std::array<std::uint32_t, 3>& spread) {
  return {points[spread[0]], points[spread[1]], points[spread[2]]};
}

}  // namespace

// ---- The world, once for all views --------------------------------------------------------------

WorldRays::WorldRays(const RetainedScene& scene, const DisplayFile& attributes)
    : world_(scene.visible_in(attributes)) {
  for (const RetainedScene::Segment& segment : world_.segments()) {
    if (!attributes.segment(segment.name).image.is_identity()) {
      throw Error("segment " + std::to_string(segment.name) +
                  " has an image transformation, which acts after viewing: expected none");
    }
  }
  for (std::uint32_t i = 0; i < world_.size(); ++i) enter(i);
  build();
}

void WorldRays::enter(std::uint32_t primitive) {
  const auto& attributes = world_.shared_attributes(primitive);
  if (world_[primitive].is_line() || attributes.fill.kind != FillStyle::Kind::solid) return;
  const auto polygon = world_.points(primitive);
  const SupportVertices spread = spread_vertices(polygon);
  if (spread.edge_on) return;
  const auto [p, q, r] = plane_of(polygon, spread.index);
  const Plane plane(p, q, r);
  const bool flat = std::ranges::all_of(polygon, [&](const Point3& v) {
    return plane.goes_through(v) || side_of_plane(v, plane) == 0;
  });
  const bool same_way = glm::dot(newell_normal(polygon), plane.normal) >= 0.0;
  polygons_.push_back({primitive, spread.index, static_cast<std::int8_t>(same_way ? 1 : -1),
                       static_cast<std::int8_t>(facing_axis(plane)), flat,
                       !attributes.back_face_removal});
}

Bounds WorldRays::bounds_of(const Polygon& polygon) const {
  Bounds bounds;
  for (const Point3& p : points(polygon)) bounds.include(p);
  if (polygon.flat) return bounds;
  // A vertex off the plane by h is moved by no more than sqrt(3) h.
  const Point3 wider(4.0 * world_.off_plane(polygon.primitive));
  const auto outward = [&](const Point3& p) { return wider + 8.0 * kUnit * glm::abs(p) + kTiny; };
  return {bounds.low - outward(bounds.low), bounds.high + outward(bounds.high)};
}

void WorldRays::build() {
  const auto bounds = [&](SpaceTree::Item i) {
    const Bounds box = bounds_of(polygons_[i]);
    size_ = glm::max(size_, glm::max(glm::abs(box.low), glm::abs(box.high)));
    return box;
  };
  tree_.build(polygons_.size(), bounds, 1);
  std::vector<Polygon> ordered;
  ordered.reserve(polygons_.size());
  for (const SpaceTree::Item item : tree_.order()) ordered.push_back(polygons_[item]);
  polygons_ = std::move(ordered);
}

// ---- The rays of a view -------------------------------------------------------------------------

class WorldRays::Caster {
 public:
  Caster(const WorldRays& world, const View& view, std::function<bool(std::uint32_t)> is_there)
      : world_(world),
        is_there_(std::move(is_there)),
        perspective_(view.projection == View::Projection::perspective),
        volume_(view),
        near_(view, volume_),
        exact_(view, volume_),
        nearness_(
            perspective_ ? Linear<Ball>{-near_.w.a, -near_.w.b, -near_.w.c, -near_.w.d} : near_.z,
            world.size_) {}

  /// All rays of a column or of a row of pixels, or of a point, lie in a plane.
  struct Side {
    Quotient at;
    Linear<Ball> plane;
    OverBoxes over_boxes;
  };
  Side column(const Quotient& at) const { return side(near_.x, at); }
  Side row(const Quotient& at) const { return side(near_.y, at); }

  /// One ray, and what it has hit so far.
  struct Work {
    const Side *column, *row;
    Ray<Ball> near;
    std::optional<Ray<ExactNumber>> exact;
    const Polygon* seen;
    Hit<Ball> hit;
    double hidden;  // nothing less near is seen
    std::vector<WorldPoint<Ball>> points, cut;
  };

  /// The primitive seen, or kNothing.
  std::uint32_t cast(const Side& column, const Side& row, Work& work) const {
    work.column = &column;
    work.row = &row;
    work.near = {column.plane, row.plane};
    work.exact.reset();
    work.seen = nullptr;
    work.hidden = -std::numeric_limits<double>::infinity();
    const auto meets = [&](const SpaceBoxes& boxes, OverBoxes::EachBox& nearest) {
      const auto left = column.over_boxes.least(boxes), right = column.over_boxes.most(boxes);
      const auto lowest = row.over_boxes.least(boxes), highest = row.over_boxes.most(boxes);
      nearest = nearness_.most(boxes);
      SpaceTree::Lanes met;
      for (std::size_t k = 0; k < met.size(); ++k) {
        // Where a bound is no number nothing is known to be missed.
        const int missed = static_cast<int>(left[k] > 0.0) | static_cast<int>(right[k] < 0.0) |
                           static_cast<int>(lowest[k] > 0.0) | static_cast<int>(highest[k] < 0.0);
        met[k] = 1 - missed;
      }
      return met;
    };
    world_.tree_.near_to_far<double>(
        meets, [&](double nearest) { return nearest < work.hidden; },
        [&](SpaceTree::Position at) { intersect(world_.polygons_[at], work); });
    return work.seen == nullptr ? kNothing : work.seen->primitive;
  }

  /// Where the ray cast last hits what it sees.
  Point3 point_seen(Work& work) const {
    return point_hit(plane_of(world_.points(*work.seen), work.seen->spread), exact_ray(work));
  }

 private:
  Side side(const Linear<Ball>& along, const Quotient& at) const {
    const Linear<Ball> plane = plane_at(along, at, near_.w);
    return {at, plane, OverBoxes(plane, world_.size_)};
  }

  void intersect(const Polygon& polygon, Work& work) const {
    int covered = kUndecided;
    if (is_there_ && !is_there_(polygon.primitive)) return;
    const bool known = vertices_of(polygon, near_, work.points, work.cut);
    if (known) covered = covers(work.points, work.near);
    if (covered == kUndecided) covered = covers_exactly(polygon, work);
    if (covered == 0) return;
    const auto plane = plane_of(world_.points(polygon), polygon.spread);
    const Hit<Ball> hit = hit_of(plane, work.near, near_, perspective_);
    int facing = sign_of(hit.w);
    if (facing == kUndecided) {
      facing = sign_of(hit_of(plane, exact_ray(work), exact_, perspective_).w);
    }
    if (facing == 0 || (!polygon.both_sides && facing * polygon.turn < 0)) return;
    if (work.seen != nullptr && !is_seen(polygon, hit, work)) return;
    work.seen = &polygon;
    work.hit = hit;
    const Ball nearness = hit.nearness / hit.of_world;
    const double least = nearness.middle - 2.0 * nearness.radius;
    work.hidden = least == least ? least : -std::numeric_limits<double>::infinity();
  }

  /// Rather than what the ray has hit so far.
  bool is_seen(const Polygon& polygon, const Hit<Ball>& hit, Work& work) const {
    int order = compare(hit, work.hit);
    if (order == kUndecided) {
      const Ray<ExactNumber>& ray = exact_ray(work);
      const auto exact_hit = [&](const Polygon& of) {
        return hit_of(plane_of(world_.points(of), of.spread), ray, exact_, perspective_);
      };
      order = compare(exact_hit(polygon), exact_hit(*work.seen));
    }
    return order != 0 ? order > 0 : polygon.primitive > work.seen->primitive;
  }

  int covers_exactly(const Polygon& polygon, Work& work) const {
    std::vector<WorldPoint<ExactNumber>> points, cut;
    vertices_of(polygon, exact_, points, cut);
    return covers(points, exact_ray(work));
  }

  const Ray<ExactNumber>& exact_ray(Work& work) const {
    if (!work.exact) {
      work.exact = Ray<ExactNumber>{plane_at(exact_.x, work.column->at, exact_.w),
                                    plane_at(exact_.y, work.row->at, exact_.w)};
    }
    return *work.exact;
  }

  /// In its plane, and clipped; false if that is undecided.
  template <class Number>
  bool vertices_of(const Polygon& polygon, const ViewRows<Number>& view,
                   std::vector<WorldPoint<Number>>& points,
                   std::vector<WorldPoint<Number>>& cut) const {
    points.clear();
    const auto of = world_.points(polygon);
    const auto plane = plane_of(of, polygon.spread);
    for (const Point3& v : of) {
      points.push_back(polygon.flat ? world_point<Number>(v)
                                    : moved_on_to_plane<Number>(v, plane, polygon.axis));
      if (sign_of(points.back().w) == kUndecided) return false;
    }
    for (const Linear<Number>& inside : view.clip) {
      if (!clip(inside, points, cut)) return false;
    }
    return true;
  }

  const WorldRays& world_;
  std::function<bool(std::uint32_t)> is_there_;
  bool perspective_;
  ViewVolume volume_;
  ViewRows<Ball> near_;
  ViewRows<ExactNumber> exact_;
  OverBoxes nearness_;
};

/// The rays through the pixel centres of a viewport.
class WorldRays::PictureRays {
 public:
  PictureRays(const WorldRays& world, const View& view, const PictureSize& size,
              std::function<bool(std::uint32_t)> is_there)
      : caster_(world, view, std::move(is_there)), viewport_(view.viewport), size_(size) {
    for (int column = 0; column < size.width; ++column) {
      columns_.push_back(caster_.column(centre(column, size.width)));
    }
  }

  void cast_row(int row, std::span<std::uint32_t> seen) const {
    std::ranges::fill(seen, kNothing);
    if (compare_with_centres(viewport_.y_min, size_.height, row) >= 0 ||
        compare_with_centres(viewport_.y_max, size_.height, row) < 0) {
      return;
    }
    Caster::Work work;
    const Caster::Side row_side = caster_.row(centre(row, size_.height));
    for (int column = 0; column < size_.width; ++column) {
      if (compare_with_centres(viewport_.x_min, size_.width, column) > 0 ||
          compare_with_centres(viewport_.x_max, size_.width, column) <= 0) {
        continue;
      }
      const auto k = static_cast<std::size_t>(column);
      seen[k] = caster_.cast(columns_[k], row_side, work);
    }
  }

 private:
  Caster caster_;
  Rectangle viewport_;
  PictureSize size_;
  std::vector<Caster::Side> columns_;
};

WorldRays::CastRow WorldRays::rays(const View& view, const PictureSize& size,
                                   std::function<bool(std::uint32_t)> is_there) const {
  const auto rays = std::make_shared<const PictureRays>(*this, view, size, std::move(is_there));
  return [rays](int row, std::span<std::uint32_t> seen) { rays->cast_row(row, seen); };
}

std::vector<std::int32_t> WorldRays::picks(const View& view, const PictureSize& size,
                                           int threads) const {
  const auto width = static_cast<std::size_t>(size.width);
  std::vector<std::int32_t> picks(width * static_cast<std::size_t>(size.height));
  const PictureRays rays(*this, view, size, {});
  const auto cast_row = [&](std::size_t from_top) {
    std::vector<std::uint32_t> seen(width);
    rays.cast_row(size.height - 1 - static_cast<int>(from_top), seen);
    const auto pick = [&](std::uint32_t i) { return i == kNothing ? -1 : world_[i].pick; };
    std::ranges::transform(seen, picks.begin() + static_cast<std::ptrdiff_t>(from_top * width),
                           pick);
  };
  in_parallel(threads, static_cast<std::size_t>(size.height), cast_row);
  return picks;
}

/// Edges of the viewport are covered as a polygon's are: the left and the upper one.
std::optional<WorldRays::Seen> WorldRays::seen_at(const View& view, const Point2& at) const {
  const Rectangle& viewport = view.viewport;
  const Caster caster(*this, view, {});
  const bool inside = at.x >= viewport.x_min && at.x < viewport.x_max && at.y > viewport.y_min &&
                      at.y <= viewport.y_max;
  if (!inside) return std::nullopt;
  Caster::Work work;
  const Caster::Side column = caster.column({at.x, 1.0}), row = caster.row({at.y, 1.0});
  const std::uint32_t primitive = caster.cast(column, row, work);
  if (primitive == kNothing) return std::nullopt;
  return Seen{primitive, caster.point_seen(work)};
}

}  // namespace displayfile
