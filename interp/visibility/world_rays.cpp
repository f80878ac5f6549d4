#include "interp/visibility/world_rays.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <limits>
#include <memory>

#include <utility>

#include "clip/base/error.h"
#include "clip/base/parallel.h"
#include "clip/pipeline/clip_pipeline.h"
#include "clip/view/view_volume.h"
#include "displayfile/views/shared_planes.h"
#include "hidden/exact/orientation.h"
#include "hidden/exact/plane.h"
#include "interp/visibility/polygon_viewer.h"
#include "interp/visibility/world_geometry.h"

namespace displayfile {

namespace {

using namespace in_world;

/// The orientation of the triangles from a flat polygon's first vertex to its sides, seen along an
/// axis not parallel to its plane: 1 counterclockwise, -1 clockwise, 0 both or neither. If all have
/// the same orientation, so does every part of the polygon.
int way_around(std::span<const Point3> polygon, int axis) {
  const auto seen = [&](std::size_t i) {
    return Point2(polygon[i][(axis + 1) % 3], polygon[i][(axis + 2) % 3]);
  };
  bool left = false, right = false;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const int turn = orientation(seen(0), seen(i - 1), seen(i));
    left |= turn > 0;
    right |= turn < 0;
  }
  return (left ? 1 : 0) - (right ? 1 : 0);
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
  const std::vector<Primitives::PlanePoints> shared = shared_planes(world_);
  for (std::uint32_t i = 0; i < world_.size(); ++i) enter(i, shared);
  build();
}

/// None if all its vertices are collinear.
std::optional<Primitives::PlanePoints> WorldRays::plane_of(
    std::uint32_t primitive, std::span<const Primitives::PlanePoints> shared) const {
  const bool is_shared = !shared.empty() && shared[primitive][0] != Primitives::kOwnPlane;
  return is_shared ? shared[primitive] : support_plane(world_, primitive);
}

std::array<Point3, 3> WorldRays::corners_of_plane(const Polygon& polygon) const {
  const std::span<const Point3> points = world_.primitives({}).points;
  const auto& [p, q, r] = polygon.plane;
  return {points[p], points[q], points[r]};
}

void WorldRays::enter(std::uint32_t primitive, std::span<const Primitives::PlanePoints> shared) {
  const auto& attributes = world_.shared_attributes(primitive);
  if (world_[primitive].is_line() || attributes.fill.kind != FillStyle::Kind::solid) return;
  const auto through = plane_of(primitive, shared);
  if (!through) return;
  Polygon entered{.primitive = primitive,
                  .plane = *through,
                  .by_view = 0,
                  .turn = 0,
                  .flat = false,
                  .both_sides = !attributes.back_face_removal};
  const auto polygon = world_.points(primitive);
  const std::array<Point3, 3> corners = corners_of_plane(entered);
  const Plane plane(corners[0], corners[1], corners[2]);
  entered.flat = std::ranges::all_of(polygon, [&](const Point3& v) {
    return plane.goes_through(v) || side_of_plane(v, plane) == 0;
  });
  if (entered.flat) {
    const int axis = facing_axis(plane);
    entered.turn = static_cast<std::int8_t>(way_around(polygon, axis) * way_around(corners, axis));
  }
  const bool by_view = !entered.flat || (entered.turn == 0 && !entered.both_sides);
  if (!by_view) entered.by_view = Polygon::kAlike;
  polygons_.push_back(entered);
}

Bounds WorldRays::bounds_of(const Polygon& polygon) const {
  Bounds bounds;
  for (const Point3& p : points(polygon)) bounds.include(p);
  if (polygon.flat) return bounds;
  // In nearly all views its distance from the plane in which it is visible is less than this.
  constexpr double kWider = 0x1p-10;
  const Point3 size = bounds.high - bounds.low;
  const Point3 wider(kWider * std::max({size.x, size.y, size.z}) + kTiny);
  return {bounds.low - wider, bounds.high + wider};
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
  for (const SpaceTree::Item item : tree_.order()) {
    ordered.push_back(polygons_[item]);
    std::uint32_t& number = ordered.back().by_view;
    if (number == Polygon::kAlike) continue;
    number = static_cast<std::uint32_t>(by_view_.size());
    by_view_.push_back(static_cast<std::uint32_t>(ordered.size() - 1));
  }
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
            world.size_),
        boxes_hold_(world.by_view_.empty()) {}

  /// For many rays: computes once the visibility of polygons that depends on the view. If this is
  /// not called, it is computed when a ray hits one.
  void view_polygons() {
    is_seen_.resize(world_.by_view_.size());
    std::vector<Bounds> boxes;
    PolygonViewer viewer = this->viewer();
    for (const std::uint32_t at : world_.by_view_) {
      const Polygon& polygon = world_.polygons_[at];
      if (is_there_ && !is_there_(polygon.primitive)) continue;
      const bool is_seen = viewer.is_seen(world_.points(polygon), polygon.both_sides);
      is_seen_[polygon.by_view] = is_seen ? 1 : 0;
      if (!is_seen || polygon.flat) continue;
      const Bounds box = world_.bounds_of(polygon);
      const std::array<Point3, 3> plane = world_.corners_of_plane(polygon);
      if (viewer.is_nowhere_nearer(plane, nearness_.most(box))) continue;
      out_of_box_.push_back(at);
      boxes.push_back(box);
    }
    their_boxes_.build(boxes, 1);
    boxes_hold_ = true;
  }

  /// The plane of all rays of a column or a row of pixels, or of a point.
  struct Side {
    Quotient at;
    Linear<Ball> plane;
    OverBoxes over_boxes;
  };
  Side column(const Quotient& at) const { return side(near_.x, at); }
  Side row(const Quotient& at) const { return side(near_.y, at); }

  /// One ray, and its hits so far.
  struct Work {
    const Side *column, *row;
    Ray<Ball> near;
    std::optional<Ray<ExactNumber>> exact;
    const Polygon* seen;
    Hit<Ball> hit;
    double hidden;  // the nearness below which nothing is visible
    WorldPoints<Ball> points, cut;
  };

  /// The visible primitive, or kNothing.
  std::uint32_t cast(const Side& column, const Side& row, Work& work) const {
    work.column = &column;
    work.row = &row;
    work.near = {column.plane, row.plane};
    work.exact.reset();
    work.seen = nullptr;
    work.hidden = -std::numeric_limits<double>::infinity();
    world_.tree_.near_to_far<double>(
        Meets{column.over_boxes, row.over_boxes, nearness_},
        [&](double nearest) { return nearest < work.hidden; },
        [&](SpaceTree::Position at) { intersect(world_.polygons_[at], work); });
    if (!out_of_box_.empty()) cast_at_those_out_of_boxes(work);
    return work.seen == nullptr ? kNothing : work.seen->primitive;
  }

  /// The point at which the ray cast last hits the visible primitive.
  Point3 point_seen(Work& work) const {
    return point_hit(plane_of_hits<ExactNumber>(*work.seen), exact_ray(work));
  }

 private:
  Side side(const Linear<Ball>& along, const Quotient& at) const {
    const Linear<Ball> plane = plane_at(along, at, near_.w);
    return {at, plane, OverBoxes(plane, world_.size_)};
  }

  /// Tests which of eight boxes a ray meets, and how near they begin.
  struct Meets {
    const OverBoxes &column, &row, &nearness;
    SpaceTree::Lanes operator()(const SpaceBoxes& boxes, OverBoxes::EachBox& nearest) const {
      const auto left = column.least(boxes), right = column.most(boxes);
      const auto lowest = row.least(boxes), highest = row.most(boxes);
      nearest = nearness.most(boxes);
      SpaceTree::Lanes met;
      for (std::size_t k = 0; k < met.size(); ++k) {
        // Where a bound is NaN, no miss is certain.
        const int missed = static_cast<int>(left[k] > 0.0) | static_cast<int>(right[k] < 0.0) |
                           static_cast<int>(lowest[k] > 0.0) | static_cast<int>(highest[k] < 0.0);
        met[k] = 1 - missed;
      }
      return met;
    }
  };

  /// Tests the polygons that may be nearer than their boxes, whatever the ray has hit.
  void cast_at_those_out_of_boxes(Work& work) const {
    const auto meets = [&](const SpaceBoxes& boxes) {
      OverBoxes::EachBox nearest;
      return Meets{work.column->over_boxes, work.row->over_boxes, nearness_}(boxes, nearest);
    };
    their_boxes_.any(meets, [&](SpaceTree::Position at) {
      intersect(world_.polygons_[out_of_box_[their_boxes_.order()[at]]], work);
      return false;
    });
  }

  void intersect(const Polygon& polygon, Work& work) const {
    int covered = kUndecided;
    if (is_there_ && !is_there_(polygon.primitive)) return;
    const bool known = vertices_of(polygon, near_, work.points, work.cut);
    if (known) covered = covers(work.points, work.near);
    if (covered == kUndecided) covered = covers_exactly(polygon, work);
    if (covered == 0) return;
    if (polygon.by_view != Polygon::kAlike && !is_seen(polygon)) return;
    const Hit<Ball> hit = hit_of(plane_of_hits<Ball>(polygon), work.near, near_, perspective_);
    int facing = sign_of(hit.w);
    if (facing == kUndecided) facing = sign_of(exact_hit(polygon, work).w);
    if (facing == 0 || (!polygon.both_sides && facing * polygon.turn < 0)) return;
    if (work.seen != nullptr && !is_seen(polygon, hit, work)) return;
    work.seen = &polygon;
    work.hit = hit;
    const Ball nearness = hit.nearness / hit.of_world;
    const double least = nearness.middle - 2.0 * nearness.radius;
    // A plane may be visible beyond infinity, where it is not nearer than anything.
    const bool is_known =
        perspective_ ? nearness.middle + 2.0 * nearness.radius < 0.0 : least == least;
    work.hidden = is_known && boxes_hold_ ? least : -std::numeric_limits<double>::infinity();
  }

  /// True if the polygon is visible rather than the ray's hit so far.
  bool is_seen(const Polygon& polygon, const Hit<Ball>& hit, Work& work) const {
    int order = compare(hit, work.hit);
    if (order == kUndecided) {
      order = compare(exact_hit(polygon, work), exact_hit(*work.seen, work));
    }
    return order != 0 ? order > 0 : polygon.primitive > work.seen->primitive;
  }

  Hit<ExactNumber> exact_hit(const Polygon& polygon, Work& work) const {
    return hit_of(plane_of_hits<ExactNumber>(polygon), exact_ray(work), exact_, perspective_);
  }

  int covers_exactly(const Polygon& polygon, Work& work) const {
    WorldPoints<ExactNumber> points, cut;
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

  /// Clips against all planes except the sides of the window; false if that is undecided.
  template <class Number>
  bool vertices_of(const Polygon& polygon, const MatrixRows<Number>& view,
                   WorldPoints<Number>& points, WorldPoints<Number>& cut) const {
    points.clear();
    for (const Point3& v : world_.points(polygon)) points.push_back(world_point<Number>(v));
    return clip(view.clip, points, cut) != Clipping::undecided;
  }

  /// The plane that defines the visible depth.
  template <class Number>
  WorldPlane<Number> plane_of_hits(const Polygon& polygon) const {
    const std::array<Point3, 3> corners = world_.corners_of_plane(polygon);
    return {world_point<Number>(corners[0]), world_point<Number>(corners[1]),
            world_point<Number>(corners[2])};
  }

  /// True if clipping leaves a part, which does not face away: for a polygon whose visibility
  /// depends on the view.
  bool is_seen(const Polygon& polygon) const {
    if (!is_seen_.empty()) return is_seen_[polygon.by_view] != 0;
    return viewer().is_seen(world_.points(polygon), polygon.both_sides);
  }
  PolygonViewer viewer() const { return {volume_, near_, exact_, world_.size_}; }

  const WorldRays& world_;
  std::function<bool(std::uint32_t)> is_there_;
  bool perspective_;
  ViewVolume volume_;
  MatrixRows<Ball> near_;
  MatrixRows<ExactNumber> exact_;
  OverBoxes nearness_;
  std::vector<std::uint8_t> is_seen_;      // by Polygon::by_view, after view_polygons
  std::vector<std::uint32_t> out_of_box_;  // visible polygons possibly nearer than their boxes
  SpaceTree their_boxes_;
  bool boxes_hold_;  // all other polygons are no nearer than their boxes
};

/// The rays through the pixel centres of a viewport.
class WorldRays::PictureRays {
 public:
  PictureRays(const WorldRays& world, const View& view, const PictureSize& size,
              std::function<bool(std::uint32_t)> is_there)
      : caster_(world, view, std::move(is_there)), viewport_(view.viewport), size_(size) {
    caster_.view_polygons();
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

/// Edges of the viewport are covered like a polygon's: the left and the upper one.
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
