#include "interp/visibility/pair_orders.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "clip/geometry/rectangle.h"

namespace displayfile {

namespace {

using PairOrder = PairOrders::Order;

/// The difference of two planes' depths is linear: a sign that it has at some points holds in their
/// convex hull. At equal depth the fill entered later is visible.
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

PairOrder PairOrders::order_of(Fill earlier, Fill later) {
  Pair& asked = pairs_(earlier, later);
  if (asked.looked_for) return asked.order;
  return find_order(asked, earlier, later, comparison_of(earlier, later));
}

PairOrder PairOrders::order_if_often(Fill earlier, Fill later) {
  Pair& asked = pairs_(earlier, later);
  if (asked.looked_for || ++asked.times_asked < kOften) return asked.order;
  return find_order(asked, earlier, later, comparison_of(earlier, later));
}

/// Coplanar as entered, or by exact arithmetic.
bool PairOrders::are_in_one_plane(Pair& pair, Fill earlier, Fill later) {
  return coplanar_.are(earlier, later) || share_plane_as_entered(pair, earlier, later);
}

bool PairOrders::share_plane_as_entered(Pair& pair, Fill earlier, Fill later) {
  if (pair.are_apart || pair.share_plane) return pair.share_plane;
  pair.share_plane = scene_->are_in_one_plane(earlier, later);
  pair.are_apart = !pair.share_plane;
  if (pair.share_plane) {
    pair.looked_for = true;
    pair.order = Order::second;
    ++times_learnt_;
  }
  return pair.share_plane;
}

/// The order as entered, where viewing may decide, whatever is known of the pair in the scene's
/// coordinates.
std::optional<int> PairOrders::order_as_entered(Pair& pair, Fill earlier, Fill later,
                                                const PixelCentre& centre) {
  if (scene_->viewing_radius() == 0.0 || pair.is_not_known) return std::nullopt;
  if (share_plane_as_entered(pair, earlier, later)) return 0;
  if (!pair.is_compared) {
    if (!as_entered_.are_close(earlier, later, centre)) return std::nullopt;
    const auto comparison = as_entered_.comparison(earlier, later);
    pair.is_not_known = !comparison;
    if (!comparison) return std::nullopt;
    pair.is_compared = true;
    if (pair.as_entered == kNone) {
      pair.as_entered = static_cast<std::uint32_t>(comparisons_.size());
      comparisons_.emplace_back();
    }
    comparisons_[pair.as_entered] = *comparison;
    if (comparison->is_one_plane()) {
      pair.looked_for = true;
      pair.order = Order::second;
      ++times_learnt_;
    }
  }
  return comparisons_[pair.as_entered].order(centre);
}

/// Compares the fills' own planes if these are close to those as entered, otherwise those as
/// entered.
DepthComparison PairOrders::comparison_of(Fill earlier, Fill later) {
  const auto is_off = [this](Fill fill) { return scene_->is_off_its_plane(scene_->item_of(fill)); };
  if (scene_->touching_radius() == 0.0 && (is_off(earlier) || is_off(later))) {
    if (const auto as_entered = as_entered_.comparison(earlier, later)) return *as_entered;
  }
  return {scene_->plane(earlier), scene_->plane(later)};
}

PairOrder PairOrders::find_order(Pair& pair, Fill earlier, Fill later,
                                 const DepthComparison& comparison) {
  pair.looked_for = true;
  pair.order = are_in_one_plane(pair, earlier, later)
                   ? Order::second
                   : order_of_extents(earlier, later, comparison);
  times_learnt_ += pair.order != Order::varies;
  return pair.order;
}

/// The common area of two fills lies in three convex hulls: the intersection of their extents, and
/// the hulls of either's vertices.
PairOrder PairOrders::order_of_extents(Fill earlier, Fill later,
                                       const DepthComparison& comparison) const {
  constexpr std::size_t kFewVertices = 8;
  const PointRow of_earlier = scene_->vertices(earlier), of_later = scene_->vertices(later);
  const Rectangle a = bounding_rectangle(of_earlier), b = bounding_rectangle(of_later);
  const Point2 low(std::max(a.x_min, b.x_min), std::max(a.y_min, b.y_min));
  const Point2 high(std::min(a.x_max, b.x_max), std::min(a.y_max, b.y_max));
  const std::array corners{low, high, Point2(low.x, high.y), Point2(high.x, low.y)};
  Order order = order_over(comparison, corners);
  for (const PointRow* vertices : {&of_earlier, &of_later}) {
    if (order != Order::varies || vertices->size() > kFewVertices) continue;
    order = order_over(comparison, *vertices);
  }
  return order;
}

bool PairOrders::later_is_seen(Fill earlier, Fill later, const PixelCentre& centre) {
  Pair& asked = pairs_(earlier, later);
  if (const auto order = order_as_entered(asked, earlier, later, centre)) return *order <= 0;
  if (asked.order != Order::varies) return asked.order == Order::second;
  if (asked.is_ready) return comparisons_[asked.comparison].order(centre) <= 0;
  DepthComparison comparison = comparison_of(earlier, later);
  const bool is_often = ++asked.times_asked == kOften && !asked.looked_for;
  if (is_often || are_in_one_plane(asked, earlier, later)) {
    const Order order = find_order(asked, earlier, later, comparison);
    if (order != Order::varies) return order == Order::second;
  }
  if (asked.times_asked == kVeryOften) comparison.make_ready();
  const bool seen = comparison.order(centre) <= 0;
  if (comparison.is_ready()) keep(asked, earlier, later, comparison);
  return seen;
}

PairOrders::Known PairOrders::known(Fill earlier, Fill later) {
  if (times_learnt_ == 0) return {};
  const Pair& asked = pairs_(earlier, later);
  if (!asked.is_ready) return {.order = asked.order};
  return {.earlier_less_later = comparisons_[asked.comparison].rounded()};
}

/// Stores the comparison, and searches for the order again with it.
void PairOrders::keep(Pair& pair, Fill earlier, Fill later, const DepthComparison& comparison) {
  if (comparison.is_one_plane()) coplanar_.add(earlier, later, scene_->end());
  const Order order = find_order(pair, earlier, later, comparison);
  ++times_learnt_;
  if (order != Order::varies) return;
  pair.is_ready = true;
  if (pair.comparison == kNone) {
    pair.comparison = static_cast<std::uint32_t>(comparisons_.size());
    comparisons_.emplace_back();
  }
  comparisons_[pair.comparison] = comparison;
}

}  // namespace displayfile
