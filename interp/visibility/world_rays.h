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

  /// The visible pick identifiers, row by row from the top, -1 for none; on up to `threads`
  /// threads, with the same result. Throws Error as ViewVolume does.
  std::vector<std::int32_t> picks(const View& view, const PictureSize& size, int threads = 1) const;

  /// Casts the rays of a row of pixel centres, counted from the bottom: sets the visible primitive
  /// of scene() for each, or kNothing. Several threads may call it at a time.
  using CastRow = std::function<void(int row, std::span<std::uint32_t> seen)>;
  static constexpr std::uint32_t kNothing = ~std::uint32_t{0};
  /// The rays of a picture, which must not outlive this. They see those primitives alone for which
  /// `is_there` says so, all if it is empty. Throws Error as ViewVolume does.
  CastRow rays(const View& view, const PictureSize& size,
               std::function<bool(std::uint32_t)> is_there = {}) const;

  /// What the ray through one point sees.
  struct Seen {
    std::uint32_t primitive;
    Point3 point;  ///< where, in world coordinates, rounded
  };
  /// At a point of the picture (device coordinates, 0 to 1 over the picture); nothing outside of
  /// the viewport. Throws Error as ViewVolume does.
  std::optional<Seen> seen_at(const View& view, const Point2& at) const;

  const RetainedScene& scene() const { return world_; }  ///< the visible segments
  std::size_t polygons() const { return polygons_.size(); }

 private:
  /// A solid fill that has a plane.
  struct Polygon {
    static constexpr std::uint32_t kAlike = ~std::uint32_t{0};
    std::uint32_t primitive;        ///< in order of entry
    Primitives::PlanePoints plane;  ///< in which it is visible, by points of the world
    std::uint32_t by_view;  ///< its number among those of which each view makes something else
    std::int8_t turn;       ///< 1 if it runs as those three do, -1 if the other way round, or 0
    bool flat;              ///< no vertex is off that plane
    bool both_sides;        ///< back faces are kept
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
