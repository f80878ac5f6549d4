#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "displayfile/viewed_scene.h"
#include "hidden/exact/entered_outline.h"
#include "hidden/exact/exact_number.h"
#include "hidden/exact/support_plane.h"

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

/// Found before the planes that polygons share: mostly there are none, and then none is shared.
const TouchingPlanes* ViewedScene::near_planes() const {
  if (planes_ == nullptr) return nullptr;
  if (!planes_->near_is_found.load(std::memory_order_acquire)) {
    const std::lock_guard in_turn(planes_->near_in_turn);
    if (!planes_->near_is_found.load(std::memory_order_relaxed)) {
      planes_->near = planes_->find_near();
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
/// with it. Empty if none is.
std::vector<std::uint8_t> ViewedScene::find_close_planes() const {
  const TouchingPlanes* const near = near_planes();
  if (near == nullptr || near->touching() == 0) return {};
  std::vector<std::uint32_t> plane_of;  // of the polygons that are items
  for (Item item = 0; item < items(); ++item) {
    const std::uint32_t polygon = entered_number(item);
    if (polygon == kNotEntered) continue;
    if (polygon >= plane_of.size()) plane_of.resize(std::size_t{polygon} + 1, kNotEntered);
    plane_of[polygon] = entered_plane(item);
  }
  std::vector<std::uint8_t> are_close;
  std::vector<std::uint32_t> together;
  for (std::size_t k = 0; k < near->shared_planes(); ++k) {
    together.clear();
    for (const std::uint32_t polygon : near->members(k)) {
      if (polygon < plane_of.size() && plane_of[polygon] != kNotEntered) {
        together.push_back(plane_of[polygon]);
      }
    }
    if (std::ranges::adjacent_find(together, std::not_equal_to()) == together.end()) continue;
    are_close.resize(std::max(are_close.size(), std::size_t{std::ranges::max(together)} + 1), 0);
    for (const std::uint32_t plane : together) are_close[plane] = 1;
  }
  return are_close;
}

/// The three points that give the item's plane; nothing if it is edge-on.
std::optional<Primitives::PlanePoints> ViewedScene::plane_points(Item item) const {
  const auto shared = planes();
  if (!shared.empty() && shared[item][0] != Primitives::kOwnPlane) return shared[item];
  const PointRow vertices = points(item);
  const SupportVertices support = support_vertices({vertices.data(), vertices.size()});
  if (support.edge_on) return std::nullopt;
  Primitives::PlanePoints plane;
  for (std::size_t k = 0; k < 3; ++k) {
    plane[k] = point_number(items_[item].first + support.index[k]);
  }
  return plane;
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
