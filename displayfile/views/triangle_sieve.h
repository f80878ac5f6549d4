#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "clip/point.h"
#include "hidden/exact/pixel_centre.h"

namespace displayfile {

/// Where a viewed vertex is in a picture of up to 65535 pixels a side: in 2^-15 pixels, rounded to
/// the nearest, so that it is off by no more than one of them.
struct PicturePlace {
  std::int32_t x, y;
  static constexpr int kBits = 15;
  /// The vertex is outside of the view volume.
  static constexpr std::int32_t kOutside = std::numeric_limits<std::int32_t>::min();
};

/// The centres of pixels along a side of the picture that may lie between two places: all that do
/// are among them.
struct CentresBetween {
  CentresBetween(std::int32_t low, std::int32_t high)
      : first((low - 1 + kPixel - 1 - kHalf) >> PicturePlace::kBits),
        count(((high + 1 - kHalf) >> PicturePlace::kBits) + 1 - first) {}
  std::int32_t first, count;

  static constexpr std::int32_t kPixel = 1 << PicturePlace::kBits, kHalf = kPixel / 2;
};

/// The places of vertices in a picture of that size. `device` are their device coordinates, 0 of
/// those that their outcode says to be outside. Returns the largest |z| of them. In vectors: the
/// widest that the processor has.
double find_places(std::span<const Point3> device, std::span<const std::uint8_t> outcodes,
                   const PictureSize& size, std::span<PicturePlace> places);

/// Centres are looked at one by one where there are no more columns, and no more rows, of them.
inline constexpr std::int32_t kFewCentres = 3;

/// What is certain of some triangles; bit i is triangle i's.
struct SievedTriangles {
  static constexpr std::size_t kMost = 64;
  std::uint64_t stays = 0;        ///< has an area, and may cover a centre
  std::uint64_t needs_more = 0;   ///< is outside of a plane with a vertex, or too thin to tell
  std::uint64_t turned_away = 0;  ///< of those that stay: runs clockwise
};

/// Looks at n triangles, kMost at most, whose corners are the places of those three numbers each,
/// less than 2^30; what neither stays nor needs more covers no centre of a pixel. In vectors, with
/// single precision: a centre that is farther outside of a side than rounding can do is not
/// covered.
///
/// The error: a triangle is measured from a centre in its box or a pixel beside it, so its
/// coordinates are at most m + 1, where m is the longer side of the box, in pixels. They are off by
/// 2^-16, a difference by 2^-15, so a difference of two products by 2^-14 (m + 1), and from centre
/// to centre 2^-15 are added, six times at most; with the rounding of single precision that is less
/// than 2^-11 (m + 1) + 2^-20 m m. Where m is more than 512 a triangle needs more.
SievedTriangles sieve_triangles(const std::uint32_t* corners, std::size_t n,
                                const PicturePlace* places);

}  // namespace displayfile
