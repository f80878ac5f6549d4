#include "interp/pair_orders.h"

#include <algorithm>
#include <array>
#include <bit>
#include <span>

#include "hidden/depth_order.h"
#include "interp/flat_extent.h"

namespace displayfile {

namespace {

using PairOrder = PairOrders::Order;

/// The difference of two planes' depths is linear: where it has one sign at some points, it has
/// that sign in all of their convex hull. At equal depth the fill entered later is seen.
template <class Points>
PairOrder order_over(const Plane& earlier, const Plane& later, const Points& points) {
  bool earlier_is_nearer = true, later_is_not_farther = true;
  for (const auto& point : points) {
    const int order = depth_order(earlier, later, Point2(point));
    earlier_is_nearer &= order > 0;
    later_is_not_farther &= order <= 0;
    if (!earlier_is_nearer && !later_is_not_farther) return PairOrder::varies;
  }
  return earlier_is_nearer ? PairOrder::first : PairOrder::second;
}

}  // namespace

PairOrder PairOrders::order_of(Fill earlier, Fill later) {
  if (pairs_.empty()) {  // few for few fills
    const int bits = std::clamp(2 * static_cast<int>(std::bit_width(scene_->end())), 4, kMostPairs);
    pairs_.resize(std::size_t{1} << bits);
    shift_ = 32 - bits;
  }
  Pair& pair = pairs_[(earlier * 0x9E3779B1u ^ later * 0x85EBCA77u) >> shift_];
  if (pair.earlier != earlier || pair.later != later) {
    pair = {earlier, later, find_order(earlier, later)};
  }
  return pair.order;
}

/// Three convex hulls hold all that both fills cover: the rectangle that their extents share, and
/// that of the vertices of either.
PairOrder PairOrders::find_order(Fill earlier, Fill later) const {
  constexpr std::size_t kFewVertices = 8;
  const auto of_earlier = scene_->vertices(earlier), of_later = scene_->vertices(later);
  const Plane plane = scene_->plane(earlier), later_plane = scene_->plane(later);
  const FlatExtent a = flat_extent(of_earlier), b = flat_extent(of_later);
  const Point2 low(std::max(a.left, b.left), std::max(a.bottom, b.bottom));
  const Point2 high(std::min(a.right, b.right), std::min(a.top, b.top));
  const std::array corners{low, high, Point2(low.x, high.y), Point2(high.x, low.y)};
  PairOrder order = order_over(plane, later_plane, corners);
  for (const auto& vertices : {of_earlier, of_later}) {
    if (order != PairOrder::varies) break;
    if (vertices.size() <= kFewVertices) order = order_over(plane, later_plane, vertices);
  }
  return order;
}

bool CloseDepths::hides(Fill a, Fill b, int column, int row) {
  if (exact_) {
    const PairOrder order = a < b ? orders_.order_of(a, b) : orders_.order_of(b, a);
    if (order != PairOrder::varies) return (order == PairOrder::first) == (a < b);
  }
  return depths_->hides(a, b, column, row);
}

bool CloseDepths::always_hides(Fill a, Fill b) {
  if (!exact_) return false;
  return a < b ? orders_.order_of(a, b) == PairOrder::first
               : orders_.order_of(b, a) == PairOrder::second;
}

}  // namespace displayfile
