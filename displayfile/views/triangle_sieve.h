#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "clip/point.h"
#include "hidden/exact/pixel_centre.h"

namespace displayfile {

/// A transformed vertex in a picture of up to 65535 pixels per side: in 2^-15 pixels, rounded to
/// nearest, with an error of at most one unit.
struct PicturePlace {
  std::int32_t x, y;
  static constexpr int kBits = 15;
  /// The vertex is outside of the view volume.
  static constexpr std::int32_t kOutside = std::numeric_limits<std::int32_t>::min();
};

/// The range of pixel centres along a side of the picture that may lie between two places; it
/// contains all that do.
struct CentresBetween {
  CentresBetween(std::int32_t low, std::int32_t high)
      : first((low - 1 + kPixel - 1 - kHalf) >> PicturePlace::kBits),
        count(((high + 1 - kHalf) >> PicturePlace::kBits) + 1 - first) {}
  std::int32_t first, count;

  static constexpr std::int32_t kPixel = 1 << PicturePlace::kBits, kHalf = kPixel / 2;
};

/// The places of vertices in a picture of that size. `device` are their device coordinates, 0 for
/// outside ones by outcode. Returns their largest |z|. Uses the processor's widest vectors.
double find_places(std::span<const Point3> device, std::span<const std::uint8_t> outcodes,
                   const PictureSize& size, std::span<PicturePlace> places);

/// Centres are tested one by one if there are at most this many columns and rows of them.
inline constexpr std::int32_t kFewCentres = 3;

/// Certain results for some triangles; bit i is triangle i's.
struct SievedTriangles {
  static constexpr std::size_t kMost = 64;
  std::uint64_t stays = 0;        ///< has an area, and may cover a centre
  std::uint64_t needs_more = 0;   ///< is outside of a plane with a vertex, or too thin to decide
  std::uint64_t turned_away = 0;  ///< of those that stay: runs clockwise
};

/// Classifies n triangles, at most kMost, whose corners are the places with those three indices
/// each, less than 2^30; a triangle that neither stays nor needs more covers no pixel centre. In
/// vectors, with single precision: a centre farther outside of a side than the rounding error is
/// not covered.
///
/// The error: a triangle is measured from a centre in its box or a pixel beside it, so its
/// coordinates are at most m + 1, where m is the longer side of the box, in pixels. They are off by
/// 2^-16, a difference by 2^-15, so a difference of two products by 2^-14 (m + 1), and from centre
/// to centre 2^-15 are added, six times at most; with the rounding of single precision that is less
/// than 2^-11 (m + 1) + 2^-20 m m. Where m is more than 512 a triangle needs more.
SievedTriangles sieve_triangles(const std::uint32_t* corners, std::size_t n,
                                const PicturePlace* places);

}  // namespace displayfile
