#pragma once

#include <optional>
#include <span>
#include <vector>

#include "clip/clip_pipeline.h"
#include "clip/point.h"
#include "interp/visibility/world_geometry.h"

namespace displayfile {

/// What a view makes of single polygons, as the display file views them, but without rounding:
/// which way they turn once they are clipped, and in which plane those are seen that are not flat
/// (interp/visibility/ray_cast.md).
class PolygonViewer {
 public:
  /// The rows are those of the volume's view, and must live on, as the volume must. No coordinate
  /// of a polygon is larger than `size`.
  PolygonViewer(const ViewVolume& volume, const in_world::ViewRows<Ball>& near,
                const in_world::ViewRows<ExactNumber>& exact, const Point3& size);

  struct Polygon {
    std::span<const Point3> vertices;
    bool flat;
    bool both_sides;  ///< back faces are kept
  };
  struct Viewed {
    in_world::Support support{};  ///< of what is not flat: the vertices left that give its plane
    bool cut = false;             ///< clipping made some of those left
    bool seen = false;            ///< something is left, and it does not turn its back
  };
  Viewed view(const Polygon& polygon);

  /// True if the polygon viewed last, which is seen and not flat, is surely nowhere nearer in its
  /// plane than that: by Z in a parallel view, by -W in perspective.
  bool is_nowhere_nearer(const Viewed& viewed, double nearness) const;

 private:
  /// What is linear in the picture; it is nearer where `nearness`, Z or 1 / W, is larger.
  struct Seen {
    Ball x, y, nearness;
    Seen operator-(const Seen& o) const { return {x - o.x, y - o.y, nearness - o.nearness}; }
  };

  std::optional<Viewed> view_in_balls(const Polygon& polygon);
  Viewed view_exactly(const Polygon& polygon);
  bool is_surely_inside(std::span<const Point3> vertices);
  int turn() const;
  std::optional<in_world::Support> support_in_display_file(std::span<const Point3> vertices,
                                                           std::size_t left);

  const in_world::ViewRows<Ball>& near_;
  const in_world::ViewRows<ExactNumber>& exact_;
  bool perspective_;
  ClipPipeline pipeline_;
  std::vector<in_world::OverBoxes> clip_;  // as near_.clip
  in_world::OverBoxes x_, y_, z_, w_;
  // What is known of the polygon viewed last:
  std::vector<Seen> seen_;  // its vertices, none where balls did not decide
  in_world::WorldPoints<Ball> points_, cut_;
};

}  // namespace displayfile
