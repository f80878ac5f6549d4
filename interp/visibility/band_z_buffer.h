#pragma once

#include <cstdint>
#include <vector>

#include "interp/visibility/image_space.h"
#include "interp/visibility/polygon_z_buffer.h"
#include "interp/visibility/row_fills.h"

namespace displayfile {

/// The z-buffer, fast and exact (interp/visibility/band_z_buffer.md): fills are made ready once for
/// a size and sorted into bands of a few rows, whose depths and fills stay in the cache while they
/// are drawn in vectors of single precision; what that leaves undecided, and only that, is decided
/// exactly. With a ROUNDOFF it is PolygonZBuffer.
class BandZBuffer : public ImageSpaceMethod {
 public:
  enum class Decisions { exact, rounded };
  /// Rounded ones get pixels wrong: they are there to measure what the exact ones cost.
  explicit BandZBuffer(Decisions decisions = Decisions::exact) : decisions_(decisions) {}

  void prepare(const Request& request, int threads) override;
  void draw_rows(int row_begin, int row_end, const SeenRun& seen) const override;
  int rows_at_a_time() const override { return kRowsOfABand; }

 private:
  using Fill = ViewedScene::Fill;
  static constexpr int kRowsOfABand = 16;

  void sort_into_bands();
  std::span<const Fill> of_band(std::size_t band) const {
    return std::span(in_bands_).subspan(band_begin_[band],
                                        band_begin_[band + 1] - band_begin_[band]);
  }

  Decisions decisions_;
  std::optional<Request> request_;
  RowFills fills_;
  std::vector<std::uint32_t> band_begin_;
  std::vector<Fill> in_bands_;  ///< the fills of each band, in order of entry
  PolygonZBuffer with_roundoff_;
};

}  // namespace displayfile
