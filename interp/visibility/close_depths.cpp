#include "interp/visibility/close_depths.h"

namespace displayfile {

bool CloseDepths::hides_closely(Fill a, Fill b, int column, int row) {
  if (!depths_->are_exact()) return a > b;
  const PixelCentre centre(column, row, size_);
  return a < b ? !orders_.later_is_seen(a, b, centre) : orders_.later_is_seen(b, a, centre);
}

bool CloseDepths::always_hides(Fill a, Fill b) {
  if (!depths_->are_exact()) return false;
  return a < b ? orders_.order_of(a, b) == PairOrders::Order::first
               : orders_.order_of(b, a) == PairOrders::Order::second;
}

}  // namespace displayfile
