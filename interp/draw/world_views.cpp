#include "interp/draw/world_views.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "clip/base/error.h"
#include "clip/base/round_to_nearest.h"
#include "displayfile/segments/polygon_stage.h"
#include "displayfile/views/taken_scene.h"
#include "interp/visibility/world_rays.h"

namespace displayfile {

namespace {

/// Enters the segments of a scene, each in one of several views.
class EnteredSegments {
 public:
  explicit EnteredSegments(std::shared_ptr<const WorldRays> rays) {
    world_.sources.resize(rays->scene().size());
    world_.rays = std::move(rays);
  }

  void enter(const RetainedScene::Segment& part, const View& view,
             const glm::dmat3& lights_turned) {
    const auto number =
        static_cast<std::uint32_t>(std::ranges::find(world_.views, view) - world_.views.begin());
    if (number == world_.views.size()) world_.views.push_back(view);
    const ViewVolume volume(view);
    PolygonStage stage(volume);
    Segment& segment = world_.display_file.create(part.name);
    world_.rays->scene().enter_viewed(part, Eye::of(view), stage, lights_turned, segment,
                                      [&](std::uint32_t i) {
                                        world_.sources[i] = {items_++, number};
                                      });
    segment.close();
  }
  ViewedWorld take() { return std::move(world_); }

 private:
  ViewedWorld world_;
  std::uint32_t items_ = 0;
};

}  // namespace

struct WorldViews::Kept {
  TakenScene taken;
  std::shared_ptr<const WorldRays> rays;
  std::mutex mutex;

  Kept(const RetainedScene& scene, const DisplayFile& attributes) : taken(scene, attributes) {
    take();
  }
  void take() {
    rays = std::make_shared<WorldRays>(taken.scene(), taken.attributes());
    taken.take();
  }
};

WorldViews::WorldViews(const RetainedScene& scene, const DisplayFile& attributes)
    : kept_(std::make_shared<Kept>(scene, attributes)) {}

/// Rays into the current scene.
std::shared_ptr<const WorldRays> WorldViews::rays() const {
  const RoundToNearest nearest;
  const std::lock_guard in_turn(kept_->mutex);
  if (!kept_->taken.is_gone() && !kept_->taken.is_same()) kept_->take();
  return kept_->rays;
}

ViewedWorld WorldViews::view(const View& view, const glm::dmat3& lights_turned) const {
  const RoundToNearest nearest;
  const auto world = rays();
  EnteredSegments segments(world);
  for (const RetainedScene::Segment& part : world->scene().segments()) {
    segments.enter(part, view, lights_turned);
  }
  return segments.take();
}

ViewedWorld WorldViews::as_drawn() const {
  const RoundToNearest nearest;
  const auto world = rays();
  EnteredSegments segments(world);
  for (const RetainedScene::Segment& part : world->scene().segments()) {
    segments.enter(part, part.view, glm::dmat3(1.0));
  }
  return segments.take();
}

std::optional<Pick> WorldViews::pick(const View& view, double x, double y) const {
  const RoundToNearest nearest;
  if (!std::isfinite(x) || !std::isfinite(y)) throw Error("a point to pick at is not finite");
  const auto world = rays();
  const auto seen = world->seen_at(view, {x, y});
  if (!seen) return std::nullopt;
  const RetainedScene& scene = world->scene();
  const ViewVolume volume(view);
  return Pick{Pick::Kind::polygon, scene[seen->primitive].pick,
              scene.segment_of(seen->primitive).name,
              volume.to_device(volume.transform(seen->point)).z, seen->point};
}

std::size_t WorldViews::polygons() const { return rays()->polygons(); }

}  // namespace displayfile
