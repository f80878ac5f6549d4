#pragma once

#include <cstdint>
#include <vector>

#include "interp/visibility/image_space.h"
#include "interp/visibility/row_fills.h"

namespace displayfile {

/// The z-buffer (interp/visibility/z_buffer.md): fills are made ready once for a size and sorted
/// into bands of a few rows, whose depths and fills stay in the cache while they are drawn in
/// vectors of single precision. What that leaves undecided, and only that, is decided in doubles
/// and then exactly; with a ROUNDOFF in doubles as the textbook's SIGNOF does.
class ZBuffer : public ImageSpaceMethod {
 public:
  enum class Decided {
    truly,
    in_single_precision  ///< gets pixels wrong: it is there to measure what deciding truly costs
  };
  explicit ZBuffer(Decided decided = Decided::truly) : decided_(decided) {}

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

  Decided decided_;
  std::optional<Request> request_;
  RowFills fills_;
  std::vector<std::uint32_t> band_begin_;
  std::vector<Fill> in_bands_;  ///< the fills of each band, in order of entry
};

}  // namespace displayfile
