#include "interp/raster/shadows.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "hidden/exact/rounding.h"
#include "hidden/exact/support_plane.h"
#include "interp/device/picture.h"
#include "interp/visibility/fill_depths.h"

namespace displayfile {

namespace {

/// The largest displacement by rounding, on the way into the display file, of a vertex from its
/// intended plane, as a fraction of the picture's side. It exceeds all errors of the matrices
/// unless the scene is thousands of times farther from the origin than it is large.
constexpr double kVertexError = 0x1p-40;

/// A safety factor for terms that the bounds omit, and for their own rounding.
constexpr double kSafety = 2.0;

/// A thickness without bound.
constexpr double kNotBounded = std::numeric_limits<double>::infinity();

/// Bounds the plane's values at points of the polygon: its vertices' distances from the plane, plus
/// rounding or the tolerance for touching.
double largest_value(std::span<const Point3> vertices, const Plane& plane,
                     double vertex_error = kVertexError) {
  double largest = 0.0;
  for (const Point3& v : vertices) {
    const auto [value, bound] = plane_value(v, plane);
    largest = std::max(largest, std::abs(value) + bound);
  }
  return kSafety * (largest + vertex_error * plane.reach);
}

}  // namespace

Shadows::Shadows(const ViewedScene& scene) : scene_(&scene) {
  for (ViewedScene::Item item = 0; item < scene.items(); ++item) {
    if (scene.kind(item) != Primitives::Kind::solid) continue;
    const Polygon caster = caster_of(item);
    if (caster.thickness < kNotBounded) casters_.push_back(caster);
  }
  build_tree();
}

void Shadows::take(const ViewedScene& scene, RetainedCasters& retained) {
  scene_ = &scene;
  retained_ = &retained;
  of_items_.forget(scene.items());
  take_lights();
}

/// The plane is that of the vertices that spread the most in space: a polygon edge-on to the viewer
/// has none in the picture.
Shadows::Polygon Shadows::caster_of(ViewedScene::Item item) const {
  const auto vertices = scene_->points(item);
  const SupportVertices spread = spread_vertices(vertices);
  if (spread.edge_on || !std::ranges::all_of(vertices, in_range)) {
    return {Point3(0.0), Point3(0.0), kNotBounded, item};
  }
  const auto& [p, q, r] = spread.index;
  const Plane plane(vertices[p], vertices[q], vertices[r]);
  const double vertex_error = std::max(kVertexError, scene_->touching_of_ends());
  return {plane.p, plane.normal, largest_value(vertices, plane, vertex_error), item};
}

/// Boxes are enlarged by more than the rounding of the ray tests.
void Shadows::build_tree() {
  double largest = 1.0;
  for (const Polygon& caster : casters_) {
    for (const Point3& v : scene_->points(caster.item)) {
      largest = std::max({largest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    }
  }
  const Point3 margin(64.0 * kUnit * largest);
  const auto bounds_of = [&](SpaceTree::Item i) -> Bounds {
    Bounds box;
    for (const Point3& v : scene_->points(casters_[i].item)) box.include(v);
    return {box.low - margin, box.high + margin};
  };
  tree_.build(casters_.size(), bounds_of, 1);
  std::vector<Polygon> ordered;
  ordered.reserve(casters_.size());
  for (const SpaceTree::Item item : tree_.order()) ordered.push_back(casters_[item]);
  casters_ = std::move(ordered);
}

/// A ray from a point toward the light. Seen along the ray, the point is the origin: the other
/// points are projected along it on to the plane through the origin that it crosses most steeply.
struct Shadows::Ray {
  const LitPoint& point;
  Point3 direction;  // of the points (p + u light) / (1 + u w), u from 0
  int axis, across, up;
  double across_shear, up_shear;

  explicit Ray(const LitPoint& lit)
      : point(lit), direction(Point3(lit.light) - lit.light.w * lit.at) {
    const Point3 size = glm::abs(direction);
    axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    across = (axis + 1) % 3;
    up = (axis + 2) % 3;
    across_shear = direction[across] / direction[axis];
    up_shear = direction[up] / direction[axis];
  }
  Point2 looked_at(const Point3& v) const {
    const Point3 from_point = v - point.at;
    return {from_point[across] - from_point[axis] * across_shear,
            from_point[up] - from_point[axis] * up_shear};
  }
};

/// A polygon hides the light if its plane lies between the point and the light, and the line
/// through both meets the polygon. There are no polygons where a ray passes behind the eye and
/// beyond infinity: they were clipped.
bool Shadows::hides(const Polygon& polygon, const Ray& ray) const {
  const auto& [at, depth_error, light] = ray.point;
  const double value = glm::dot(polygon.normal, at - polygon.p);
  const double touching = polygon.thickness + std::abs(polygon.normal.z) * depth_error;
  if (!(std::abs(value) > touching)) return false;
  const double side = value > 0.0 ? 1.0 : -1.0;
  const double at_light = glm::dot(polygon.normal, Point3(light) - light.w * polygon.p);
  return side * at_light < 0.0 && is_met(polygon, ray);
}

/// Decided by the even-odd rule, seen along the ray. An edge shared by two polygons is always taken
/// from its lower end: exactly one of the two is met, bit for bit.
bool Shadows::is_met(const Polygon& polygon, const Ray& ray) const {
  const auto vertices = scene_->points(polygon.item);
  bool inside = false;
  Point2 from = ray.looked_at(vertices.back());
  for (const Point3& vertex : vertices) {
    const Point2 to = ray.looked_at(vertex);
    if ((from.y > 0.0) != (to.y > 0.0)) {
      const Point2& low = from.y > 0.0 ? to : from;
      const Point2& high = from.y > 0.0 ? from : to;
      if (low.x * high.y - high.x * low.y > 0.0) inside = !inside;
    }
    from = to;
  }
  return inside;
}

const Shadows::Polygon& Shadows::polygon_of(Caster caster, Polygon& spare) const {
  if (retained_ == nullptr) return casters_[caster];
  return of_items_.at(caster, spare, [&] { return caster_of(caster); });
}

bool Shadows::is_hidden_by(Caster caster, const Ray& ray) const {
  Polygon spare;
  return hides(polygon_of(caster, spare), ray);
}

Shadows::OnFill Shadows::on(std::span<const Point3> fill, const Plane& plane,
                            const PictureSize& size) {
  const PixelDepth depth(plane, size.width, size.height);
  return {kSafety * depth_bound(fill, plane, depth, size).error +
          largest_value(fill, plane) / std::abs(plane.normal.z)};
}

Shadows::OnFill Shadows::on(ViewedScene::Fill fill, const PictureSize& size) const {
  if (retained_ == nullptr) return work_out(fill, size);
  OnFill spare;
  return on_items_.at(scene_->item_of(fill), spare, [&] { return work_out(fill, size); });
}

/// A fill seen from the light, compared with possible casters: a fast test, without a ray, that a
/// caster hides none of it. Both tests hold with all rounding of Shadows::hides.
class Shadows::FromFill {
 public:
  FromFill(std::span<const Point3> fill, const Plane& plane, const HomogeneousPoint& light,
           double off_plane, double largest_depth)
      : fill_(fill), plane_(plane), light_(light), farthest_(std::max(1.0, largest_depth)) {
    const double reach =
        std::abs(plane.normal.x) + std::abs(plane.normal.y) + std::abs(plane.normal.z);
    const double lost = kLostByRays * farthest_;
    double least = std::numeric_limits<double>::infinity(), greatest = -least, length = 0.0;
    for (const Point3& v : fill) {
      const Point3 direction = Point3(light) - light.w * v;
      const double away = glm::dot(plane.normal, direction);
      least = std::min(least, away);
      greatest = std::max(greatest, away);
      const Point3 size = glm::abs(direction);
      length = std::max(length, size.x + size.y + size.z);
    }
    side_ = least > 0.0 ? 1.0 : greatest < 0.0 ? -1.0 : 0.0;
    if (side_ == 0.0) return;
    const double rises = (side_ > 0.0 ? least : -greatest) / length;
    highest_ = (kTouchingPart - lost) * rises * kTilted - reach * lost -
               std::abs(plane.normal.z) * off_plane;
  }

  bool is_clear_of(const Polygon& caster, const PointRow& vertices) const {
    return is_before(caster) || is_above(vertices);
  }

 private:
  /// True if no point of the fill is behind the caster, seen from the light, except points that
  /// count as lying on it.
  bool is_before(const Polygon& caster) const {
    const double at_light = glm::dot(caster.normal, Point3(light_) - light_.w * caster.p);
    const double side = at_light > 0.0 ? 1.0 : -1.0;
    return std::ranges::all_of(fill_, [&](const Point3& v) {
      return side * glm::dot(caster.normal, v - caster.p) >= -0.5 * caster.thickness;
    });
  }
  /// True if rays lead away from the fill's plane, and the caster does not rise above it: only
  /// where both touch can it be met.
  bool is_above(const PointRow& vertices) const {
    return side_ != 0.0 && highest_ > 0.0 && std::ranges::all_of(vertices, [&](const Point3& v) {
             return side_ * glm::dot(plane_.normal, v - plane_.p) <= highest_ &&
                    std::abs(v.z) <= farthest_;
           });
  }

  static constexpr double kLostByRays = 64.0 * kUnit;
  /// The distance from a caster's plane up to which points count as lying on it, for any normal:
  /// less than the part of kVertexError in every thickness.
  static constexpr double kTouchingPart = kSafety * kVertexError;
  static constexpr double kTilted = 0.5;  // a safety margin for rounding here

  std::span<const Point3> fill_;
  const Plane& plane_;
  HomogeneousPoint light_;
  double farthest_;       // |z| that is allowed for
  double side_ = 0.0;     // of the plane on which the light is, for all points; or 0
  double highest_ = 0.0;  // values of the plane at what rays do not meet but near the fill
};

Shadows::OnFill Shadows::work_out(ViewedScene::Fill fill, const PictureSize& size) const {
  const ViewedScene::Item item = scene_->item_of(fill);
  const PointRow vertices = scene_->points(item);
  const Plane plane = scene_->plane(fill);
  OnFill on_fill = on(vertices, plane, size);
  if (retained_ == nullptr) return on_fill;
  const double of_vertices = kSafety * kVertexError * plane.reach / std::abs(plane.normal.z);
  const FromFill from(vertices, plane, scene_->shadow(fill)->light,
                      std::max(0.0, on_fill.depth_error - of_vertices), scene_->largest_depth());
  on_fill.search = retained_->search_on(item, on_fill.depth_error, [&](Caster other) {
    Polygon spare;
    return from.is_clear_of(polygon_of(other, spare), scene_->points(other));
  });
  return on_fill;
}

bool Shadows::hidden(const LitPoint& point, const Search& search, Caster& last) const {
  const Ray ray(point);
  if (ray.direction == Point3(0.0)) return false;
  if (last != kNone && is_hidden_by(last, ray)) return true;
  const auto hides_from_point = [&](Caster caster) {
    if (!is_hidden_by(caster, ray)) return false;
    last = caster;
    return true;
  };
  if (retained_ != nullptr) return retained_->any(search, point.at, hides_from_point);
  return tree_.any(SpaceRay(point.at, ray.direction), hides_from_point);
}

void ShadowedFill::paint(int row, int first, std::span<std::uint32_t> pixels) const {
  if (on_fill_.search.is_never_hidden()) return;
  const auto& [depth_error, search] = on_fill_;
  const double of_row = depth_.row(row);
  Shadows::Caster last = Shadows::kNone;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const int column = first + static_cast<int>(i);
    const PixelCentre centre(column, row, size_);
    const Point3 point(centre.x, centre.y, depth_.at(of_row, column));
    if (shadows_->hidden({point, depth_error, light_}, search, last)) pixels[i] = colour_;
  }
}

}  // namespace displayfile
