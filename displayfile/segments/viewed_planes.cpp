#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <span>

#include "clip/geometry/back_face.h"
#include "displayfile/segments/viewed_scene.h"
#include "hidden/exact/eye.h"
#include "hidden/exact/support_plane.h"

// The polygons of a viewed scene as entered, and the planes that they share
// (hidden/touching/touching_planes.md).

namespace displayfile {

ViewedScene::InWorld ViewedScene::in_world(const EnteredPolygons& kept) {
  return {kept.largest_in_world(), kept.roundings_in_world()};
}

void ViewedScene::find_entered(const std::function<EnteredPolygon(std::uint32_t)>& polygon_of) {
  as_entered_ = std::make_shared<AsEntered>();
  as_entered_->polygon_of = polygon_of;
  for (const Source& source : sources_) {
    const EnteredPolygons* const kept = source.instructions->as_entered();
    as_entered_->volumes.push_back(kept == nullptr ? nullptr : &kept->volume());
    as_entered_->images.push_back(&source.image);
    if (kept == nullptr) continue;
    const double radius = radius_in(kept->volume().matrix(), in_world(*kept), 0.0, largest_depth_);
    as_entered_->radius = std::max(as_entered_->radius, radius * longest_of(source.image));
  }
}

Rectangle ViewedScene::viewport_of(Item item) const {
  constexpr Rectangle kPicture{0.0, 1.0, 0.0, 1.0};
  if (as_entered_ == nullptr) return kPicture;
  const std::uint32_t look = look_of(item);
  const AsEntered& all = *as_entered_;
  const ViewVolume* const volume = all.own_volume ? &*all.own_volume : all.volumes[look];
  return volume != nullptr && all.images[look]->is_identity() ? volume->viewport() : kPicture;
}

/// The number of the item's polygon among those entered, or kNotEntered.
std::uint32_t ViewedScene::entered_number(Item item) const {
  if (!as_entered_->polygons_of_items) return entered_of_item_[item];
  if (!as_entered_->are_found.load(std::memory_order_acquire)) {
    const std::lock_guard in_turn(as_entered_->in_turn);
    if (!as_entered_->are_found.load(std::memory_order_relaxed)) {
      as_entered_->polygons_of_items(*this, as_entered_->polygons);
      as_entered_->are_found.store(true, std::memory_order_release);
    }
  }
  return as_entered_->polygons[item];
}

/// The number of the polygon whose plane contains the item's polygon.
std::uint32_t ViewedScene::entered_plane(Item item) const {
  planes();
  const bool shares =
      planes_ != nullptr && !planes_->founders.empty() && planes_->founders[item] != kNotEntered;
  return shares ? planes_->founders[item] : entered_number(item);
}

ViewedScene::EnteredItem ViewedScene::as_entered(Item item) const {
  if (viewing_radius() == 0.0) return {{std::span<const Point3>()}};
  return in_view_of(entered_number(item), item);
}

ViewedScene::EnteredItem ViewedScene::plane_as_entered(Item item) const {
  if (viewing_radius() == 0.0) return {{std::span<const Point3>()}};
  return in_view_of(entered_plane(item), item);
}

ViewedScene::EnteredItem ViewedScene::in_view_of(std::uint32_t number, Item item) const {
  if (number == kNotEntered) return {{std::span<const Point3>()}};
  const std::uint32_t look = look_of(item);
  const AsEntered& all = *as_entered_;
  return {all.polygon_of(number), all.own_volume ? &*all.own_volume : all.volumes[look],
          all.images[look]};
}

/// Sets the radii to the largest of all sources; the planes' radius is 0 if it is not small.
void ViewedScene::find_radius(Planes& planes) const {
  bool has_images = false;
  for (const Source& source : sources_) {
    const EnteredPolygons* const kept = source.instructions->as_entered();
    if (kept == nullptr) continue;
    has_images |= !source.image.is_identity();
    planes.reach =
        std::max(planes.reach, entered_reach(kept->touching(), kept->largest()) * kept->longest());
  }
  for (const Source& source : sources_) {
    const EnteredPolygons* const kept = source.instructions->as_entered();
    if (kept == nullptr) continue;
    const double radius =
        radius_in(kept->volume().matrix(), in_world(*kept), planes.reach, largest_depth_);
    planes.radius_of_ends = std::max(planes.radius_of_ends, radius * longest_of(source.image));
    planes.compares_ends |= may_reach(planes.reach, kept->touching(), kept->volume());
  }
  set_radius(planes, planes.radius_of_ends, !has_images);
}

void ViewedScene::set_radius(Planes& planes, double of_planes, bool are_looked_for) const {
  constexpr double kLittle = 0x1p-40;
  planes.are_close = planes.reach == 0.0 || (of_planes > 0.0 && of_planes <= kLittle);
  planes.radius = are_looked_for ? small_radius(of_planes) : 0.0;
}

bool ViewedScene::may_reach(double reach, const Touching& touching, const ViewVolume& volume) {
  constexpr double kMostOfWindow = 0x1p-10;
  if (touching.kind != Touching::Kind::automatic) return true;
  const Rectangle& window = volume.view().window;
  const double width = std::max(window.x_max - window.x_min, window.y_max - window.y_min);
  return reach > 0.0 && reach <= kMostOfWindow * width;
}

/// The radius, or 0 if it is larger than small: then all planes are found at once.
double ViewedScene::small_radius(double radius) {
  constexpr double kLargest = 0x1p-37;  // fills steeper than 4096 are not certain then
  return radius <= kLargest ? radius : 0.0;
}

/// The largest factor by which an image transformation increases a coordinate's error; at least 1.
double ViewedScene::longest_of(const ImageTransformation& image) {
  return std::max(1.0, std::abs(image.scale.x) + std::abs(image.scale.y));
}

/// With u = 2^-53: a world point is a sum of products, with an error of `roundings` u of the sum of
/// their magnitudes, and each homogeneous coordinate of a viewed one has an error of 4 u of its
/// own; a plane's points are off it by the reach too, and by the deviation allowed for flat
/// polygons (kFlatAsEntered, at most 64 u of these sums). W is at least its value at the nearest
/// depth in the scene: depth is A + B / W.
double ViewedScene::radius_in(const glm::dmat4& view, const InWorld& in_world, double reach,
                              double largest_depth) {
  constexpr double kU = 0x1p-53;
  constexpr double kCoarsest = 0x1p-10;  // beyond this, or without a bound, nothing is known
  const double largest = in_world.largest;
  const double off = reach + (64.0 + in_world.roundings) * kU * largest;  // each coordinate
  const auto row = [&](int k) {
    return std::abs(view[0][k]) + std::abs(view[1][k]) + std::abs(view[2][k]);
  };
  const auto error = [&](int k) {
    return row(k) * (off + 4.0 * kU * largest) + 4.0 * kU * std::abs(view[3][k]);
  };
  double least_w = 1.0;
  if (row(3) > 0.0) {  // perspective: the rows of Z and W differ by a factor and a constant only
    int axis = 0;
    for (int k = 1; k < 3; ++k) {
      if (std::abs(view[k][3]) > std::abs(view[axis][3])) axis = k;
    }
    const double a = view[axis][2] / view[axis][3], b = view[3][2] - a * view[3][3];
    least_w = 0.5 * std::abs(b) / (largest_depth + std::abs(a));
  }
  const double of_row = std::max({error(0), error(1), error(2)});
  const double radius = 2.0 * (of_row + error(3) * (1.0 + largest_depth)) / least_w + 8.0 * kU;
  return radius <= kCoarsest ? radius : 0.0;
}

namespace {

/// Twice the area of a polygon as entered, along its normal, and its error if the vertices are
/// within a reach of a plane.
struct Normal {
  Point3 along{0.0};
  double error = 0.0;
};
Normal normal_of(const EnteredPolygon& polygon, double reach) {
  const std::size_t sides = polygon.points.size();
  if (sides < 3) return {Point3(0.0), std::numeric_limits<double>::infinity()};
  const Point3 first = polygon.in_world(0);
  Normal normal;
  double size = 0.0, largest = glm::length(first);
  Point3 before(0.0);
  for (std::size_t k = 1; k < sides; ++k) {
    const Point3 p = polygon.in_world(k), here = p - first;
    normal.along += glm::cross(before, here);
    size = std::max(size, glm::length(here));
    largest = std::max(largest, glm::length(p));
    before = here;
  }
  if (polygon.modelling != nullptr) largest += 4.0 * glm::length((*polygon.modelling)[3]);
  const double off = reach + 0x1p-47 * largest;
  normal.error = static_cast<double>(sides) * size * (2.0 * off + 0x1p-48 * size);
  return normal;
}

}  // namespace

/// Polygons in one plane of normal n have normals A n + E and B n + F, with E and F bounded by
/// their errors, so that the cross product of these is bounded by the sum below. True only if there
/// is a radius and the planes have not been found yet.
bool ViewedScene::is_certainly_apart(Item a, Item b) const {
  if (!(planes_->radius > 0.0) || planes_->are_found.load(std::memory_order_acquire)) return false;
  const auto polygon = [this](Item item) {
    return planes_->polygon_of_item ? planes_->polygon_of_item(items_[item].first)
                                    : entered_of_item_[item];
  };
  const std::uint32_t of_a = polygon(a), of_b = polygon(b);
  if (of_a == kNotEntered || of_b == kNotEntered) return !planes_->polygon_of_item;
  const Normal n = normal_of(planes_->polygon_of(of_a), planes_->reach);
  const Normal m = normal_of(planes_->polygon_of(of_b), planes_->reach);
  const double n_size = glm::length(n.along), m_size = glm::length(m.along);
  const double most = (n_size + n.error) * m.error + (m_size + m.error) * n.error +
                      n.error * m.error + 0x1p-45 * n_size * m_size;
  return glm::length(glm::cross(n.along, m.along)) > most;
}

std::span<const Primitives::PlanePoints> ViewedScene::planes() const {
  if (planes_ == nullptr) return {};
  if (!planes_->are_found.load(std::memory_order_acquire)) {
    const std::lock_guard in_turn(planes_->in_turn);
    if (!planes_->are_found.load(std::memory_order_relaxed)) {
      find_planes(*planes_);
      planes_->are_found.store(true, std::memory_order_release);
    }
  }
  return planes_->of_items;
}

bool ViewedScene::is_edge_on(Item item) const {
  const PointRow vertices = points(item);
  return support_vertices({vertices.data(), vertices.size()}).edge_on;
}

/// Finds the planes that polygons share, and those of bent polygons.
void ViewedScene::find_planes(Planes& found) const {
  find_shared_planes(found);
  if (bent_.empty()) return;
  found.of_items.resize(items(), {Primitives::kOwnPlane, 0, 0});
  for (const auto& [item, plane] : bent_) {
    if (found.of_items[item][0] == Primitives::kOwnPlane) found.of_items[item] = plane;
  }
}

void ViewedScene::find_shared_planes(Planes& found) const {
  found.of_items.clear();
  found.founders.clear();
  found.elsewhere.clear();
  found.are_founders.clear();
  found.touching = found.find_touching();
  const TouchingPlanes* const touching = found.touching.get();
  if (touching->touching() == 0) return;
  if (found.polygons_of_items) {
    found.polygons_of_items(*this, found.polygons);
  } else {
    found.polygons = entered_of_item_;
  }
  std::size_t polygons = 0;
  for (const std::uint32_t polygon : found.polygons) {
    if (polygon != kNotEntered) polygons = std::max(polygons, std::size_t{polygon} + 1);
  }
  found.item_of.assign(polygons, kNone);
  for (Item item = 0; item < items(); ++item) {
    if (found.polygons[item] != kNotEntered) found.item_of[found.polygons[item]] = item;
  }
  const auto look = [this](Item item) { return look_of(item); };
  const bool are_fills = fill_item_.empty() && fills_ == items();  // none is edge-on
  for (std::size_t k = 0; k < touching->shared_planes(); ++k) {
    const auto members = touching->members(k);
    found.in_plane.clear();
    for (const std::uint32_t polygon : members) {
      if (polygon >= found.item_of.size() || found.item_of[polygon] == kNone) continue;
      const Item item = found.item_of[polygon];
      if (are_fills || !is_edge_on(item)) found.in_plane.push_back(item);
    }
    if (found.in_plane.empty()) continue;
    found.founders.resize(items(), kNotEntered);
    found.elsewhere.resize(items(), 0);
    found.are_founders.resize(items(), 0);
    for (const Item item : found.in_plane) {
      found.founders[item] = members.front();
      found.elsewhere[item] = found.polygons[item] == members.front() ? 0 : 1;
    }
    if (looks_.size() > 1) std::ranges::stable_sort(found.in_plane, {}, look);
    const std::uint32_t founder =
        members.front() < found.item_of.size() ? found.item_of[members.front()] : kNone;
    for (std::size_t first = 0, end = 0; first < found.in_plane.size(); first = end) {
      while (end < found.in_plane.size() &&
             look(found.in_plane[end]) == look(found.in_plane[first])) {
        ++end;
      }
      share_plane(std::span(found.in_plane).subspan(first, end - first), founder, found);
    }
  }
}

namespace {

/// True if a plane is so steep that rounding decides its position: far from the polygon that
/// defines it, it would be arbitrary.
bool is_nearly_edge_on(const Plane& plane) {
  constexpr double kSteepest = 0x1p20;
  const Point3 normal = glm::abs(plane.normal);
  return !(std::max(normal.x, normal.y) <= kSteepest * normal.z);
}

}  // namespace

/// True only if the plane of the item's own points, as entered, is certainly not edge-on.
bool ViewedScene::is_certainly_seen(Item item) const {
  if (item == kNone || !(viewing_radius() > 0.0)) return false;
  const auto own = own_plane_points(item);
  if (!own) return false;
  const Point2 at(points_[(*own)[0]]);
  const Point2 a = Point2(points_[(*own)[1]]) - at, b = Point2(points_[(*own)[2]]) - at;
  const double twice_area = std::abs(a.x * b.y - a.y * b.x);
  const double around = std::abs(a.x) + std::abs(a.y) + std::abs(b.x) + std::abs(b.y);
  // The error of a difference of two points is twice the radius; that of points left by clipping is
  // a little more.
  return twice_area > 16.0 * viewing_radius() * (around + viewing_radius());
}

namespace {

/// True only if it is a triangle whose plane is certainly not edge-on.
bool has_plane_certainly_seen(const ViewedScene::EnteredItem& of_plane) {
  constexpr double kSure = 0x1p-36;  // far more than is rounded here
  if (of_plane.polygon.points.size() != 3 || !of_plane.image->is_identity()) return false;
  const Normal normal = normal_of(of_plane.polygon, 0.0);
  const Eye eye = Eye::of(of_plane.volume->view());
  const Point3 at = of_plane.polygon.in_world(0);
  const Point3 to_eye = eye.at_infinity ? eye.place : eye.place - at;
  double size = glm::length(to_eye);
  if (!eye.at_infinity) size += glm::length(eye.place) + glm::length(at);
  const double off = std::abs(glm::dot(normal.along, to_eye));
  return off > (normal.error + kSure * glm::length(normal.along)) * size;
}

}  // namespace

std::optional<Primitives::PlanePoints> ViewedScene::own_plane_points(Item item) const {
  if (const auto* const of_bent = plane_of_bent(item)) return *of_bent;
  const PointRow vertices = points(item);
  const SupportVertices support = support_vertices({vertices.data(), vertices.size()});
  if (support.edge_on) return std::nullopt;
  Primitives::PlanePoints plane;
  for (std::size_t k = 0; k < 3; ++k) {
    plane[k] = point_number(items_[item].first + support.index[k]);
  }
  return plane;
}

/// Sets the plane shared by several polygons that are viewed alike, none of them edge-on: that of
/// the polygon whose plane it is as entered; or, if that is not in the scene or only a small part
/// of it, from which the plane would be inaccurate elsewhere, that of the largest one in the
/// picture. Where this may be far from the plane there are rests (find_rests).
void ViewedScene::share_plane(std::span<const std::uint32_t> in_plane, std::uint32_t founder,
                              Planes& found) const {
  const bool is_its_own = in_plane.size() < 2 && (found.are_close || in_plane[0] == founder);
  if (in_plane.size() < 2 && in_plane[0] == founder) found.are_founders[founder] = 1;
  if (is_its_own) return;
  if (!found.are_close && !is_certainly_seen(founder) &&
      !has_plane_certainly_seen(in_view_of(found.founders[in_plane[0]], in_plane[0])) &&
      is_plane_edge_on(in_plane[0])) {
    return;
  }
  const auto area = [&](Item item) {
    constexpr double kOfFounder = 16.0;
    return std::abs(newell_c(points(item))) * (item == founder ? kOfFounder : 1.0);
  };
  Item largest = in_plane.front();
  double most = area(largest);
  for (const Item item : in_plane.subspan(1)) {
    const double here = area(item);
    if (!(here > most)) continue;
    largest = item;
    most = here;
  }
  const Primitives::PlanePoints plane = *own_plane_points(largest);
  if (is_nearly_edge_on({points_[plane[0]], points_[plane[1]], points_[plane[2]]})) return;
  if (found.of_items.empty()) found.of_items.resize(items(), {Primitives::kOwnPlane, 0, 0});
  for (const Item item : in_plane) {
    found.of_items[item] = plane;
    if (largest != founder) continue;
    found.elsewhere[item] = 0;
    found.are_founders[item] = 1;
  }
}

}  // namespace displayfile
