#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "clip/surfaces.h"
#include "displayfile/segments/retained_scene.h"
#include "interp/truth/whole_points.h"

namespace displayfile {

/// The three vertices of a polygon that define its support plane, by the definition
/// (interp/truth/entered_truth.md), from the points as entered; none if all of them are exactly
/// collinear.
std::optional<std::array<std::size_t, 3>> entered_support(std::span<const Point3> entered);

/// The planes in which the polygons of a scene lie, by the definition alone: each polygon's own, or
/// that of a polygon that it touches. Exact; shares nothing with the methods.
class TruePlanes {
 public:
  /// The scene must outlive this; `touching` overrides that of its segments. Checks the thread's
  /// budget.
  TruePlanes(const RetainedScene& scene, const std::optional<Touching>& touching);

  /// A polygon's vertex in world coordinates.
  WholePoint vertex(std::uint32_t polygon, std::size_t corner) const;
  /// Three points of the polygon's support plane as entered; none if it has none.
  std::optional<std::array<WholePoint, 3>> own_plane(std::uint32_t polygon) const;
  /// The polygon in whose support plane the polygon lies: itself if it touches no other's.
  std::uint32_t plane_of(std::uint32_t polygon) const { return plane_of_[polygon]; }
  /// The number of polygons that lie in the plane of another.
  std::size_t touching() const;

 private:
  struct Plane;
  /// A reach is the square root of `squared` / 4^places.
  struct Reach {
    Integer squared;
    int places = 0;
  };
  struct Placed {
    WholeMatrix matrix;
    Reach reach;
  };

  Touching touching_of(const RetainedScene::Segment& segment) const {
    return touching_.value_or(segment.touching);
  }
  double entered_reach() const;
  void find_placings();
  void find_planes();
  const Placed& placed(std::uint32_t polygon) const { return placings_[placing_of_[polygon]]; }
  Plane plane_through(std::uint32_t polygon) const;
  bool lies_in(std::uint32_t polygon, const Plane& plane) const;

  const RetainedScene& scene_;
  std::optional<Touching> touching_;
  std::vector<Placed> placings_;           // of each modelling matrix one
  std::vector<std::uint32_t> placing_of_;  // by primitive
  std::vector<std::uint32_t> plane_of_;    // by primitive
};

}  // namespace displayfile
