#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "clip/surfaces.h"
#include "hidden/exact/entered_polygon.h"
#include "hidden/touching/close_planes.h"
#include "hidden/touching/touching_planes.h"

namespace displayfile {

class EnteredPolygons;
class RetainedScene;

/// A scene's polygons as entered, by index, for finding which of them are coplanar. Added objects
/// must outlive it.
class PolygonsAsEntered {
 public:
  /// Adds a segment's polygons, then its lines, numbered after those before.
  void add(const EnteredPolygons& polygons);
  /// Adds a scene's primitives, numbered as in the scene if nothing was added before; lines have
  /// two points. Those of invisible segments, by position, have no points; empty: all are visible.
  void add(const RetainedScene& scene, const std::function<bool(std::size_t)>& is_visible = {});

  /// Throws LimitReached beyond the thread's budget.
  TouchingPlanes planes() const;
  /// The same with a reach of 2^-24 of the largest coordinate, members only, for polygons that may
  /// have another plane near their own: planes this close would intersect where viewing's rounding
  /// puts it. Null if there are none.
  std::shared_ptr<const TouchingPlanes> near_planes(const TouchingPlanes& touching) const;
  EnteredPolygon polygon(std::uint32_t number) const;
  /// Indices of those that are not planar (hidden/exact/entered_plane.h), ascending.
  const std::vector<std::uint32_t>& bent() const { return bent_; }
  double reach() const { return reach_; }  ///< the largest, before modelling transformations

 private:
  struct Part {
    std::uint32_t first, end;         ///< numbers
    const EnteredPolygons* polygons;  ///< null: those of the scene
    const RetainedScene* scene;
    std::uint32_t first_of_scene;
    bool is_visible = true;
  };
  struct Close {
    std::once_flag are_found;
    ClosePlanes planes;
  };
  std::uint32_t size() const { return parts_.empty() ? 0 : parts_.back().end; }
  double near() const { return 0x1p-24 * largest_; }
  const ClosePlanes& close() const;
  TouchingPlanes planes_within(double reach, std::span<const std::uint32_t> looked_at,
                               const std::vector<TouchingPlanes::Pair>* pairs = nullptr) const;
  const Part& part_of(std::uint32_t number) const;
  void add(const Part& part, const Touching& touching, double largest);

  std::vector<Part> parts_;
  std::vector<std::uint32_t> bent_;
  double reach_ = 0.0, largest_ = 0.0;
  std::shared_ptr<Close> close_ = std::make_shared<Close>();  // copies find them once
};

}  // namespace displayfile
