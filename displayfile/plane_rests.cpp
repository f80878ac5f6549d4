#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "displayfile/viewed_scene.h"
#include "hidden/exact/entered_outline.h"
#include "hidden/exact/entered_plane.h"
#include "hidden/exact/exact_number.h"
#include "hidden/extents.h"

namespace displayfile {

namespace {

/// What the depths of points lack to be in the plane; 0 if it is edge-on, or so steep that the
/// rounding of x and y alone says where it is.
Point3 rests_in(const PlaneInPicture& plane, const std::array<Point3, 3>& points) {
  constexpr double kLargest = 0x1p-20;
  if (plane.is_edge_on()) return Point3(0.0);
  Point3 rest(0.0);
  for (int k = 0; k < 3; ++k) {
    const Point3& p = points[static_cast<std::size_t>(k)];
    const ExactNumber value = plane.a * ExactNumber(p.x) + plane.b * ExactNumber(p.y) +
                              plane.c * ExactNumber(p.z) + plane.d;
    rest[k] = -rounded_quotient(value, plane.c);
    if (!(std::abs(rest[k]) <= kLargest)) return Point3(0.0);
  }
  return rest;
}

/// In the world; 0 of a polygon without a plane.
Point3 unit_normal(const EnteredPolygon& polygon) {
  const auto support = support_of_entered({polygon.points.data(), polygon.points.size()});
  if (!support) return Point3(0.0);
  const auto& [p, q, r] = *support;
  const Point3 at = polygon.in_world(p);
  return glm::normalize(glm::cross(polygon.in_world(q) - at, polygon.in_world(r) - at));
}

/// Planes at a larger angle meet close to where they do as entered, however small polygons are.
bool are_nearly_parallel(const Point3& a, const Point3& b) {
  constexpr double kLargest = 0x1p-20;
  return glm::length(glm::cross(a, b)) <= kLargest;
}

Extent box_of(const PointRow& points) {
  Extent box = Extent::nothing();
  for (const Point3& p : points) box.include(p);
  return box;
}

/// True if the line through some side of the first has the first on one of its sides and the second
/// on the other, but for what lies on it and for rounding: neighbours in a mesh are apart.
bool has_separating_side(const PointRow& a, const PointRow& b) {
  constexpr double kOff = 0x1p-40;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const Point3 &from = a[k == 0 ? a.size() - 1 : k - 1], &to = a[k];
    const double x = to.x - from.x, y = to.y - from.y, off = kOff * (std::abs(x) + std::abs(y));
    const auto sides = [&](const PointRow& points) {
      bool left = false, right = false;
      for (const Point3& p : points) {
        const double turn = x * (p.y - from.y) - y * (p.x - from.x);
        left |= turn > off;
        right |= turn < -off;
      }
      return std::array{left, right};
    };
    const auto [a_left, a_right] = sides(a);
    if (a_left == a_right) continue;
    const auto [b_left, b_right] = sides(b);
    if (a_left ? !b_left : !b_right) return true;
  }
  return false;
}
bool are_apart(const PointRow& a, const PointRow& b) {
  return has_separating_side(a, b) || has_separating_side(b, a);
}

/// A polygon of those that lie together near one plane.
struct Together {
  ViewedScene::Item item;
  std::uint32_t plane;
  Extent box;
};

/// Calls note(plane) for each plane of polygons that lie over others of another plane; for all of
/// them where to look at pairs takes too long.
template <class LieOver, class Note>
void note_planes(std::vector<Together>& together, const LieOver& lie_over, const Note& note) {
  constexpr std::size_t kMostCompared = 512;  // of a polygon, on average
  std::ranges::sort(together, {}, [](const Together& a) { return a.box.x_min; });
  std::vector<const Together*> before;  // those that reach the place along x
  std::size_t compared = 0;
  for (const Together& a : together) {
    compared += before.size();
    if (compared > kMostCompared * together.size()) {
      for (const Together& each : together) note(each.plane);
      return;
    }
    std::erase_if(before, [&](const Together* b) { return b->box.x_max < a.box.x_min; });
    for (const Together* b : before) {
      if (a.plane == b->plane || !a.box.meets_in_projection(b->box)) continue;
      if (!lie_over(a, *b)) continue;
      note(a.plane);
      note(b->plane);
    }
    before.push_back(&a);
  }
}

/// The exact views of a scene's items, made once each.
class ExactViews {
 public:
  EnteredView& of(const ViewedScene::EnteredItem& item) {
    auto& view = views_[{item.volume, item.image}];
    if (!view) view.emplace(*item.volume, *item.image);
    return *view;
  }

 private:
  std::map<std::pair<const ViewVolume*, const ImageTransformation*>, std::optional<EnteredView>>
      views_;
};

}  // namespace

const TouchingPlanes* ViewedScene::near_planes() const {
  planes();
  if (planes_ == nullptr || planes_->touching == nullptr) return nullptr;
  if (!planes_->near_is_found.load(std::memory_order_acquire)) {
    const std::lock_guard in_turn(planes_->near_in_turn);
    if (!planes_->near_is_found.load(std::memory_order_relaxed)) {
      planes_->near = planes_->find_near(*planes_->touching);
      planes_->near_is_found.store(true, std::memory_order_release);
    }
  }
  return planes_->near.get();
}

std::span<const Point3> ViewedScene::plane_rests() const {
  if (planes_ == nullptr || viewing_radius() == 0.0) return {};
  if (!planes_->rests_are_found.load(std::memory_order_acquire)) {
    const std::lock_guard in_turn(planes_->rests_in_turn);
    if (!planes_->rests_are_found.load(std::memory_order_relaxed)) {
      planes_->rests = find_rests();
      planes_->rests_are_found.store(true, std::memory_order_release);
    }
  }
  return planes_->rests;
}

/// By the number of the polygon whose own a plane is, whether it is close to another and not one
/// with it, at nearly no angle, and polygons of both lie over each other. Empty if none is.
std::vector<std::uint8_t> ViewedScene::find_close_planes() const {
  const TouchingPlanes* const near = near_planes();
  if (near == nullptr || near->touching() == 0) return {};
  std::vector<Item> item_of(items(), kNone);  // of polygons
  for (Item item = 0; item < items(); ++item) {
    const std::uint32_t polygon = entered_number(item);
    if (polygon == kNotEntered || kind(item) == Primitives::Kind::line) continue;
    if (polygon >= item_of.size()) item_of.resize(std::size_t{polygon} + 1, kNone);
    item_of[polygon] = item;
  }
  std::vector<std::uint8_t> are_close;
  const auto note = [&](std::uint32_t plane) {
    are_close.resize(std::max(are_close.size(), std::size_t{plane} + 1), 0);
    are_close[plane] = 1;
  };
  const auto lie_over = [&](const Together& a, const Together& b) {
    return !are_apart(points(a.item), points(b.item));
  };
  std::vector<Together> together;
  for (std::size_t k = 0; k < near->shared_planes(); ++k) {
    together.clear();
    const Point3 first = unit_normal(planes_->polygon_of(near->members(k).front()));
    for (const std::uint32_t polygon : near->members(k)) {
      if (polygon >= item_of.size() || item_of[polygon] == kNone) continue;
      if (!are_nearly_parallel(first, unit_normal(planes_->polygon_of(polygon)))) continue;
      const Item item = item_of[polygon];
      together.push_back({item, entered_plane(item), box_of(points(item))});
    }
    note_planes(together, lie_over, note);
  }
  return are_close;
}

/// The three points that give the item's plane; nothing if it is edge-on.
std::optional<Primitives::PlanePoints> ViewedScene::plane_points(Item item) const {
  const auto shared = planes();
  const bool is_shared = !shared.empty() && shared[item][0] != Primitives::kOwnPlane;
  return is_shared ? shared[item] : own_plane_points(item);
}

/// Once for all items of a plane.
std::vector<Point3> ViewedScene::find_rests() const {
  const std::vector<std::uint8_t> are_close = find_close_planes();
  if (are_close.empty()) return {};
  ExactViews views;
  const auto rest_of = [&](Item item, const Primitives::PlanePoints& points) {
    const EnteredItem entered = plane_as_entered(item);
    if (!entered.is_known()) return Point3(0.0);
    const auto plane = views.of(entered).plane(entered.polygon);
    const auto& [p, q, r] = points;
    return plane ? rests_in(*plane, {points_[p], points_[q], points_[r]}) : Point3(0.0);
  };
  std::map<Primitives::PlanePoints, Point3> known;
  std::vector<Point3> rests(items(), Point3(0.0));
  for (Item item = 0; item < items(); ++item) {
    if (kind(item) == Primitives::Kind::line || entered_number(item) == kNotEntered) continue;
    const std::uint32_t plane = entered_plane(item);
    if (plane >= are_close.size() || are_close[plane] == 0) continue;
    const auto points = plane_points(item);
    if (!points) continue;
    const auto [rest, is_new] = known.try_emplace(*points, Point3(0.0));
    if (is_new) rest->second = rest_of(item, *points);
    rests[item] = rest->second;
  }
  return rests;
}

}  // namespace displayfile
