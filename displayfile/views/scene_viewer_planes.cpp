#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "displayfile/segments/polygons_as_entered.h"
#include "displayfile/segments/retained_scene.h"
#include "displayfile/segments/viewed_scene.h"
#include "displayfile/views/scene_viewer.h"
#include "hidden/touching/touching_planes.h"

// The polygons of a retained scene as entered, for its views: coplanar ones
// (hidden/touching/touching_planes.md) are found once for all views.

namespace displayfile {

struct SceneViewer::Entered {
  std::shared_ptr<const PolygonsAsEntered> polygons;  // null: not taken yet
  double reach = 0.0;
  ViewedScene::InWorld in_world;
  std::shared_ptr<const TouchingPlanes> planes;  // null: not found yet
};

void SceneViewer::begin_entered() { entered_ = std::make_shared<Entered>(); }

/// Resets all that refers to the scene, which has moved; it is found again. The polygons are the
/// same.
void SceneViewer::leave_what_was_entered() {
  viewed_.planes_.reset();
  viewed_.as_entered_.reset();
  if (entered_ != nullptr) entered_->polygons.reset();
}

/// The primitives of the items of a viewed scene, in order. Items whose points are the scene's
/// begin at the same corner as there; those of the others were recorded.
void SceneViewer::find_primitives(const RetainedScene& scene, const ViewedScene& viewed,
                                  std::size_t corners, std::vector<std::uint32_t>& primitives) {
  primitives.clear();
  std::uint32_t next = 0;
  std::size_t noted = 0;
  for (ViewedScene::Item item = 0; item < viewed.items(); ++item) {
    const std::uint32_t first = viewed.items_[item].first;
    if (first >= corners) {
      next = viewed.entered_of_item_[noted++];
    } else {
      while (scene[next].first != first) ++next;
    }
    primitives.push_back(next++);
  }
}

void SceneViewer::take_what_was_entered() {
  if (entered_->polygons != nullptr) return;
  auto polygons = std::make_shared<PolygonsAsEntered>();
  polygons->add(*scene_, [this](std::size_t segment) { return segments_[segment].visible; });
  entered_->reach = polygons->reach() * scene_->longest_column();
  entered_->in_world = {scene_->largest_in_world(), scene_->roundings_in_world()};
  entered_->polygons = std::move(polygons);
}

std::function<EnteredPolygon(std::uint32_t)> SceneViewer::polygon_of() const {
  return [entered = entered_](std::uint32_t number) { return entered->polygons->polygon(number); };
}

std::function<void(const ViewedScene&, std::vector<std::uint32_t>&)>
SceneViewer::polygons_of_items() const {
  return [scene = scene_, corners = corners_](const ViewedScene& viewed,
                                              std::vector<std::uint32_t>& primitives) {
    find_primitives(*scene, viewed, corners, primitives);
  };
}

void SceneViewer::begin_planes() {
  if (viewed_.planes_ != nullptr) {
    viewed_.planes_->rests_are_found.store(false);
    viewed_.planes_->coincident_are_found.store(false);
    return viewed_.planes_->are_found.store(false);
  }
  take_what_was_entered();
  viewed_.planes_ = std::make_shared<ViewedScene::Planes>();
  viewed_.planes_->entered_reach = entered_->polygons->reach();
  viewed_.planes_->reach = entered_->reach;
  viewed_.planes_->find_touching = [entered = entered_] {
    if (entered->planes == nullptr) {
      TouchingPlanes planes = entered->polygons->planes();
      planes.keep_members_alone();
      entered->planes = std::make_shared<const TouchingPlanes>(std::move(planes));
    }
    return entered->planes;
  };
  viewed_.planes_->find_near = [entered = entered_](const TouchingPlanes& touching) {
    return entered->polygons->near_planes(touching);
  };
  viewed_.planes_->polygon_of = polygon_of();
  viewed_.planes_->polygon_of_item = [scene = scene_, corners = corners_](std::uint32_t first) {
    return first < corners ? scene->primitive_of_corner(first) : ViewedScene::kNotEntered;
  };
  viewed_.planes_->polygons_of_items = polygons_of_items();
}

/// As EnteredPolygons::are_as_viewed, of all segments.
bool SceneViewer::is_as_viewed(const ViewVolume& volume) {
  if (!volume.is_identity()) return false;
  take_what_was_entered();
  return entered_->polygons->bent().empty() && scene_->is_entered_in_world() &&
         std::ranges::all_of(scene_->segments(), [](const RetainedScene::Segment& segment) {
           return segment.touching.kind == Touching::Kind::off;
         });
}

void SceneViewer::find_entered(const ViewVolume& volume) {
  viewed_.find_bent({});
  if (is_as_viewed(volume)) return viewed_.as_entered_.reset();
  take_what_was_entered();
  if (viewed_.as_entered_ == nullptr) {
    viewed_.as_entered_ = std::make_shared<ViewedScene::AsEntered>();
    viewed_.as_entered_->polygon_of = polygon_of();
    viewed_.as_entered_->polygons_of_items = polygons_of_items();
  }
  ViewedScene::AsEntered& all = *viewed_.as_entered_;
  all.own_volume = volume;
  all.are_found.store(false);
  all.images.clear();
  double longest = 1.0;
  for (const SegmentNow& segment : segments_) {
    all.images.push_back(&segment.image);
    if (segment.visible) longest = std::max(longest, ViewedScene::longest_of(segment.image));
  }
  all.radius = longest * ViewedScene::radius_in(volume.matrix(), entered_->in_world, 0.0,
                                                viewed_.largest_depth());
  viewed_.find_bent(entered_->polygons->bent());
}

/// If the planes were already found for another view, they cost little here.
void SceneViewer::find_radius(const ViewVolume& volume) {
  if (is_as_viewed(volume)) return viewed_.planes_.reset();
  if (viewed_.planes_ == nullptr) begin_planes();  // the scene has moved
  const double radius = ViewedScene::radius_in(volume.matrix(), entered_->in_world, entered_->reach,
                                               viewed_.largest_depth());
  viewed_.planes_->radius_of_ends = radius;
  viewed_.planes_->compares_ends =
      std::ranges::any_of(scene_->segments(), [&](const RetainedScene::Segment& segment) {
        return ViewedScene::may_reach(entered_->reach, segment.touching, volume);
      });
  for (const SegmentNow& segment : segments_) {
    if (!segment.visible) continue;
    viewed_.planes_->radius_of_ends =
        std::max(viewed_.planes_->radius_of_ends, radius * ViewedScene::longest_of(segment.image));
  }
  const bool looks_for_them = entered_->planes == nullptr && !has_images();
  viewed_.set_radius(*viewed_.planes_, radius, looks_for_them);
  if (viewed_.planes_->radius == 0.0) viewed_.planes();  // while the scene is where it is
}

}  // namespace displayfile
