#include "displayfile/side_kinds.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <tuple>

#include "clip/back_face.h"
#include "clip/corners.h"
#include "clip/point.h"
#include "hidden/exact/plane.h"
#include "hidden/exact/support_plane.h"
#include "hidden/lines/side_table.h"

namespace displayfile {

namespace {

/// Faces that meet at less [radians] count as coplanar, whatever crease is asked for: where a flat
/// polygon was cut into triangles, or stored in single precision (clip/planarity.h).
constexpr double kCoplanar = 1e-5;

constexpr double kHalfTurn = std::numbers::pi;
/// Cosines that differ by more are those of different angles, in the same order.
constexpr double kNearlyEqual = 1e-12;

/// A vector of length 1, or 0. Scaled first, as squares of large numbers overflow.
Point3 direction_of(const Point3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return largest > 0.0 ? glm::normalize(v / largest) : Point3(0.0);
}

/// True if the polygon turns its light face to the eye; one that is seen edge-on, or has no area,
/// does not.
bool faces(const Eye& eye, const PointRow& polygon) {
  if (polygon.size() == 3) return side_of_plane(eye, polygon[0], polygon[1], polygon[2]) > 0;
  const SupportVertices support = spread_vertices(polygon);
  if (support.edge_on) return false;
  const auto& [p, q, r] = support.index;
  const Plane plane(polygon[p], polygon[q], polygon[r]);
  const bool turned =
      glm::dot(direction_of(plane.normal), direction_of(newell_normal(polygon))) < 0.0;
  return side_of_plane(eye, plane) * (turned ? -1 : 1) > 0;
}

/// Between two vectors, 0 to half a turn.
double angle_between(const Point3& u, const Point3& v) {
  return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

/// The segment's own primitives, corners and points, as the sorts have them.
struct OwnPrimitives {
  OwnPrimitives(const RetainedScene& scene, const RetainedScene::Segment& segment) {
    const std::uint32_t first_corner = scene.first_corner(segment);
    for (std::uint32_t i = segment.first; i < segment.end; ++i) {
      const RetainedScene::Primitive& primitive = scene[i];
      items.push_back({primitive.first - first_corner, primitive.sides,
                       primitive.is_line() ? Primitives::Kind::line : Primitives::Kind::hollow});
      if (!scene.has_shared()) continue;
      for (const std::uint32_t point : scene.corners(i)) {
        corners.push_back(point - segment.first_point);
      }
    }
    primitives = {scene.points(segment), corners, {}, items};
  }
  std::vector<Primitives::Item> items;
  std::vector<std::uint32_t> corners;
  Primitives primitives;
};

}  // namespace

/// Looks at each set of sides that have the same ends.
class SideKinds::Finder {
 public:
  Finder(const RetainedScene& scene, const RetainedScene::Segment& segment,
         const LineSelection& wanted, SideKinds& found)
      : scene_(scene),
        segment_(segment),
        wanted_(wanted),
        least_crease_(std::max(wanted.crease_degrees * kHalfTurn / 180.0, kCoplanar)),
        cosine_(std::cos(least_crease_)),
        found_(found),
        own_(scene, segment) {}

  void find() {
    draw_all();
    if (wanted_.is_all_alone()) return;
    if (wants(LineKind::crease)) find_normals();
    SideTable(own_.primitives).for_each_set([&](std::span<const SideTable::Side> sides) {
      LineKinds kinds = 0;
      const auto add = [&](LineKind kind, bool is_one) {
        if (is_one) kinds = static_cast<LineKinds>(kinds | kinds_of(kind));
      };
      if (wants(LineKind::boundary)) add(LineKind::boundary, sides.size() == 1);
      if (wants(LineKind::crease)) add(LineKind::crease, is_crease(sides));
      if (wants(LineKind::material)) add(LineKind::material, fills_differ(sides));
      for (const SideTable::Side& side : sides) {
        LineKinds& of_side = found_.fixed_[corner_of(side)];
        if (is_visible(side)) of_side = static_cast<LineKinds>(of_side | kinds);
      }
      if (wants(LineKind::outline)) note_shared(sides);
    });
  }

 private:
  bool wants(LineKind kind) const { return contains(wanted_.kinds, kind); }
  std::uint32_t corner_of(const SideTable::Side& side) const {
    return own_.items[side.name.item].first + side.name.corner;
  }
  std::uint32_t primitive_of(const SideTable::Side& side) const {
    return segment_.first + side.name.item;
  }
  bool is_visible(const SideTable::Side& side) const {
    return scene_.edge_visible(primitive_of(side), side.name.corner);
  }

  /// Lines, and all sides if they are wanted.
  void draw_all() {
    for (std::uint32_t i = segment_.first; i < segment_.end; ++i) {
      for (std::uint32_t k = 0; k < scene_[i].sides; ++k) {
        const bool wanted = wants(LineKind::all) && scene_.edge_visible(i, k);
        const LineKinds of_side = wanted ? kinds_of(LineKind::all) : LineKinds{0};
        found_.fixed_.push_back(scene_[i].is_line() ? kDrawn : of_side);
      }
    }
  }

  bool fills_differ(std::span<const SideTable::Side> sides) const {
    const auto look = [&](const SideTable::Side& side) {
      const std::uint32_t i = primitive_of(side);
      const FillStyle::Kind kind = scene_.shared_attributes(i).fill.kind;
      const bool solid = kind == FillStyle::Kind::solid;
      return FillStyle{kind, solid ? scene_.fill_colour(i) : Colour(0.0)};
    };
    const FillStyle first = look(sides[0]);
    return std::ranges::any_of(sides.subspan(1),
                               [&](const auto& side) { return !(look(side) == first); });
  }

  void find_normals() {
    normals_.reserve(segment_.end - segment_.first);
    for (std::uint32_t i = segment_.first; i < segment_.end; ++i) {
      normals_.push_back(scene_[i].is_line() ? Point3(0.0)
                                             : direction_of(newell_normal(scene_.points(i))));
    }
  }

  /// A polygon's normal, turned so that of two polygons that run through the side in opposite
  /// directions, as those of one surface do, each has it out of the same face.
  Point3 turned_normal(const SideTable::Side& side) const {
    const Primitives& all = own_.primitives;
    const Primitives::Item& polygon = all.items[side.name.item];
    const std::uint32_t corner = side.name.corner;
    const Point3& from =
        all.points[all.point(polygon.first + previous_corner(corner, polygon.sides))];
    const Point3& to = all.points[all.point(polygon.first + corner)];
    const bool runs_up = std::tie(from.x, from.y, from.z) < std::tie(to.x, to.y, to.z);
    const Point3& normal = normals_[side.name.item];
    return runs_up ? normal : -normal;
  }

  /// Two polygons that run through the side in opposite directions meet at the angle of their
  /// normals: turned as above, that is half a turn less the angle between these. Of more than two
  /// the smallest angle between them counts, which neighbours around the side have.
  bool is_crease(std::span<const SideTable::Side> sides) {
    around_.clear();
    for (const SideTable::Side& side : sides) {
      const Point3 normal = turned_normal(side);
      if (normal != Point3(0.0)) around_.push_back(normal);
    }
    if (around_.size() < 2) return false;
    if (around_.size() == 2) {
      const double beyond = glm::dot(around_[0], around_[1]) + cosine_;
      if (std::abs(beyond) > kNearlyEqual) return beyond > 0.0;
      return turns_more(angle_between(around_[0], around_[1]));
    }
    return turns_more(smallest_angle_around());
  }
  bool turns_more(double between_normals) const {
    return kHalfTurn - between_normals > least_crease_;
  }

  /// Normals of polygons that share a side are all across it: directions around a circle.
  double smallest_angle_around() {
    const Point3 right = around_[0];
    Point3 axis(0.0);
    for (const Point3& v : around_) {
      const Point3 across = glm::cross(right, v);
      if (glm::length(across) > glm::length(axis)) axis = across;
    }
    if (axis == Point3(0.0)) axis = Point3(1.0);  // all are in line
    const Point3 up = glm::cross(axis / glm::length(axis), right);
    angles_.clear();
    for (const Point3& v : around_)
      angles_.push_back(std::atan2(glm::dot(v, up), glm::dot(v, right)));
    std::ranges::sort(angles_);
    double least = angles_.front() + 2.0 * kHalfTurn - angles_.back();
    for (std::size_t k = 1; k < angles_.size(); ++k) {
      least = std::min(least, angles_[k] - angles_[k - 1]);
    }
    return std::min(least, kHalfTurn);
  }

  void note_shared(std::span<const SideTable::Side> sides) {
    if (sides.size() < 2) return;
    for (const SideTable::Side& side : sides) {
      found_.shared_.push_back({side.name.item, corner_of(side)});
    }
    found_.ends_.push_back(static_cast<std::uint32_t>(found_.shared_.size()));
  }

  const RetainedScene& scene_;
  const RetainedScene::Segment& segment_;
  const LineSelection wanted_;
  const double least_crease_;  // radians
  const double cosine_;        // of it
  SideKinds& found_;
  OwnPrimitives own_;
  std::vector<Point3> normals_;  // of the primitives, of length 1; or 0
  std::vector<Point3> around_;   // of length 1
  std::vector<double> angles_;
};

SideKinds::SideKinds(const RetainedScene& scene, const RetainedScene::Segment& segment,
                     const LineSelection& wanted) {
  Finder(scene, segment, wanted, *this).find();
}

void SideKinds::in_view(const RetainedScene& scene, const RetainedScene::Segment& segment,
                        const Eye& eye, std::span<LineKinds> of_corners) const {
  std::ranges::copy(fixed_, of_corners.begin());
  if (ends_.empty()) return;
  std::vector<std::uint8_t> is_facing;
  is_facing.reserve(segment.end - segment.first);
  for (std::uint32_t i = segment.first; i < segment.end; ++i) {
    is_facing.push_back(!scene[i].is_line() && faces(eye, scene.points(i)) ? 1 : 0);
  }
  std::uint32_t first = 0;
  for (const std::uint32_t end : ends_) {
    const auto sides = std::span(shared_).subspan(first, end - first);
    first = end;
    const auto faces_eye = [&](const SharedSide& side) { return is_facing[side.primitive]; };
    const bool is_outline = std::ranges::any_of(
        sides, [&](const SharedSide& side) { return faces_eye(side) != faces_eye(sides[0]); });
    if (!is_outline) continue;
    for (const SharedSide& side : sides) {
      LineKinds& of_side = of_corners[side.corner];
      of_side = static_cast<LineKinds>(of_side | kinds_of(LineKind::outline));
    }
  }
}

void SideKinds::in_any_view(std::span<LineKinds> of_corners) const {
  std::ranges::copy(fixed_, of_corners.begin());
  for (const SharedSide& side : shared_) {
    LineKinds& of_side = of_corners[side.corner];
    of_side = static_cast<LineKinds>(of_side | kinds_of(LineKind::outline));
  }
}

}  // namespace displayfile
