#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "clip/point.h"
#include "clip/view/view_volume.h"
#include "interp/visibility/world_geometry.h"

namespace displayfile {

/// Views single polygons as for the display file, but without rounding: their orientation after
/// clipping, and the positions of polygons that are off their plane
/// (interp/visibility/ray_cast.md).
class PolygonViewer {
 public:
  /// The rows are those of the volume's view; rows and volume must outlive this. `size` bounds the
  /// coordinates of polygons.
  PolygonViewer(const ViewVolume& volume, const in_world::MatrixRows<Ball>& near,
                const in_world::MatrixRows<ExactNumber>& exact, const Point3& size);

  /// True if clipping leaves a part of it, which does not face away if back faces are removed.
  bool is_seen(std::span<const Point3> polygon, bool both_sides);

  /// True if the last polygon for which is_seen returned true is certainly nowhere nearer, in the
  /// plane through these points, than that: by Z in a parallel view, by -W in perspective.
  bool is_nowhere_nearer(const std::array<Point3, 3>& plane, double nearness) const;

 private:
  /// Quantities linear in the picture; larger `nearness`, Z or 1 / W, is nearer.
  struct Seen {
    Ball x, y, nearness;
    Seen operator-(const Seen& o) const { return {x - o.x, y - o.y, nearness - o.nearness}; }
  };

  std::optional<bool> is_seen_in_balls(std::span<const Point3> polygon, bool both_sides);
  bool is_seen_exactly(std::span<const Point3> polygon, bool both_sides) const;
  bool is_surely_inside(std::span<const Point3> vertices);
  Seen seen(const in_world::WorldPoint<Ball>& p) const;
  int turn() const;

  const in_world::MatrixRows<Ball>& near_;
  const in_world::MatrixRows<ExactNumber>& exact_;
  bool perspective_;
  std::vector<in_world::OverBoxes> clip_;  // as near_.clip
  in_world::OverBoxes x_, y_, z_, w_;
  // Results for the polygon viewed last:
  std::vector<Seen> seen_;  // its vertices, none where balls did not decide
  in_world::WorldPoints<Ball> points_, cut_;
};

}  // namespace displayfile
