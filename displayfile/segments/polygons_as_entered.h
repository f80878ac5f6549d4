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

/// The polygons of a scene as they were entered, by numbers, to find which of them lie in one
/// plane. What is added must stay.
class PolygonsAsEntered {
 public:
  /// Those of a segment, which are numbered on from those before, and then its lines.
  void add(const EnteredPolygons& polygons);
  /// The primitives of a scene, each numbered as there if nothing was added before; lines have two
  /// points. Those of segments, by their places, that are not visible have none; empty: all are.
  void add(const RetainedScene& scene, const std::function<bool(std::size_t)>& is_visible = {});

  /// Throws LimitReached where the thread's budget is used up.
  TouchingPlanes planes() const;
  /// The same within a reach of 2^-24 of the largest coordinate, members alone, of polygons that
  /// may have another plane near that in which they lie: planes that are so close would meet where
  /// viewing's rounding says. Null if there are none.
  std::shared_ptr<const TouchingPlanes> near_planes(const TouchingPlanes& touching) const;
  EnteredPolygon polygon(std::uint32_t number) const;
  /// The numbers of those that are not flat (hidden/exact/bent_polygon.h), rising.
  const std::vector<std::uint32_t>& bent() const { return bent_; }
  double reach() const { return reach_; }  ///< the largest, before modelling transformations

 private:
  struct Part {
    std::uint32_t first, end;         ///< of their numbers
    const EnteredPolygons* polygons;  ///< null: they are those of the scene
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
  TouchingPlanes planes_within(double reach, std::span<const std::uint32_t> looked_at) const;
  const Part& part_of(std::uint32_t number) const;
  void add(const Part& part, const Touching& touching, double largest);

  std::vector<Part> parts_;
  std::vector<std::uint32_t> bent_;
  double reach_ = 0.0, largest_ = 0.0;
  std::shared_ptr<Close> close_ = std::make_shared<Close>();  // copies find them once
};

}  // namespace displayfile
