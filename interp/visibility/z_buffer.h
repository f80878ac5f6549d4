#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "interp/visibility/image_space.h"
#include "interp/visibility/row_fills.h"
#include "interp/visibility/z_buffer_band.h"

namespace displayfile {

/// The z-buffer (interp/visibility/z_buffer.md): fills are prepared once for a size and sorted into
/// bands of a few rows, whose depths and fills stay in the cache while they are drawn in vectors of
/// single precision. Only undecided cases are decided in doubles and then exactly; with a ROUNDOFF
/// in doubles as the textbook's SIGNOF does.
class ZBuffer : public ImageSpaceMethod {
 public:
  enum class Decided {
    truly,
    in_single_precision  ///< gets pixels wrong: for measuring the cost of exact decisions
  };
  explicit ZBuffer(Decided decided = Decided::truly);
  ~ZBuffer() override;

  void prepare(const Request& request, int threads) override;
  void draw_rows(int row_begin, int row_end, const SeenRun& seen) const override;
  int rows_at_a_time() const override { return kRowsOfABand; }

 private:
  using Fill = ViewedScene::Fill;
  static constexpr int kRowsOfABand = 16;

  struct Band {
    std::uint32_t begin = 0, turned_away = 0, end = 0;  ///< of its fills: those turned away last
    int first_column = 0, end_column = 0;               ///< that they cover
  };
  std::size_t bands() const {
    return static_cast<std::size_t>((request_->size.height - 1) / kRowsOfABand + 1);
  }
  template <class Visit>
  static void for_each_band(const RowFill& fill, std::span<Band> bands, Visit&& visit);
  /// With a ROUNDOFF none is: among fills equal within it the drawing order decides.
  bool is_drawn_late(const RowFill& fill) const { return fill.turned_away && !request_->roundoff; }
  void count_in_bands(const RowFills::Batch& batch);
  void sort_into_bands(int threads);
  /// The counts of a batch's fills in each band; later the place of the next of these fills.
  std::span<Band> of_batch(std::size_t number) {
    return std::span(bands_of_batches_).subspan(number * bands(), bands());
  }
  FillsOfBand of_band(const Band& band) const {
    const std::span<const Fill> all = in_bands_;
    return {all.subspan(band.begin, band.turned_away - band.begin),
            all.subspan(band.turned_away, band.end - band.turned_away)};
  }

  struct Worker;
  struct Workers;
  std::unique_ptr<Worker> take_worker() const;
  void give_back(std::unique_ptr<Worker> worker) const;

  Decided decided_;
  std::optional<Request> request_;
  RowFills fills_;
  std::vector<Band> bands_, bands_of_batches_;
  std::vector<Fill> in_bands_;  ///< the fills of each band, each half of them in order of entry
  std::unique_ptr<Workers> workers_;
};

}  // namespace displayfile
