#pragma once

#include <cstdint>

#include "interp/device/picture.h"
#include "interp/files/npy_file.h"

namespace displayfile {

/// How two pictures, or two arrays, of one size differ.
struct PictureDifference {
  bool same_size = true;          ///< if not, nothing else was compared
  std::int64_t pixels = 0;        ///< compared
  std::int64_t wrong_pixels = 0;  ///< different beyond the tolerance
  /// The largest difference of a channel of two pictures, 0 to 255, or the largest absolute
  /// difference of two values of arrays: infinite where one is infinite or NaN and the other is not
  /// equal.
  double largest = 0.0;
  /// For two int32 arrays, taken as item buffers: the number of wrong pixels where one of the two
  /// shows the background (a negative identifier), and of those where both show polygons.
  std::int64_t background_and_polygon = 0, polygon_and_polygon = 0;
  std::int64_t background_in_first = 0;  ///< of background_and_polygon: the second has the polygon
  /// For two float64 arrays, taken as depths: over the pixels where both are finite the largest and
  /// the mean absolute error, and how many pixels are finite in both and in only one.
  double largest_error = 0.0, mean_error = 0.0;
  std::int64_t finite_in_both = 0, finite_in_one = 0;

  bool differs() const { return !same_size || wrong_pixels != 0; }
};

/// Compares colours, not the item and depth buffers. Pixels whose channels, 0 to 255, differ by no
/// more than the tolerance are not wrong.
PictureDifference compare(const Picture& a, const Picture& b, int tolerance = 0);

/// Compares values; NaN equals NaN, and an int32 array may be compared with a float64 one.
PictureDifference compare(const NpyArray& a, const NpyArray& b);

/// Where the wrong pixels are: those red, the others in light grey, of item buffers a tone for
/// each identifier and white for the background, of float64 arrays one tone where finite, of
/// pictures their own brightness. Throws Error if the sizes differ.
Picture marked(const Picture& a, const Picture& b, int tolerance = 0);
Picture marked(const NpyArray& a, const NpyArray& b);

}  // namespace displayfile
