#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "hidden/exact/depth_comparison.h"
#include "interp/visibility/fill_depths.h"

namespace displayfile {

/// Which of two fills is seen where their rounded depths are too close to tell, remembered pair by
/// pair: where one is seen all over what both can cover, as with coplanar and with parallel ones
/// and with those that lie on one side of the other's plane, exact arithmetic is asked once and not
/// for each centre; where it varies, what exact arithmetic found out of the pair is kept. For one
/// thread.
class PairOrders {
 public:
  using Fill = ViewedScene::Fill;

  explicit PairOrders(const ViewedScene& scene) : scene_(&scene) {}

  /// Of two fills, the first of them entered first, wherever both cover a centre: `first` and
  /// `second` are what is seen; it varies, or that is not found out without exact arithmetic.
  enum class Order : std::uint8_t { varies, first, second };
  Order order_of(Fill earlier, Fill later);
  /// The same, but of a pair that is met for the first time it is not looked for.
  Order order_if_often(Fill earlier, Fill later);

  /// The same at a centre that both cover.
  bool later_is_seen(Fill earlier, Fill later, const PixelCentre& centre);

  /// What exact arithmetic has found out of the two.
  struct Known {
    Order order = Order::varies;
    std::optional<DepthComparison::Linear> earlier_less_later = std::nullopt;  ///< of their depths
  };
  Known known(Fill earlier, Fill later);
  /// Grows whenever exact arithmetic finds out more of some pair.
  std::size_t times_learnt() const { return times_learnt_; }

 private:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};
  struct Pair {
    Fill earlier = ViewedScene::kBackground, later = ViewedScene::kBackground;
    Order order = Order::varies;
    bool looked_for = false;           ///< the order
    bool is_ready = false;             ///< more is known than the filter tells,
    std::uint8_t times_asked = 0;      ///< before it was
    std::uint32_t comparison = kNone;  ///< and this knows it: a place in comparisons_
  };
  static constexpr int kFewestPairs = 5, kMostPairs = 12;  ///< places for them, as powers of two
  /// A pair that is asked for again: its order is looked for, and then exact arithmetic asked.
  static constexpr int kOften = 2, kVeryOften = 8;
  static constexpr std::size_t kProbed = 4;  ///< a pair's place is among so many from its hash on

  Pair& pair(Fill earlier, Fill later);
  std::size_t first_place_of(Fill earlier, Fill later) const;
  Pair* place_of(Fill earlier, Fill later);
  void make_places(int power);
  DepthComparison comparison_of(Fill earlier, Fill later) const;
  bool are_in_one_plane(Fill earlier, Fill later);
  Fill one_of_plane(Fill fill);
  void keep(const DepthComparison& comparison, Pair& pair);
  void find_order(Pair& pair, const DepthComparison& comparison);
  Order order_of_extents(const Pair& pair, const DepthComparison& comparison) const;

  const ViewedScene* scene_;
  std::vector<Pair> pairs_;  // by a hash of the two; more places are made as they fill
  int power_ = 0;
  std::vector<DepthComparison> comparisons_;
  std::vector<Fill> same_plane_;  // another fill of its plane, or itself; empty: none is known
  std::size_t times_learnt_ = 0;
};

/// Which of a scene's fills is seen at a centre. Exact: by rounded depths, and where these are too
/// close by exact arithmetic, pairs being remembered (interp/visibility/close_depths.md). With a
/// ROUNDOFF closer depths count as equal. Of equally near fills the one entered later is seen in
/// both. For one thread.
class CloseDepths {
 public:
  using Fill = ViewedScene::Fill;

  CloseDepths(const ViewedScene& scene, const FillDepths& depths, const PictureSize& size)
      : depths_(&depths), size_(size), orders_(scene) {}

  /// True if a is seen rather than b, of two fills that cover the centre, neither of them the
  /// background.
  bool hides(Fill a, Fill b, int column, int row) {
    const int order = rounded_order(depths_->at(a, column, row) - depths_->at(b, column, row),
                                    depths_->error(a) + depths_->error(b));
    return order != 0 ? order > 0 : hides_closely(a, b, column, row);
  }

  /// The same where the rounded depths are known to be too close.
  bool hides_closely(Fill a, Fill b, int column, int row);

  /// True only if a is seen rather than b wherever both cover a centre.
  bool always_hides(Fill a, Fill b);

 private:
  const FillDepths* depths_;
  PictureSize size_;
  PairOrders orders_;
};

}  // namespace displayfile
