#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "interp/fill_depths.h"

namespace displayfile {

/// Which of two fills is seen where their rounded depths are too close to tell, remembered pair by
/// pair: where one is seen all over what both can cover, as with coplanar and with parallel ones
/// and with those that lie on one side of the other's plane, exact arithmetic is asked once and not
/// for each centre. For one thread.
class PairOrders {
 public:
  using Fill = FillScene::Fill;

  explicit PairOrders(const FillScene& scene) : scene_(&scene) {}

  /// Of two fills, the first of them entered first, wherever both cover a centre: `first` and
  /// `second` are what is seen; it varies, or that is not found out.
  enum class Order : std::uint8_t { varies, first, second };
  Order order_of(Fill earlier, Fill later);

 private:
  struct Pair {
    Fill earlier = FillScene::kBackground, later = FillScene::kBackground;
    Order order = Order::varies;
  };
  static constexpr int kMostPairs = 12;  ///< remembered at a time, as a power of two

  Order find_order(Fill earlier, Fill later) const;

  const FillScene* scene_;
  std::vector<Pair> pairs_;  // by a hash of the two
  int shift_ = 0;
};

/// FillDepths, with the pairs remembered that it finds too close. For one thread.
class CloseDepths {
 public:
  using Fill = FillScene::Fill;

  CloseDepths(const FillScene& scene, const FillDepths& depths, bool exact)
      : depths_(&depths), exact_(exact), orders_(scene) {}

  /// As FillDepths::hides.
  bool hides(Fill a, Fill b, int column, int row);

  /// True only if a is seen rather than b wherever both cover a centre.
  bool always_hides(Fill a, Fill b);

 private:
  const FillDepths* depths_;
  bool exact_;
  PairOrders orders_;
};

}  // namespace displayfile
