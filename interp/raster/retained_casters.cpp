#include "interp/raster/retained_casters.h"

#include <algorithm>
#include <cmath>

namespace displayfile {

namespace {

/// The factor that accounts, with a margin, for a point that is off its polygon.
constexpr double kOffPolygon = 16.0;

/// The largest depth of everything that hides light, including edge-on fills.
double largest_depth(const ViewedScene& seen) {
  double largest = 0.0;
  for (const Point3& p : seen.primitives().points) largest = std::max(largest, std::abs(p.z));
  return largest;
}

}  // namespace

RetainedCasters::RetainedCasters(const RetainedScene& scene, int threads)
    : scene_(&scene), casters_(scene, threads), lists_(casters_, scene.size()) {}

bool RetainedCasters::take(const SceneViewer& viewer, const SceneViewer::Wanted& wanted,
                           const ViewedScene& seen) {
  take_lights(wanted.lights_turned);
  if (viewer.has_images()) return false;
  way_.emplace(wanted.view, casters_.bounds());
  if (!(way_->error(largest_depth(seen)) < casters_.margin())) return false;
  primitive_of_ = viewer.primitive_of_items();
  item_of_.assign(scene_->size(), kNotSeen);
  for (Item item = 0; item < primitive_of_.size(); ++item) item_of_[primitive_of_[item]] = item;
  return true;
}

/// Lists are valid only for the lights for which they were made.
void RetainedCasters::take_lights(const glm::dmat3& turned) {
  const auto attributes = scene_->all_attributes();
  bool stayed = toward_.size() == attributes.size();
  toward_.resize(attributes.size(), Point3(0.0));
  for (std::size_t k = 0; k < attributes.size(); ++k) {
    if (!attributes[k].light) continue;
    const Point3 toward = turned * attributes[k].light->toward;
    stayed = stayed && toward == toward_[k];
    toward_[k] = toward;
  }
  if (!stayed) lists_.clear();
}

RetainedCasters::Search RetainedCasters::begin_search(Item item, double depth_error) {
  const std::uint32_t primitive = primitive_of_[item];
  Search search{toward_[scene_->attributes_of_look((*scene_)[primitive].look)]};
  if (kOffPolygon * way_->stretch() * depth_error < casters_.margin()) {
    search.few = lists_.of(primitive, search.toward);
  }
  return search;
}

std::size_t RetainedCasters::bytes() const {
  return casters_.bytes() + lists_.bytes() + toward_.size() * sizeof(Point3) +
         item_of_.size() * sizeof(Item);
}

}  // namespace displayfile
