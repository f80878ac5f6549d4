#pragma once

#include <optional>
#include <span>

#include "clip/point.h"
#include "displayfile/segments/viewed_scene.h"
#include "hidden/map/visible_map.h"
#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

/// Projects device coordinates along an infinitely distant light: parallel projectors along z,
/// larger z nearer to the light (displayfile/segments/lit_parts.md). Lines stay lines and planes
/// stay planes.
class LightProjection {
 public:
  /// `light` as in FillShadow::light. None if a point is not in front of it, which does not happen
  /// to points that the clip pipeline kept.
  static std::optional<LightProjection> of(const HomogeneousPoint& light,
                                           std::span<const Point3> points);

  Point3 operator()(const Point3& device) const;
  /// Perspective weight: the projected midpoint of p and q is the projection of (p / weight(p) + q
  /// / weight(q)) / (1 / weight(p) + 1 / weight(q)).
  double weight(const Point3& device) const { return value(weight_, device); }

 private:
  /// A linear form of the point and 1.
  using Row = HomogeneousPoint;
  static double value(const Row& row, const Point3& p) {
    return row.x * p.x + row.y * p.y + row.z * p.z + row.w;
  }
  static LightProjection from_afar(const HomogeneousPoint& light);
  static LightProjection from_nearby(const HomogeneousPoint& light);
  bool is_before(std::span<const Point3> points) const;

  Row across_{0.0}, up_{0.0}, depth_{0.0}, weight_{0.0};
};

/// The pieces of a scene's map, as of pieces_of_map, each lit or in shadow by SortedPieces::lights
/// (displayfile/segments/lit_parts.md). The scene shows shadows; `items` are its own. Device
/// coordinates.
SortedPieces lit_pieces_of_map(const ViewedScene& scene, const Primitives& items,
                               const MapOptions& options);

}  // namespace displayfile
