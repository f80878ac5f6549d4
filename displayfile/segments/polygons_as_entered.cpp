#include "displayfile/segments/polygons_as_entered.h"

#include <algorithm>
#include <cassert>
#include <memory>
#include <span>
#include <utility>

#include "clip/geometry/bounds.h"
#include "displayfile/entered/entered_polygons.h"
#include "displayfile/segments/retained_scene.h"
#include "hidden/exact/entered_plane.h"

namespace displayfile {

void PolygonsAsEntered::add(const EnteredPolygons& polygons) {
  const std::uint32_t first = parts_.empty() ? 0 : parts_.back().end;
  const auto end = first + static_cast<std::uint32_t>(polygons.size() + polygons.lines());
  add({first, end, &polygons, nullptr, 0}, polygons.touching(), polygons.largest());
  for (const std::uint32_t i : polygons.bent()) bent_.push_back(first + i);
}

void PolygonsAsEntered::add(const RetainedScene& scene,
                            const std::function<bool(std::size_t)>& is_visible) {
  for (std::size_t k = 0; k < scene.segments().size(); ++k) {
    const RetainedScene::Segment& segment = scene.segments()[k];
    const std::uint32_t first = parts_.empty() ? 0 : parts_.back().end;
    const std::uint32_t end = first + segment.end - segment.first;
    if (is_visible && !is_visible(k)) {
      parts_.push_back({first, end, nullptr, &scene, segment.first, false});
      continue;
    }
    double largest = 0.0;
    for (std::uint32_t i = segment.first; i < segment.end; ++i) {
      largest = std::max(largest, largest_coordinate(scene.entered_points(i)));
    }
    add({first, end, nullptr, &scene, segment.first}, segment.touching, largest);
    for (std::uint32_t i = segment.first; i < segment.end; ++i) {
      if (scene[i].sides <= 3) continue;
      const std::uint32_t number = first + i - segment.first;
      if (is_bent(polygon(number), largest)) bent_.push_back(number);
    }
  }
}

void PolygonsAsEntered::add(const Part& part, const Touching& touching, double largest) {
  close_ = std::make_shared<Close>();
  parts_.push_back(part);
  reach_ = std::max(reach_, entered_reach(touching, largest));
  largest_ = std::max(largest_, largest);
}

const ClosePlanes& PolygonsAsEntered::close() const {
  std::call_once(close_->are_found, [&] {
    close_->planes = ClosePlanes(
        size(), [this](std::uint32_t number) { return polygon(number); }, reach_,
        std::max(near(), reach_));
  });
  return close_->planes;
}

TouchingPlanes PolygonsAsEntered::planes() const {
  return planes_within(reach_, close().may_touch(), close().pairs());
}

std::shared_ptr<const TouchingPlanes> PolygonsAsEntered::near_planes(
    const TouchingPlanes& touching) const {
  if (!(near() > reach_)) return nullptr;
  const std::vector<std::uint32_t> may_be = close().near_others(touching);
  if (may_be.empty()) return nullptr;
  TouchingPlanes planes = planes_within(near(), may_be);
  planes.keep_members_alone();
  return std::make_shared<const TouchingPlanes>(std::move(planes));
}

/// Searches some of the polygons; the others are alone in their planes.
TouchingPlanes PolygonsAsEntered::planes_within(
    double reach, std::span<const std::uint32_t> looked_at,
    const std::vector<TouchingPlanes::Pair>* pairs) const {
  return {size(), looked_at, [&](std::uint32_t number) { return polygon(number); }, reach, pairs};
}

EnteredPolygon PolygonsAsEntered::polygon(std::uint32_t number) const {
  const Part& part = part_of(number);
  const std::uint32_t i = number - part.first;
  if (part.polygons != nullptr) {
    const EnteredPolygons& of_segment = *part.polygons;
    if (i >= of_segment.size()) return {of_segment.line(i - of_segment.size())};
    return {of_segment.points(i), of_segment.modelling(i)};
  }
  if (!part.is_visible) return {std::span<const Point3>()};
  const std::uint32_t primitive = part.first_of_scene + i;
  if (part.scene->is_entered_in_world()) return {part.scene->entered_points(primitive)};
  return {part.scene->entered_points(primitive), &part.scene->modelling_matrix(primitive)};
}

const PolygonsAsEntered::Part& PolygonsAsEntered::part_of(std::uint32_t number) const {
  assert(number < size());
  if (parts_.size() == 1) return parts_.front();
  return *std::ranges::upper_bound(parts_, number, {}, &Part::end);
}

}  // namespace displayfile
