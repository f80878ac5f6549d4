#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "hidden/exact/entered_polygon.h"

namespace displayfile {

/// Finds which polygons of a scene lie in the support plane of another, by the definition
/// (interp/truth/entered_truth.md), from the points as entered. Exact. Method:
/// hidden/touching/touching_planes.md.
class TouchingPlanes {
 public:
  /// A polygon by its index. Its points and matrix must be valid until the next call; one with
  /// fewer than three points has no plane.
  using PolygonOf = std::function<EnteredPolygon(std::uint32_t)>;
  /// Numbers of comparisons, for tests and reports.
  struct Counts {
    std::uint64_t compared = 0;  ///< a polygon with a plane, roughly
    std::uint64_t tested = 0;    ///< of these, the ones that needed the definition
  };

  /// A polygon and one in whose plane it may lie, as indices among the examined polygons.
  struct Pair {
    std::uint32_t polygon, plane;
  };

  TouchingPlanes() = default;
  /// The polygons are 0 to `polygons` - 1, in order of entry. `reach` is before the modelling
  /// transformation (entered_reach of clip/surfaces.h); with 0 polygons are coplanar only if they
  /// are exactly. World coordinates are finite. Throws LimitReached beyond the budget in force.
  TouchingPlanes(std::uint32_t polygons, const PolygonOf& polygon_of, double reach);
  /// The same for these polygons only, in ascending order: others have no plane. If pairs are
  /// given, these are all that are compared: every polygon with each plane that it lies in is
  /// among them.
  TouchingPlanes(std::uint32_t polygons, std::span<const std::uint32_t> looked_at,
                 const PolygonOf& polygon_of, double reach,
                 const std::vector<Pair>* pairs = nullptr);

  /// The polygon in whose support plane the polygon lies: itself if it touches no other's, or has
  /// no plane. plane_of(plane_of(p)) = plane_of(p).
  std::uint32_t plane_of(std::uint32_t polygon) const {
    assert(polygon < plane_.size());
    return plane_[polygon] == kNone ? polygon : plane_[polygon];
  }
  bool has_plane(std::uint32_t polygon) const { return plane_[polygon] != kNone; }
  /// The number of polygons in the plane of another.
  std::size_t touching() const { return touching_; }

  /// Planes with more than one polygon are numbered from 0, in the order of the definition.
  std::size_t shared_planes() const { return first_member_.empty() ? 0 : first_member_.size() - 1; }
  /// The polygons in such a plane, in the order of the definition: decreasing area, then entry. The
  /// plane is that of the first.
  std::span<const std::uint32_t> members(std::size_t shared_plane) const {
    assert(shared_plane < shared_planes());
    const std::size_t first = first_member_[shared_plane];
    return std::span(members_).subspan(first, first_member_[shared_plane + 1] - first);
  }

  /// Keeps only shared_planes, members and touching, in little memory: nothing else may be called
  /// afterwards.
  void keep_members_alone();

  const Counts& counts() const { return counts_; }

 private:
  class Search;
  static constexpr std::uint32_t kNone = 0xffffffffu;

  std::vector<std::uint32_t> plane_;  // by polygon, the one in whose plane it lies
  std::vector<std::uint32_t> first_member_, members_;
  std::size_t touching_ = 0;
  Counts counts_;
};

}  // namespace displayfile
