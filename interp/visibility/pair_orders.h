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

  /// Replaces the scene and clears all pairs, keeping the memory.
  void take(const ViewedScene& scene) {
    scene_ = &scene;
    pairs_.forget();
    comparisons_.clear();
    coplanar_.forget();
    as_entered_.take(scene);
  }

  /// Which of two fills is visible wherever both cover a centre: the `first` entered, or the
  /// `second`; `varies` if it varies, or is unknown without exact arithmetic.
  enum class Order : std::uint8_t { varies, first, second };
  Order order_of(Fill earlier, Fill later);
  /// As order_of, but does not search for the order when a pair occurs for the first time.
  Order order_if_often(Fill earlier, Fill later);

  /// True if the later fill is visible at a centre that both cover.
  bool later_is_seen(Fill earlier, Fill later, const PixelCentre& centre);

  /// Results of exact arithmetic for a pair.
  struct Known {
    Order order = Order::varies;
    std::optional<DepthComparison::Linear> earlier_less_later = std::nullopt;  ///< of their depths
  };
  Known known(Fill earlier, Fill later);
  /// Increases whenever exact arithmetic yields new results for some pair.
  std::size_t times_learnt() const { return times_learnt_; }

 private:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};
  struct Pair {
    Order order = Order::varies;
    bool looked_for = false;           ///< the order was searched for
    bool share_plane = false;          ///< as entered
    bool are_apart = false;            ///< as entered: known to share no plane
    bool is_compared = false;          ///< the planes as entered were compared
    bool is_not_known = false;         ///< the planes as entered cannot be compared
    std::uint32_t as_entered = kNone;  ///< index of their comparison in comparisons_
    bool is_ready = false;             ///< an exact comparison is stored
    std::uint8_t times_asked = 0;      ///< until then
    std::uint32_t comparison = kNone;  ///< index of the exact comparison in comparisons_

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
