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

#include "clip/view/transformation.h"
#include "displayfile/segments/viewed_scene.h"
#include "hidden/boxes/extents.h"
#include "hidden/exact/entered_outline.h"
#include "hidden/exact/entered_plane.h"
#include "hidden/exact/exact_number.h"
#include "hidden/exact/orientation.h"

namespace displayfile {

namespace {

/// The amounts to be added to the depths of points so that they are in the plane. 0 if the plane is
/// edge-on, or if one exceeds `largest`: the plane is then so steep that the rounding of x and y
/// alone decides its position.
Point3 rests_in(const PlaneInPicture& plane, const std::array<Point3, 3>& points, double largest) {
  if (plane.is_edge_on()) return Point3(0.0);
  Point3 rest(0.0);
  for (int k = 0; k < 3; ++k) {
    const Point3& p = points[static_cast<std::size_t>(k)];
    const ExactNumber value = plane.a * ExactNumber(p.x) + plane.b * ExactNumber(p.y) +
                              plane.c * ExactNumber(p.z) + plane.d;
    rest[k] = -rounded_quotient(value, plane.c);
    if (!(std::abs(rest[k]) <= largest)) return Point3(0.0);
  }
  return rest;
}

/// A polygon's unit normal in world coordinates; 0 if it has no plane.
Point3 unit_normal(const EnteredPolygon& polygon) {
  const auto support = support_of_entered({polygon.points.data(), polygon.points.size()});
  if (!support) return Point3(0.0);
  const auto& [p, q, r] = *support;
  const Point3 at = polygon.in_world(p);
  return glm::normalize(glm::cross(polygon.in_world(q) - at, polygon.in_world(r) - at));
}

/// Planes at a larger angle intersect close to where they do as entered, however small polygons
/// are.
bool are_nearly_parallel(const Point3& a, const Point3& b) {
  constexpr double kLargest = 0x1p-20;
  return glm::length(glm::cross(a, b)) <= kLargest;
}

Extent box_of(const PointRow& points) {
  Extent box = Extent::nothing();
  for (const Point3& p : points) box.include(p);
  return box;
}

/// True if the line through some side of the first separates the two, except for points on the line
/// and rounding: neighbours in a mesh are apart.
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

/// Calls note(a, b) for each pair of polygons in different planes that lie over each other. False
/// if it gave up, since comparing the pairs would take too long.
template <class Together, class LieOver, class Note>
bool note_pairs(std::vector<Together>& together, const LieOver& lie_over, const Note& note) {
  constexpr std::size_t kMostCompared = 512;  // of a polygon, on average
  std::ranges::sort(together, {}, [](const Together& a) { return a.box.x_min; });
  std::vector<const Together*> before;  // those that reach the current position along x
  std::size_t compared = 0;
  for (const Together& a : together) {
    compared += before.size();
    if (compared > kMostCompared * together.size()) return false;
    std::erase_if(before, [&](const Together* b) { return b->box.x_max < a.box.x_min; });
    for (const Together* b : before) {
      if (a.plane == b->plane || !a.box.meets_in_projection(b->box)) continue;
      if (lie_over(a, *b)) note(a, *b);
    }
    before.push_back(&a);
  }
  return true;
}

/// The exact projections of a scene's items, one per view.
class ExactProjections {
 public:
  EnteredProjection& of(const ViewedScene::EnteredItem& item) {
    auto& view = views_[{item.volume, item.image}];
    if (!view) view.emplace(*item.volume, *item.image);
    return *view;
  }

 private:
  std::map<std::pair<const ViewVolume*, const ImageTransformation*>,
           std::optional<EnteredProjection>>
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

/// Calls visit(together) for polygons that are together near one plane and nearly parallel to it.
template <class Visit>
void ViewedScene::visit_near_planes(const Visit& visit) const {
  const TouchingPlanes* const near = near_planes();
  if (near == nullptr || near->touching() == 0) return;
  std::vector<Item> item_of(items(), kNone);  // of polygons
  for (Item item = 0; item < items(); ++item) {
    const std::uint32_t polygon = entered_number(item);
    if (polygon == kNotEntered || kind(item) == Primitives::Kind::line) continue;
    if (polygon >= item_of.size()) item_of.resize(std::size_t{polygon} + 1, kNone);
    item_of[polygon] = item;
  }
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
    visit(together);
  }
}

bool ViewedScene::lie_over_each_other(const Together& a, const Together& b) const {
  return !are_apart(points(a.item), points(b.item));
}

/// For each polygon number, whether the polygon's own plane is close but not equal to another,
/// nearly parallel to it, and polygons of both lie over each other. Empty if there are none.
std::vector<std::uint8_t> ViewedScene::find_close_planes() const {
  std::vector<std::uint8_t> are_close;
  const auto note = [&](std::uint32_t plane) {
    are_close.resize(std::max(are_close.size(), std::size_t{plane} + 1), 0);
    are_close[plane] = 1;
  };
  const auto lie_over = [this](const auto& a, const auto& b) { return lie_over_each_other(a, b); };
  const auto note_both = [&](const Together& a, const Together& b) {
    note(a.plane);
    note(b.plane);
  };
  visit_near_planes([&](std::vector<Together>& together) {
    if (note_pairs(together, lie_over, note_both)) return;
    for (const Together& each : together) note(each.plane);
  });
  return are_close;
}

/// The planes, with coincident ones united. A polygon that is bent out of another's plane does not
/// lie in it, though its own plane may coincide with it: image-space methods then find equal
/// depths.
std::span<const Primitives::PlanePoints> ViewedScene::planes_where_they_coincide() const {
  const auto all = planes();
  if (bent_.empty()) return all;
  if (!planes_->coincident_are_found.load(std::memory_order_acquire)) {
    const std::lock_guard in_turn(planes_->coincident_in_turn);
    if (!planes_->coincident_are_found.load(std::memory_order_relaxed)) {
      planes_->coincident.assign(all.begin(), all.end());
      unite_coincident(planes_->coincident);
      planes_->coincident_are_found.store(true, std::memory_order_release);
    }
  }
  return planes_->coincident;
}

void ViewedScene::unite_coincident(std::vector<Primitives::PlanePoints>& planes) const {
  std::map<Primitives::PlanePoints, Primitives::PlanePoints> same_as;
  const auto stands_for = [&](Primitives::PlanePoints plane) {
    for (auto at = same_as.find(plane); at != same_as.end(); at = same_as.find(plane)) {
      plane = at->second;
    }
    return plane;
  };
  const auto unite = [&](const Together& a, const Together& b) {
    if (plane_of_bent(a.item) == nullptr && plane_of_bent(b.item) == nullptr) return;
    if (look_of(a.item) != look_of(b.item) || !do_planes_coincide(a.plane, b.plane)) return;
    for (const Item item : {a.item, b.item}) {
      if (planes[item][0] != Primitives::kOwnPlane) continue;
      if (const auto own = own_plane_points(item)) planes[item] = *own;
    }
    const auto of_a = stands_for(planes[a.item]), of_b = stands_for(planes[b.item]);
    if (of_a != of_b) same_as[of_a] = of_b;
  };
  const auto lie_over = [this](const auto& a, const auto& b) { return lie_over_each_other(a, b); };
  visit_near_planes(
      [&](std::vector<Together>& together) { note_pairs(together, lie_over, unite); });
  for (Primitives::PlanePoints& plane : planes) plane = stands_for(plane);
}

/// True if the planes of two polygons coincide exactly.
bool ViewedScene::do_planes_coincide(std::uint32_t a, std::uint32_t b) const {
  const EnteredPolygon of_a = planes_->polygon_of(a), of_b = planes_->polygon_of(b);
  const auto at = support_of_entered({of_a.points.data(), of_a.points.size()});
  const auto other = support_of_entered({of_b.points.data(), of_b.points.size()});
  if (!at || !other) return false;
  const Modelling modelling(of_a.modelling, 0.0), modelling_of_other(of_b.modelling, 0.0);
  const auto corner = [](const EnteredPolygon& polygon, std::size_t k) {
    return polygon.points[k];
  };
  const EnteredPlane plane({corner(of_a, (*at)[0]), corner(of_a, (*at)[1]), corner(of_a, (*at)[2])},
                           modelling);
  return std::ranges::all_of(
      *other, [&](std::size_t k) { return plane.side(corner(of_b, k), modelling_of_other) == 0; });
}

/// True if the plane that the item's polygon shares with others is edge-on in the view.
bool ViewedScene::is_plane_edge_on(Item item) const {
  const EnteredItem of_plane = in_view_of(planes_->founders[item], item);
  if (!of_plane.is_known()) return false;
  const auto plane = EnteredProjection(*of_plane.volume, *of_plane.image).plane(of_plane.polygon);
  return plane && plane->is_edge_on();
}

/// The three points that give the item's plane; nothing if it is edge-on.
std::optional<Primitives::PlanePoints> ViewedScene::plane_points(Item item) const {
  const auto shared = planes_where_they_coincide();
  const bool is_shared = !shared.empty() && shared[item][0] != Primitives::kOwnPlane;
  return is_shared ? shared[item] : own_plane_points(item);
}

/// Finds the items of these polygons, given in ascending order; they get the planes of the polygons
/// as entered.
void ViewedScene::find_bent(std::span<const std::uint32_t> polygons) {
  bent_.clear();
  rests_of_bent_.clear();
  if (polygons.empty() || viewing_radius() == 0.0) return;
  auto next = polygons.begin();
  for (Item item = 0; item < items(); ++item) {
    if (kind(item) == Primitives::Kind::line) continue;
    const std::uint32_t polygon = entered_number(item);  // ascending
    while (next != polygons.end() && *next < polygon) ++next;
    if (next == polygons.end()) return;
    if (*next != polygon) continue;
    if (const auto bent = bent_item(item, polygon)) bent_.push_back(*bent);
  }
}

/// The support vertices as viewed, where clipping has left them; otherwise the item's own points,
/// with the amounts to be added to their depths to be in the plane. Nothing if it is edge-on.
std::optional<ViewedScene::Bent> ViewedScene::bent_item(Item item, std::uint32_t polygon) {
  constexpr double kLargest = 0x1p20;
  const EnteredItem entered = in_view_of(polygon, item);
  const PointRow& corners = entered.polygon.points;
  const auto support = support_of_entered({corners.data(), corners.size()});
  if (!support) return std::nullopt;
  const PointRow seen = points(item);
  const ImageMatrix image(*entered.image);
  std::array<std::size_t, 3> at;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point3 viewed = image.apply(entered.volume->to_device(
        entered.volume->transform(entered.polygon.in_world((*support)[k]))));
    at[k] = static_cast<std::size_t>(std::ranges::find(seen, viewed) - seen.begin());
  }
  Bent bent{item, {}};
  const auto number = [&](std::size_t k) {
    return point_number(items_[item].first + static_cast<std::uint32_t>(k));
  };
  if (std::ranges::all_of(at, [&](std::size_t k) { return k < seen.size(); })) {
    if (orientation(seen[at[0]], seen[at[1]], seen[at[2]]) == 0) return std::nullopt;
    bent.plane = {number(at[0]), number(at[1]), number(at[2])};
    return bent;
  }
  const auto own = own_plane_points(item);
  const auto plane = EnteredProjection(*entered.volume, *entered.image).plane(entered.polygon);
  if (!own || !plane || plane->is_edge_on()) return std::nullopt;
  bent.plane = *own;
  const auto& [p, q, r] = *own;
  rests_of_bent_[*own] = rests_in(*plane, {points_[p], points_[q], points_[r]}, kLargest);
  return bent;
}

/// The rests of the items, found once for all items of a plane.
std::vector<Point3> ViewedScene::find_rests() const {
  const std::vector<std::uint8_t> are_close = find_close_planes();
  if (are_close.empty() && rests_of_bent_.empty() && planes_->are_close) return {};
  ExactProjections views;
  const auto rest_of = [&](Item item, const Primitives::PlanePoints& points) {
    const EnteredItem entered = plane_as_entered(item);
    if (!entered.is_known()) return Point3(0.0);
    const auto plane = views.of(entered).plane(entered.polygon);
    const auto& [p, q, r] = points;
    const double largest = planes_->are_close ? 0x1p-20 : 0x1p20;
    return plane ? rests_in(*plane, {points_[p], points_[q], points_[r]}, largest) : Point3(0.0);
  };
  std::map<Primitives::PlanePoints, Point3> known = rests_of_bent_;
  std::vector<Point3> rests(items(), Point3(0.0));
  for (Item item = 0; item < items(); ++item) {
    if (kind(item) == Primitives::Kind::line || entered_number(item) == kNotEntered) continue;
    const auto points = plane_points(item);
    if (!points) continue;
    const std::uint32_t plane = entered_plane(item);
    const bool is_close = plane < are_close.size() && are_close[plane] != 0;
    const bool lacks_nothing = !is_off_its_plane(item) || planes_->are_founders[item] != 0;
    if (!is_close && lacks_nothing && rest_of_bent(*points) == nullptr) continue;
    const auto [rest, is_new] = known.try_emplace(*points, Point3(0.0));
    if (is_new) rest->second = rest_of(item, *points);
    rests[item] = rest->second;
  }
  return rests;
}

}  // namespace displayfile
