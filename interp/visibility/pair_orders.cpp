#include "interp/visibility/pair_orders.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "interp/scan/flat_extent.h"

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

std::size_t PairOrders::first_place_of(Fill earlier, Fill later) const {
  return (earlier * 0x9E3779B1u ^ later * 0x85EBCA77u) >> (32 - power_);
}

/// Its own place or an empty one; null if all that it may have are taken.
PairOrders::Pair* PairOrders::place_of(Fill earlier, Fill later) {
  const std::size_t first = first_place_of(earlier, later);
  for (std::size_t k = 0; k < kProbed; ++k) {
    Pair& place = pairs_[(first + k) & (pairs_.size() - 1)];
    if (place.later == later && place.earlier == earlier) return &place;
    if (place.later == ViewedScene::kBackground) return &place;
  }
  return nullptr;
}

/// A pair whose places are all taken there is forgotten.
void PairOrders::make_places(int power) {
  const std::vector<Pair> before = std::move(pairs_);
  power_ = power;
  pairs_ = std::vector<Pair>(std::size_t{1} << power);
  for (const Pair& known : before) {
    if (known.later == ViewedScene::kBackground) continue;
    if (Pair* const place = place_of(known.earlier, known.later)) *place = known;
  }
}

PairOrders::Pair& PairOrders::pair(Fill earlier, Fill later) {
  if (pairs_.empty()) make_places(kFewestPairs);
  Pair* place = place_of(earlier, later);
  while (place == nullptr && power_ < kMostPairs) {
    make_places(power_ + 1);
    place = place_of(earlier, later);
  }
  if (place == nullptr) {  // another makes way, and leaves its comparison
    place = &pairs_[first_place_of(earlier, later)];
    *place = {.comparison = place->comparison};
  }
  place->earlier = earlier;
  place->later = later;
  return *place;
}

PairOrder PairOrders::order_of(Fill earlier, Fill later) {
  Pair& asked = pair(earlier, later);
  if (!asked.looked_for) find_order(asked, comparison_of(earlier, later));
  return asked.order;
}

PairOrder PairOrders::order_if_often(Fill earlier, Fill later) {
  Pair& asked = pair(earlier, later);
  if (!asked.looked_for && ++asked.times_asked >= kOften) {
    find_order(asked, comparison_of(earlier, later));
  }
  return asked.order;
}

DepthComparison PairOrders::comparison_of(Fill earlier, Fill later) const {
  return {scene_->plane(earlier), scene_->plane(later)};
}

void PairOrders::find_order(Pair& pair, const DepthComparison& comparison) {
  pair.looked_for = true;
  pair.order = are_in_one_plane(pair.earlier, pair.later) ? Order::second
                                                          : order_of_extents(pair, comparison);
  times_learnt_ += pair.order != Order::varies;
}

/// Three convex hulls hold all that both fills cover: the rectangle that their extents share, and
/// that of the vertices of either.
PairOrder PairOrders::order_of_extents(const Pair& pair, const DepthComparison& comparison) const {
  constexpr std::size_t kFewVertices = 8;
  const auto of_earlier = scene_->vertices(pair.earlier), of_later = scene_->vertices(pair.later);
  const FlatExtent a = flat_extent(of_earlier), b = flat_extent(of_later);
  const Point2 low(std::max(a.left, b.left), std::max(a.bottom, b.bottom));
  const Point2 high(std::min(a.right, b.right), std::min(a.top, b.top));
  const std::array corners{low, high, Point2(low.x, high.y), Point2(high.x, low.y)};
  Order order = order_over(comparison, corners);
  for (const auto& vertices : {of_earlier, of_later}) {
    if (order != Order::varies || vertices.size() > kFewVertices) continue;
    order = order_over(comparison, vertices);
  }
  return order;
}

bool PairOrders::later_is_seen(Fill earlier, Fill later, const PixelCentre& centre) {
  Pair& asked = pair(earlier, later);
  if (asked.order != Order::varies) return asked.order == Order::second;
  if (asked.is_ready) return comparisons_[asked.comparison].order(centre) <= 0;
  DepthComparison comparison = comparison_of(earlier, later);
  const bool is_often = ++asked.times_asked == kOften && !asked.looked_for;
  if (is_often || are_in_one_plane(earlier, later)) {
    find_order(asked, comparison);
    if (asked.order != Order::varies) return asked.order == Order::second;
  }
  if (asked.times_asked == kVeryOften) comparison.make_ready();
  const bool seen = comparison.order(centre) <= 0;
  if (comparison.is_ready()) keep(comparison, asked);
  return seen;
}

PairOrders::Known PairOrders::known(Fill earlier, Fill later) {
  if (times_learnt_ == 0) return {};
  const Pair& asked = pair(earlier, later);
  if (!asked.is_ready) return {.order = asked.order};
  return {.earlier_less_later = comparisons_[asked.comparison].rounded()};
}

/// Of n fills that lie in one plane n - 1 pairs need be compared to know it of all.
bool PairOrders::are_in_one_plane(Fill earlier, Fill later) {
  return !same_plane_.empty() && one_of_plane(earlier) == one_of_plane(later);
}

/// The same for all fills that are known to lie in one plane.
PairOrders::Fill PairOrders::one_of_plane(Fill fill) {
  while (same_plane_[fill] != fill) {
    same_plane_[fill] = same_plane_[same_plane_[fill]];
    fill = same_plane_[fill];
  }
  return fill;
}

/// The order is looked for again, with what is known now.
void PairOrders::keep(const DepthComparison& comparison, Pair& pair) {
  if (comparison.is_one_plane()) {
    if (same_plane_.empty()) {
      same_plane_.resize(scene_->end());
      std::iota(same_plane_.begin(), same_plane_.end(), Fill{0});
    }
    same_plane_[one_of_plane(pair.later)] = one_of_plane(pair.earlier);
  }
  find_order(pair, comparison);
  ++times_learnt_;
  if (pair.order != Order::varies) return;
  pair.is_ready = true;
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
