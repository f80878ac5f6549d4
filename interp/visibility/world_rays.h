#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/view.h"
#include "displayfile/display_file.h"
#include "displayfile/retained_scene.h"
#include "hidden/exact/pixel_centre.h"
#include "hidden/space_tree.h"

namespace displayfile {

/// Ray casting in object space: in world coordinates, before viewing, a ray runs from the eye
/// (perspective) or along a projector (parallel) through each pixel's centre to the nearest solid
/// fill. The hierarchy of boxes through which it finds its way belongs to the world, and serves
/// every view.
///
/// What a ray hits is decided as if the world's polygons went through the view's matrix unrounded
/// (interp/visibility/ray_cast.md). Lines are not seen.
class WorldRays {
 public:
  /// Takes the visible segments as they now are; `attributes` is the display file of the system
  /// that retained them. Throws Error if one has an image transformation: those act after viewing.
  WorldRays(const RetainedScene& scene, const DisplayFile& attributes);

  /// The pick identifiers seen, row by row from the top, -1 where there is none; on up to so many
  /// threads, with the same result. Throws Error as ViewVolume does.
  std::vector<std::int32_t> picks(const View& view, const PictureSize& size, int threads = 1) const;

  std::size_t polygons() const { return polygons_.size(); }

 private:
  /// A solid fill that has a plane.
  struct Polygon {
    std::uint32_t primitive;              ///< in order of entry
    std::array<std::uint32_t, 3> spread;  ///< the vertices whose plane it is in
    std::int8_t turn;  ///< 1 if it runs as those three do, -1 if the other way round
    std::int8_t axis;  ///< that its plane faces most; off it, a vertex counts as moved along it
    bool flat;         ///< no vertex is off it
    bool both_sides;   ///< back faces are kept
  };
  class Caster;

  void enter(std::uint32_t primitive);
  Bounds bounds_of(const Polygon& polygon) const;
  void build();
  std::span<const Point3> points(const Polygon& polygon) const {
    return world_.points(polygon.primitive);
  }

  RetainedScene world_;
  std::vector<Polygon> polygons_;  // as the tree has them
  SpaceTree tree_;
  Point3 size_{0.0};  // no coordinate of a box is larger
};

}  // namespace displayfile
