#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "interp/device/picture.h"
#include "tests/bench/seams/tilings.h"

namespace displayfile::bench {

/// What a tiling shows, from 16 x 16 samples a pixel, on white, of vertices rounded to `precision`
/// pixels of the unscaled picture. Top row first.
struct TrueCoverage {
  int side;
  struct Pixel {
    std::array<float, 3> colour;     ///< 0 to 255
    float covered;                   ///< 0 to 1
    std::uint8_t colours, in_reach;  ///< so many in the pixel, and within the reach of it; 3: more
    std::uint8_t near;               ///< so many in the pixel and those around it
    bool deep;                       ///< it and those around it are covered wholly
    std::array<std::uint32_t, 2> mixed;  ///< which, the first two
  };
  std::vector<Pixel> pixels;
};
/// `reach` in pixels of the unscaled picture.
TrueCoverage true_coverage(const Tiling& tiling, double scale, double precision, double reach);

/// Differences of the three channels' largest, of 255.
struct SeamError {
  /// The largest difference from any mix of the colours in a pixel and around it, of pixels that
  /// are covered wholly, as those around them, and have one such colour, or two: what is seen of
  /// anything else. (How much there is of each is the viewer's antialiasing.) With more than two
  /// within reach of traps: apart.
  double one = 0.0, two = 0.0, near_others = 0.0;
  /// The mean difference from the truth of pixels that are covered wholly and have two colours in
  /// them, or more.
  double mean_two = 0.0, mean_more = 0.0;
  /// The mean difference from the truth of pixels that are covered in part: by one colour, and
  /// where several meet on the outline.
  double outline = 0.0, outline_meeting = 0.0;
  double outside = 0.0;  ///< the largest of pixels that are not covered

  double inside() const { return one > two ? one : two; }
};
SeamError seam_error(const TrueCoverage& truth, const Picture& picture);

/// What a viewer would show of a figure that it drew as one path and filled with the true colours:
/// `black` is that path as it shows it, in black.
Picture as_one_path(const TrueCoverage& truth, const Picture& black);

}  // namespace displayfile::bench
