#include "interp/visibility/world_ray_cast.h"

#include <algorithm>

#include "clip/base/error.h"
#include "interp/device/viewed_world.h"
#include "interp/visibility/close_depths.h"

namespace displayfile {

namespace {

/// The fills of a scene by their items.
std::vector<ViewedScene::Fill> fills_of_items(const ViewedScene& scene) {
  std::vector<ViewedScene::Fill> fills(scene.items(), ViewedScene::kBackground);
  for (ViewedScene::Fill fill = 1; fill < scene.end(); ++fill) fills[scene.item_of(fill)] = fill;
  return fills;
}

}  // namespace

void WorldRayCast::prepare(const Request& request, int) {
  if (world_ == nullptr) {
    throw Error(
        "hidden-surface method 'world-ray-cast' casts rays before viewing: expected a scene that "
        "was retained in world coordinates from the first segment on");
  }
  if (request.roundoff) {
    throw Error(
        "hidden-surface method 'world-ray-cast' decides exactly, without a ROUNDOFF: expected "
        "precision exact");
  }
  request_.emplace(request);
  const ViewedWorld& world = *world_;
  const auto fills = fills_of_items(request.scene);
  fill_of_.clear();
  for (const ViewedWorld::Source& source : world.sources) {
    const bool entered = source.item != ViewedWorld::Source::kNotSeen;
    fill_of_.push_back(entered ? fills[source.item] : ViewedScene::kBackground);
  }
  rays_.clear();
  for (std::uint32_t view = 0; view < world.views.size(); ++view) {
    const auto is_there = [this, &world, view](std::uint32_t primitive) {
      return fill_of_[primitive] != ViewedScene::kBackground &&
             world.sources[primitive].view == view;
    };
    rays_.push_back(world.rays->rays(world.views[view], request.size, is_there));
  }
  depths_ = rays_.size() < 2 ? FillDepths() : FillDepths(request.scene, request.size, {});
}

/// Where rays of several views hit fills, the nearest of these is visible.
void WorldRayCast::draw_rows(int row_begin, int row_end, const SeenRun& seen) const {
  const auto width = static_cast<std::size_t>(request_->size.width);
  std::vector<std::uint32_t> primitives(width);
  std::vector<Fill> nearest(width);
  CloseDepths close(request_->scene, depths_, request_->size);
  for (int row = row_begin; row < row_end; ++row) {
    std::ranges::fill(nearest, ViewedScene::kBackground);
    for (const WorldRays::CastRow& cast_row : rays_) {
      cast_row(row, primitives);
      for (std::size_t k = 0; k < width; ++k) {
        if (primitives[k] == WorldRays::kNothing) continue;
        const Fill fill = fill_of_[primitives[k]];
        if (nearest[k] == ViewedScene::kBackground ||
            close.hides(fill, nearest[k], static_cast<int>(k), row)) {
          nearest[k] = fill;
        }
      }
    }
    seen(row, 0, nearest);
  }
}

}  // namespace displayfile
