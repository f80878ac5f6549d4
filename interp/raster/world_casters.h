#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "clip/geometry/bounds.h"
#include "displayfile/segments/retained_scene.h"
#include "hidden/boxes/space_tree.h"

namespace displayfile {

/// The possible shadow casters of a retained scene, in any view: its solid polygons in a tree of
/// boxes, made once for all eyes and all lights (interp/raster/shadows.md). World coordinates.
///
/// Searches return every polygon within the margin of being met, and others: the view decides which
/// of them hide the light.
class WorldCasters {
 public:
  using Primitive = std::uint32_t;

  /// The scene must outlive it unchanged; the tree does not depend on the number of threads.
  WorldCasters(const RetainedScene& scene, int threads);

  /// The allowed error of a point or a vertex.
  double margin() const { return margin_; }
  const Bounds& bounds() const { return bounds_; }  ///< of all casters
  std::size_t bytes() const { return tree_.bytes() + primitive_of_.size() * sizeof(Primitive); }

  /// Calls visit(primitive) for each polygon that the ray from that point in that direction may
  /// meet, until it returns true; then returns true.
  template <class Visit>
  bool any(const Point3& from, const Point3& toward, Visit&& visit) const {
    return tree_.any(SpaceRay(from, toward),
                     [&](SpaceTree::Position at) { return visit(primitive_of_[at]); });
  }

  /// Finds the polygons, except the receiver, that may hide light from this unit direction from a
  /// point of the receiver. Returns their number, or nothing if they do not fit into `few`.
  std::optional<std::size_t> find_casters_on(Primitive receiver, const Point3& toward,
                                             std::span<Primitive> few) const;

 private:
  const RetainedScene* scene_;
  std::vector<Primitive> primitive_of_;  // of the tree's positions
  Bounds bounds_;
  double margin_ = 0.0;
  SpaceTree tree_;
};

}  // namespace displayfile
