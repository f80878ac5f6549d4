#pragma once

#include <optional>
#include <vector>

#include "interp/visibility/fill_depths.h"
#include "interp/visibility/image_space.h"
#include "interp/visibility/sample_area.h"

namespace displayfile {

/// Warnock's area subdivision with early finishing: areas that are small, or have few polygons, are
/// not subdivided (interp/visibility/warnock.md). The books' algorithm is PlainWarnock
/// (interp/visibility/plain_warnock.h). Memory: 4 bytes a pixel, 64 a fill.
class Warnock : public ImageSpaceMethod {
 public:
  using Fill = ViewedScene::Fill;

  void prepare(const Request& request, int threads) override;
  void draw_rows(int row_begin, int row_end, const SeenRun& seen) const override;
  /// Each call examines every polygon.
  int rows_at_a_time() const override { return 128; }

 private:
  class Subdivision;

  std::optional<Request> request_;
  FillDepths depths_;
  std::vector<SampleArea> extents_;  // of each fill
};

}  // namespace displayfile
