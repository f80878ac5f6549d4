#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/transformation.h"
#include "clip/view.h"
#include "interp/truth/true_picture.h"

namespace displayfile {

/// A view in whole numbers: world coordinates to the points of a picture, and the clipping between
/// them, for world_truth alone. The doubles of the view's matrix, of the viewport and of the image
/// transformation's matrix are taken as they are, and nothing is rounded.
class ExactView {
 public:
  /// A point in the homogeneous coordinates of the view volume, 0 <= x, y, z <= w, all times
  /// `unit`, which is positive: true coordinates are those over it.
  struct Vertex {
    Integer x, y, z, w, unit;
  };

  /// Throws what ViewVolume throws.
  ExactView(const View& view, const ImageTransformation& image, int width, int height);

  Vertex viewed(const Point3& world) const;
  /// Clips the polygon in place against all planes of the view volume; empty if nothing is inside.
  void clip(std::vector<Vertex>& polygon);
  /// Where the vertex is seen; one with w not positive has no such place, but a plane through it
  /// is that plane.
  TruePoint in_picture(const Vertex& vertex) const;

  /// True if the polygon, of positive w, runs counterclockwise: its area has a positive sign.
  static bool faces_viewer(std::span<const Vertex> polygon);

 private:
  /// A plane of the view volume.
  enum class Side { back, front, eye, left, right, bottom, top };
  Integer inside(Side side, const Vertex& v) const;
  Vertex cut(const Vertex& in, const Integer& d_in, const Vertex& out, const Integer& d_out) const;
  void clip(Side side, std::vector<Vertex>& polygon);

  std::array<std::array<Integer, 4>, 4> matrix_;  // by rows, times 2^places_
  int places_ = 0;
  std::vector<Side> sides_;  // those that are active, in the order of clipping
  Integer nearest_w_;        // times 2^nearest_places_
  int nearest_places_ = 0;
  /// Volume to picture: x and y rows over (x, y, w), times 2^picture_places_.
  std::array<std::array<Integer, 3>, 2> picture_;
  int picture_places_ = 0;
  std::vector<Vertex> clipped_;
  std::vector<Integer> distances_;
};

}  // namespace displayfile
