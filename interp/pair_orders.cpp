#include "interp/pair_orders.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <span>

#include "interp/flat_extent.h"

namespace displayfile {

namespace {

using PairOrder = PairOrders::Order;

/// The difference of two planes' depths is linear: where it has one sign at some points, it has
/// that sign in all of their convex hull. At equal depth the fill entered later is seen.
template <class Points>
PairOrder order_over(const DepthComparison& comparison, const Points& points) {
  bool earlier_is_nearer = true, later_is_not_farther = true;
  for (const auto& point : points) {
    const std::optional<int> order = comparison.order_at_hand(Point2(point));
    if (!order) return PairOrder::varies;
    earlier_is_nearer &= *order > 0;
    later_is_not_farther &= *order <= 0;
    if (!earlier_is_nearer && !later_is_not_farther) return PairOrder::varies;
  }
  return earlier_is_nearer ? PairOrder::first : PairOrder::second;
}

}  // namespace

PairOrders::Pair& PairOrders::pair(Fill earlier, Fill later) {
  if (pairs_.empty()) {  // few for few fills
    const int bits = std::clamp(2 * static_cast<int>(std::bit_width(scene_->end())), 4, kMostPairs);
    pairs_.resize(std::size_t{1} << bits);
    shift_ = 32 - bits;
  }
  Pair& pair = pairs_[(earlier * 0x9E3779B1u ^ later * 0x85EBCA77u) >> shift_];
  if (pair.earlier != earlier || pair.later != later) {
    pair = {earlier, later, Order::varies, false, false, pair.comparison};
  }
  return pair;
}

PairOrder PairOrders::order_of(Fill earlier, Fill later) {
  Pair& asked = pair(earlier, later);
  if (!asked.looked_for) find_order(asked, comparison_of(earlier, later));
  return asked.order;
}

DepthComparison PairOrders::comparison_of(Fill earlier, Fill later) const {
  return {scene_->plane(earlier), scene_->plane(later)};
}

/// Three convex hulls hold all that both fills cover: the rectangle that their extents share, and
/// that of the vertices of either.
void PairOrders::find_order(Pair& pair, const DepthComparison& comparison) const {
  constexpr std::size_t kFewVertices = 8;
  pair.looked_for = true;
  const auto of_earlier = scene_->vertices(pair.earlier), of_later = scene_->vertices(pair.later);
  const FlatExtent a = flat_extent(of_earlier), b = flat_extent(of_later);
  const Point2 low(std::max(a.left, b.left), std::max(a.bottom, b.bottom));
  const Point2 high(std::min(a.right, b.right), std::min(a.top, b.top));
  const std::array corners{low, high, Point2(low.x, high.y), Point2(high.x, low.y)};
  pair.order = order_over(comparison, corners);
  for (const auto& vertices : {of_earlier, of_later}) {
    if (pair.order != Order::varies) return;
    if (vertices.size() <= kFewVertices) pair.order = order_over(comparison, vertices);
  }
}

bool PairOrders::later_is_seen(Fill earlier, Fill later, const PixelCentre& centre) {
  Pair& asked = pair(earlier, later);
  if (asked.order != Order::varies) return asked.order == Order::second;
  if (asked.is_exact) return comparisons_[asked.comparison].order(centre) <= 0;
  DepthComparison comparison = comparison_of(earlier, later);
  const bool seen = comparison.order(centre) <= 0;
  if (comparison.is_exact()) keep(comparison, asked);
  return seen;
}

/// The order is looked for again, with what is known now.
void PairOrders::keep(const DepthComparison& comparison, Pair& pair) {
  find_order(pair, comparison);
  if (pair.order != Order::varies) return;
  pair.is_exact = true;
  if (pair.comparison == kNone) {
    pair.comparison = static_cast<std::uint32_t>(comparisons_.size());
    comparisons_.emplace_back();
  }
  comparisons_[pair.comparison] = comparison;
}

bool CloseDepths::hides_closely(Fill a, Fill b, int column, int row) {
  if (!depths_->are_exact()) return a > b;
  const PixelCentre centre(column, row, size_);
  return a < b ? !orders_.later_is_seen(a, b, centre) : orders_.later_is_seen(b, a, centre);
}

bool CloseDepths::always_hides(Fill a, Fill b) {
  if (!depths_->are_exact()) return false;
  return a < b ? orders_.order_of(a, b) == PairOrder::first
               : orders_.order_of(b, a) == PairOrder::second;
}

}  // namespace displayfile
