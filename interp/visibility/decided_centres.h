#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "interp/scan/scan_convert.h"
#include "interp/visibility/image_space.h"

namespace displayfile {

/// The pixel centres of a picture where viewing's rounding may decide visibility, and the fill
/// visible there for the scene as entered (interp/visibility/fills_as_entered.md).
class DecidedCentres {
 public:
  struct Decided {
    std::int32_t row, column;
    ViewedScene::Fill fill;
  };

  /// Finds the centres of a scene, which need not outlive the call, replacing earlier ones. On up
  /// to `threads` threads.
  void find(const ViewedScene& scene, const PictureSize& size, int threads);
  void forget() { all_.clear(); }
  bool empty() const { return all_.empty(); }

  /// The centres of a row in the columns first <= i < end, left to right.
  std::span<const Decided> in_row(int row, int first, int end) const;
  std::optional<ViewedScene::Fill> at(int row, int column) const {
    const auto here = in_row(row, column, column + 1);
    return here.empty() ? std::nullopt : std::optional(here.front().fill);
  }

 private:
  /// A thread's working memory, kept between pictures.
  struct Band {
    ScanConverter converter;
    std::vector<Decided> decided;
  };
  std::vector<Decided> all_;  // row by row, left to right
  std::vector<Band> bands_;
};

/// An image-space method that is correct for the scene as entered: it finds visibility by the
/// scene's coordinates, and overrides the decided centres.
class MethodAsEntered : public ImageSpaceMethod {
 public:
  explicit MethodAsEntered(std::unique_ptr<ImageSpaceMethod> method) : method_(std::move(method)) {}

  void prepare(const Request& request, int threads) override;
  void draw_rows(int row_begin, int row_end, const SeenRun& seen) const override;
  int rows_at_a_time() const override { return method_->rows_at_a_time(); }

 private:
  std::unique_ptr<ImageSpaceMethod> method_;
  DecidedCentres decided_;
};

}  // namespace displayfile
