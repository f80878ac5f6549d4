#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/point.h"

namespace displayfile {

/// A fill to be hatched, its corners [first, end) in arrays of all.
struct HatchedFill {
  std::size_t first, end;
  bool is_even;  ///< as dark everywhere, up to kSameTone
  double area;   ///< in square millimetres
  Point2 slope;  ///< of its plane: depth by millimetre to the right, and down
};

/// Differences of darkness up to this are invisible in a drawing. Rounded normals of one flat face
/// differ by less.
inline constexpr double kSameTone = 1e-3;

/// Flat faces: connected fills with the plane and the darkness of the first one.
struct HatchedFaces {
  std::vector<std::uint32_t> face_of;  ///< of each fill: the first fill of its face
  /// For each fill, 1 if its face is a facet of a round surface: it shares a side with a fill that
  /// is not even and is equally dark along that side, or with such a facet of its own darkness. A
  /// face more than eight times as large as the adjacent facet is not one
  /// (interp/vector/pens/hatching.md).
  std::vector<std::uint8_t> is_facet;
};
HatchedFaces hatched_faces(std::span<const HatchedFill> fills, std::span<const Point2> points,
                           std::span<const double> darkness);

}  // namespace displayfile
