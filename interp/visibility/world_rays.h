#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "clip/view.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/retained_scene.h"
#include "hidden/boxes/space_tree.h"
#include "hidden/exact/pixel_centre.h"
#include "hidden/primitives.h"

namespace displayfile {

/// Ray casting in object space: in world coordinates, before viewing, a ray runs from the eye
/// (perspective) or along a projector (parallel) through each pixel's centre to the nearest solid
/// fill. The hierarchy of boxes that it traverses belongs to the world, and serves every view.
///
/// Hits are decided as if the world's polygons were transformed by the view's matrix without
/// rounding (interp/visibility/ray_cast.md). Lines are ignored.
class WorldRays {
 public:
  /// Takes the visible segments in their current state; `attributes` is the display file of the
  /// system that retained them. Throws Error if one has an image transformation: those act after
  /// viewing.
  WorldRays(const RetainedScene& scene, const DisplayFile& attributes);

  /// The visible pick identifiers, row by row from the top, -1 for none; on up to `threads`
  /// threads, with the same result. Throws Error as ViewVolume does.
  std::vector<std::int32_t> picks(const View& view, const PictureSize& size, int threads = 1) const;

  /// Casts the rays of a row of pixel centres, counted from the bottom: sets the visible primitive
  /// of scene() for each, or kNothing. Several threads may call it at a time.
  using CastRow = std::function<void(int row, std::span<std::uint32_t> seen)>;
  static constexpr std::uint32_t kNothing = ~std::uint32_t{0};
  /// The rays of a picture, which must not outlive this. They hit only primitives for which
  /// `is_there` is true, all if it is empty. Throws Error as ViewVolume does.
  CastRow rays(const View& view, const PictureSize& size,
               std::function<bool(std::uint32_t)> is_there = {}) const;

  /// The result of the ray through one point.
  struct Seen {
    std::uint32_t primitive;
    Point3 point;  ///< the visible point, in world coordinates, rounded
  };
  /// The fill visible at a point of the picture (device coordinates, 0 to 1 over the picture); none
  /// outside of the viewport. Throws Error as ViewVolume does.
  std::optional<Seen> seen_at(const View& view, const Point2& at) const;

  const RetainedScene& scene() const { return world_; }  ///< the visible segments
  std::size_t polygons() const { return polygons_.size(); }

 private:
  /// A solid fill that has a plane.
  struct Polygon {
    static constexpr std::uint32_t kAlike = ~std::uint32_t{0};
    std::uint32_t primitive;        ///< in order of entry
    Primitives::PlanePoints plane;  ///< in which it is visible, by points of the world
    std::uint32_t by_view;          ///< its number among those whose visibility depends on the view
    std::int8_t turn;  ///< 1 if it has the orientation of those three, -1 if the opposite, or 0
    bool flat;         ///< no vertex is off that plane
    bool both_sides;   ///< back faces are kept
  };
  class Caster;
  class PictureRays;

  void enter(std::uint32_t primitive, std::span<const Primitives::PlanePoints> shared);
  std::optional<Primitives::PlanePoints> plane_of(
      std::uint32_t primitive, std::span<const Primitives::PlanePoints> shared) const;
  std::array<Point3, 3> corners_of_plane(const Polygon& polygon) const;
  Bounds bounds_of(const Polygon& polygon) const;
  void build();
  PointRow points(const Polygon& polygon) const { return world_.points(polygon.primitive); }

  RetainedScene world_;
  std::vector<Polygon> polygons_;       // as the tree has them
  std::vector<std::uint32_t> by_view_;  // those that are not flat, or may turn either way
  SpaceTree tree_;
  Point3 size_{0.0};  // no coordinate of a box is larger
};

}  // namespace displayfile
