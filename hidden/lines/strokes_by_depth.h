#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "clip/surfaces.h"
#include "hidden/lines/line_overlaps.h"

namespace displayfile {

/// A part of a stroke: from and to are fractions of its length.
struct PartByDepth {
  std::uint32_t stroke;
  double from, to;
  LineCuts cuts;         ///< the ends at which another stroke cuts it
  bool is_between_gaps;  ///< a part of a stroke's middle between halos
};

/// Nearer strokes after farther ones (hidden/lines/strokes_by_depth.md): where two cross, or where
/// strokes that look different overlap in another way, the nearer one follows the farther one;
/// equally near ones are in order of entry. Otherwise strokes stay in the given order, so that
/// those which continue each other follow each other. A stroke is cut where no order of whole
/// strokes will do.
///
/// With a halo (pixels) above 0 the farther one of two strokes that cross is left out where its
/// axis is within the halo and half of the nearer pen's width of the nearer one's axis, next to the
/// crossing: of a straight line that is (halo + width / 2) / sin(angle) on both sides. It runs on
/// over strokes of the same look that continue each other. Lines that meet leave no gap, nor do
/// strokes where one continues the other.
std::vector<PartByDepth> strokes_by_depth(std::span<const DeepStroke> strokes,
                                          const StrokePicture& picture, double halo, int threads);

}  // namespace displayfile
