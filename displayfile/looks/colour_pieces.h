#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "clip/point.h"
#include "displayfile/looks/style.h"

namespace displayfile {

/// A corner of a polygon over which a colour is linear.
struct ColouredCorner {
  Point3 point;
  Point3 normal;  ///< of any length; 0 where there is none
  Colour colour;
};

/// Cuts triangles with colours at their corners into convex pieces of one colour each, where red,
/// green or blue passes a multiple of kStep. A piece has the middle of the range of each, so no
/// colour is off by more than half a step.
///
/// Points on a side depend on its two ends alone: triangles that share a side, with equal colours
/// at its ends, are cut at the same points of it, bit for bit. Points and normals keep their
/// coordinates, and are linear over the triangle as the colour is.
class ColourPieces {
 public:
  static constexpr int kSteps = 85;  ///< from 0 to 1
  static constexpr double kStep = 1.0 / kSteps;

  struct Piece {
    std::span<const ColouredCorner> corners;  ///< 3 or more; in the triangle's direction
    Colour fill;
  };

  void cut(const std::array<ColouredCorner, 3>& triangle);
  /// The pieces of the last triangle; valid until the next one is cut.
  std::size_t size() const { return ends_.size(); }
  Piece operator[](std::size_t piece) const;

 private:
  std::span<const ColouredCorner> corners_of(std::size_t piece) const;
  /// Cuts all pieces where one part of the colour, 0 to 2, passes a whole number of steps.
  void cut_at_steps(int part);
  void add_band(std::span<const ColouredCorner> polygon, int part, double low);
  void add_corner(const ColouredCorner& corner, std::size_t first);

  std::vector<ColouredCorner> corners_, cut_corners_;  // colours in steps
  std::vector<std::size_t> ends_, cut_ends_;           // of each piece, among the corners
};

}  // namespace displayfile
