#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "clip/bounds.h"
#include "displayfile/segments/retained_scene.h"
#include "hidden/boxes/space_tree.h"

namespace displayfile {

/// What may hide light in a retained scene, in any view of it: its solid polygons in a tree of
/// boxes, made once for all eyes and all lights (interp/raster/shadows.md). World coordinates.
///
/// Whoever asks hears of every polygon that comes within the margin of being met, and of others:
/// which of them do hide the light is decided in the view.
class WorldCasters {
 public:
  using Primitive = std::uint32_t;

  /// The scene must live on and stay as it is; the tree is the same for any number of threads.
  WorldCasters(const RetainedScene& scene, int threads);

  /// A point, or a vertex, may be off by so much.
  double margin() const { return margin_; }
  const Bounds& bounds() const { return bounds_; }  ///< of all casters
  std::size_t bytes() const { return tree_.bytes() + primitive_of_.size() * sizeof(Primitive); }

  /// Calls visit(primitive) for what the ray from that point in that direction may meet, until it
  /// returns true: then true.
  template <class Visit>
  bool any(const Point3& from, const Point3& toward, Visit&& visit) const {
    return tree_.any(SpaceRay(from, toward),
                     [&](SpaceTree::Position at) { return visit(primitive_of_[at]); });
  }

  /// The polygons, but for the receiver itself, that may hide light that comes from that unit
  /// direction from some point of it, in `few`. Returns how many, or nothing if there are more.
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
