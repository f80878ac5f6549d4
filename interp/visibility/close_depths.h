#pragma once

#include "interp/visibility/fill_depths.h"
#include "interp/visibility/pair_orders.h"

namespace displayfile {

/// Decides which of a scene's fills is visible at a centre. Exact: by rounded depths, and where
/// these are too close by exact arithmetic with remembered pairs
/// (interp/visibility/close_depths.md). With a ROUNDOFF closer depths are equal. In both, the later
/// entered of equally near fills is visible. For one thread.
class CloseDepths {
 public:
  using Fill = ViewedScene::Fill;

  CloseDepths(const ViewedScene& scene, const FillDepths& depths, const PictureSize& size)
      : depths_(&depths), size_(size), orders_(scene) {}

  /// True if a hides b, of two fills that cover the centre, neither of them the background.
  bool hides(Fill a, Fill b, int column, int row) {
    const int order = rounded_order(depths_->at(a, column, row) - depths_->at(b, column, row),
                                    depths_->error(a) + depths_->error(b));
    return order != 0 ? order > 0 : hides_closely(a, b, column, row);
  }

  /// True if a hides b, where the rounded depths are known to be too close.
  bool hides_closely(Fill a, Fill b, int column, int row);

  /// True only if a hides b wherever both cover a centre.
  bool always_hides(Fill a, Fill b);

 private:
  const FillDepths* depths_;
  PictureSize size_;
  PairOrders orders_;
};

}  // namespace displayfile
