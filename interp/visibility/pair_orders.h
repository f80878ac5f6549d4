#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "displayfile/segments/viewed_scene.h"
#include "hidden/exact/depth_comparison.h"
#include "interp/visibility/coplanar_fills.h"
#include "interp/visibility/depths_as_entered.h"
#include "interp/visibility/pair_table.h"

namespace displayfile {

/// Decides which of two fills is visible where their rounded depths are too close, with a memory of
/// pairs: where one hides the other everywhere, as for coplanar and parallel ones and those on one
/// side of the other's plane, exact arithmetic is used once, not per centre; where it varies, the
/// exact results for the pair are kept. Polygons outside of a scene have no numbers: ClosePlanes
/// compares them. For one thread.
class PairOrders {
 public:
  using Fill = ViewedScene::Fill;

  explicit PairOrders(const ViewedScene& scene) : scene_(&scene), as_entered_(scene) {}

  /// Takes another scene, and forgets all pairs; memory stays.
  void take(const ViewedScene& scene) {
    scene_ = &scene;
    pairs_.forget();
    comparisons_.clear();
    coplanar_.forget();
    as_entered_.take(scene);
  }

  /// Which of two fills is visible wherever both cover a centre: the `first`, entered first, or the
  /// `second`; `varies` if it varies, or is unknown without exact arithmetic.
  enum class Order : std::uint8_t { varies, first, second };
  Order order_of(Fill earlier, Fill later);
  /// Does what order_of does, but does not look for the order of a pair that is met for the first
  /// time.
  Order order_if_often(Fill earlier, Fill later);

  /// True if the later fill is visible at a centre that both cover.
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
    Order order = Order::varies;
    bool looked_for = false;           ///< the order
    bool share_plane = false;          ///< as they were entered,
    bool are_apart = false;            ///< or do not
    bool is_compared = false;          ///< their planes as entered are known,
    bool is_not_known = false;         ///< or never will be;
    std::uint32_t as_entered = kNone;  ///< this knows them: a place in comparisons_
    bool is_ready = false;             ///< more is known than the filter tells,
    std::uint8_t times_asked = 0;      ///< before it was
    std::uint32_t comparison = kNone;  ///< and this knows it: a place in comparisons_

    Pair forgotten() const { return {.as_entered = as_entered, .comparison = comparison}; }
  };
  /// Repetitions of a pair after which its order is searched for, and after which exact arithmetic
  /// is used for that.
  static constexpr int kOften = 2, kVeryOften = 8;

  bool are_in_one_plane(Pair& pair, Fill earlier, Fill later);
  bool share_plane_as_entered(Pair& pair, Fill earlier, Fill later);
  std::optional<int> order_as_entered(Pair& pair, Fill earlier, Fill later,
                                      const PixelCentre& centre);
  DepthComparison comparison_of(Fill earlier, Fill later);
  Order find_order(Pair& pair, Fill earlier, Fill later, const DepthComparison& comparison);
  Order order_of_extents(Fill earlier, Fill later, const DepthComparison& comparison) const;
  void keep(Pair& pair, Fill earlier, Fill later, const DepthComparison& comparison);

  const ViewedScene* scene_;
  PairTable<Pair> pairs_;
  std::vector<DepthComparison> comparisons_;
  CoplanarFills coplanar_;
  DepthsAsEntered as_entered_;
  std::size_t times_learnt_ = 0;
};

}  // namespace displayfile
