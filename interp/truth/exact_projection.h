#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/view.h"
#include "clip/view/transformation.h"
#include "interp/truth/true_picture.h"
#include "interp/truth/whole_points.h"

namespace displayfile {

/// A view in integers: world coordinates to the points of a picture, and the clipping between them,
/// for world_truth alone. The doubles of the view's matrix, of the viewport and of the image
/// transformation's matrix are taken as exact, and nothing is rounded.
class ExactProjection {
 public:
  /// A point in the homogeneous coordinates of the view volume, 0 <= x, y, z <= w, and the z of its
  /// view-plane coordinates, all times `unit`, which is positive: true coordinates are those over
  /// it.
  struct Vertex {
    Integer x, y, z, w, toward, unit;
  };

  /// Throws the same errors as ViewVolume.
  ExactProjection(const View& view, const ImageTransformation& image, int width, int height);

  Vertex viewed(const WholePoint& world) const;
  /// Clips the polygon in place against all planes of the view volume; empty if nothing is inside.
  void clip(std::vector<Vertex>& polygon);
  /// The vertex in the picture; one with w not positive has no image, but a plane through it is
  /// still that plane.
  TruePoint in_picture(const Vertex& vertex) const;

  /// True if the polygon, of positive w, runs counterclockwise: its area has a positive sign.
  static bool faces_viewer(std::span<const Vertex> polygon);

 private:
  /// A plane of the view volume.
  enum class Side { back, front, eye, left, right, bottom, top };
  Integer inside(Side side, const Vertex& v) const;
  Vertex cut(const Vertex& in, const Integer& d_in, const Vertex& out, const Integer& d_out) const;
  void clip(Side side, std::vector<Vertex>& polygon);

  using Row = std::array<Integer, 4>;
  std::array<Row, 4> matrix_;  // times 2^places_
  Row toward_;                 // likewise; zero where neither the front nor the back plane clips
  int places_ = 0;
  std::vector<Side> sides_;  // those that are active, in the order of clipping
  /// The position of a plane along a coordinate: times 2^places.
  struct Limit {
    Integer at;
    int places = 0;
    Limit() = default;
    explicit Limit(double value);
    /// The distance of a vertex's coordinate beyond the plane, times a positive factor.
    Integer exceeded_by(const Integer& coordinate, const Integer& unit) const;
  };
  Limit eye_, front_, back_;
  /// Volume to picture: x and y rows over (x, y, w), times 2^picture_places_.
  std::array<std::array<Integer, 3>, 2> picture_;
  int picture_places_ = 0;
  std::vector<Vertex> clipped_;
  std::vector<Integer> distances_;
};

}  // namespace displayfile
