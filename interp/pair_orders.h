#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "interp/fill_depths.h"

namespace displayfile {

/// Which of two fills is seen where their rounded depths are too close to tell, remembered pair by
/// pair: where one is seen all over the rectangle that both extents share, as with coplanar and
/// with parallel ones, exact arithmetic is asked once and not for each centre. For one thread.
class PairOrders {
 public:
  using Fill = FillScene::Fill;

  PairOrders(const FillScene& scene, const FillDepths& depths, bool exact)
      : scene_(&scene), depths_(&depths), exact_(exact) {}

  /// As FillDepths::hides.
  bool hides(Fill a, Fill b, int column, int row);

  /// True only if a is seen rather than b wherever both cover a centre.
  bool always_hides(Fill a, Fill b) { return exact_ && order_of(a, b) == Order::first; }

 private:
  /// Of the fills (a, b); `first`: a is seen.
  enum class Order : std::uint8_t { varies, first, second };
  struct Pair {
    Fill smaller = FillScene::kBackground, larger = FillScene::kBackground;
    Order order = Order::varies;
  };
  static constexpr std::size_t kPairs = 4096;  ///< remembered at a time

  Order order_of(Fill a, Fill b);
  Order find_order(Fill a, Fill b) const;

  const FillScene* scene_;
  const FillDepths* depths_;
  bool exact_;
  std::vector<Pair> pairs_;  // by a hash of the two
};

}  // namespace displayfile
