#pragma once

#include <span>
#include <vector>

#include "hidden/lines/hidden_parts.h"
#include "hidden/lines/line_overlaps.h"

namespace displayfile {

/// The pairs of strokes that continue each other: ends of strokes of one look at the same point are
/// paired, straightest pairs first (hidden/lines/chains.md). Remaining ends are paired where they
/// coincide in the picture only: the line between them is seen end-on.
class JoinedStrokes {
 public:
  explicit JoinedStrokes(std::span<const DeepStroke> strokes);

  static constexpr std::uint32_t kNone = 0xffffffffu;
  /// Ends are numbered: 2 * stroke where it starts, + 1 where it ends.
  std::uint32_t mate(std::uint32_t end) const { return mate_[end]; }
  /// True if one continues the other.
  bool join(std::uint32_t a, std::uint32_t b) const {
    const auto is_of_b = [&](std::uint32_t end) { return end != kNone && end / 2 == b; };
    return is_of_b(mate_[std::size_t{2} * a]) || is_of_b(mate_[std::size_t{2} * a + 1]);
  }

 private:
  void pair(std::uint32_t a, std::uint32_t b) {
    mate_[a] = b;
    mate_[b] = a;
  }
  std::vector<std::uint32_t> mate_;
};

/// For each stroke the parts that the halos of nearer strokes leave out, united. No overlap may be
/// of strokes that join.
std::vector<std::vector<PartOfLine>> halo_gaps(std::span<const DeepStroke> strokes,
                                               std::span<const StrokeOverlap> overlaps,
                                               const JoinedStrokes& joints, const Point2& pixels,
                                               double halo);

}  // namespace displayfile
