#include "interp/pair_orders.h"

#include <algorithm>
#include <utility>

#include "hidden/depth_order.h"
#include "interp/flat_extent.h"

namespace displayfile {

bool PairOrders::hides(Fill a, Fill b, int column, int row) {
  if (exact_) {
    const Order order = order_of(a, b);
    if (order != Order::varies) return order == Order::first;
  }
  return depths_->hides(a, b, column, row);
}

PairOrders::Order PairOrders::order_of(Fill a, Fill b) {
  if (a > b) {
    const Order swapped = order_of(b, a);
    if (swapped == Order::varies) return swapped;
    return swapped == Order::first ? Order::second : Order::first;
  }
  if (pairs_.empty()) pairs_.resize(kPairs);
  Pair& pair = pairs_[(a * 0x9E3779B1u ^ b * 0x85EBCA77u) >> 20];
  if (pair.smaller != a || pair.larger != b) pair = {a, b, find_order(a, b)};
  return pair.order;
}

/// The difference of two planes' depths is linear: where it has one sign at a rectangle's corners,
/// it has that sign in all of it. At equal depth the fill entered later is seen, which is b.
PairOrders::Order PairOrders::find_order(Fill a, Fill b) const {
  const FlatExtent of_a = flat_extent(scene_->vertices(a)), of_b = flat_extent(scene_->vertices(b));
  const Point2 low(std::max(of_a.left, of_b.left), std::max(of_a.bottom, of_b.bottom));
  const Point2 high(std::min(of_a.right, of_b.right), std::min(of_a.top, of_b.top));
  const Plane plane_a = scene_->plane(a), plane_b = scene_->plane(b);
  bool a_nearer = true, b_not_farther = true;
  for (const Point2& corner : {low, high, Point2(low.x, high.y), Point2(high.x, low.y)}) {
    const int order = depth_order(plane_a, plane_b, corner);
    a_nearer &= order > 0;
    b_not_farther &= order <= 0;
    if (!a_nearer && !b_not_farther) return Order::varies;
  }
  return a_nearer ? Order::first : Order::second;
}

}  // namespace displayfile
