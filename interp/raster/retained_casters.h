#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "displayfile/views/scene_viewer.h"
#include "interp/raster/caster_lists.h"
#include "interp/raster/way_to_world.h"
#include "interp/raster/world_casters.h"

namespace displayfile {

/// Shadow data of a retained scene cached between views, and how one view's items find it
/// (interp/raster/shadows.md): the tree of casters for all views, and, while the lights are fixed
/// in the world, the possible casters on each polygon seen so far.
class RetainedCasters {
 public:
  using Item = ViewedScene::Item;

  /// The scene must outlive it unchanged.
  RetainedCasters(const RetainedScene& scene, int threads);

  /// Prepares for the viewer's last view, which was `wanted`. False if shadows in that view are not
  /// those of the world within the allowed rounding: where images are transformed, or the view is
  /// extreme.
  bool take(const SceneViewer& viewer, const SceneViewer::Wanted& wanted, const ViewedScene& seen);

  /// Where to search for casters on points of an item.
  struct Search {
    Point3 toward{0.0};  ///< the light
    /// All candidates; without it, the tree is searched.
    std::optional<std::span<const CasterLists::Primitive>> few = std::nullopt;
    std::uint32_t open = 0;  ///< those of them, a bit each, that are not ruled out
    bool is_never_hidden() const { return few && open == 0; }
  };
  /// The search for an item whose depths are off by at most the given error. `few` gets the items
  /// of the view that hides_none(item) does not rule out.
  template <class HidesNone>
  Search search_on(Item item, double depth_error, HidesNone&& hides_none) {
    Search search = begin_search(item, depth_error);
    if (!search.few) return search;
    for (std::size_t k = 0; k < search.few->size(); ++k) {
      const Item caster = item_of_[(*search.few)[k]];
      if (caster != kNotSeen && !hides_none(caster)) search.open |= 1u << k;
    }
    return search;
  }
  /// Calls hides(item) for the items of the view that may lie between the light and a point, until
  /// it returns true; then returns true. Device coordinates.
  template <class Hides>
  bool any(const Search& search, const Point3& point, Hides&& hides) const {
    const auto is_hidden_by = [&](WorldCasters::Primitive primitive) {
      const Item item = item_of_[primitive];
      return item != kNotSeen && hides(item);
    };
    if (!search.few) return casters_.any((*way_)(point), search.toward, is_hidden_by);
    for (std::uint32_t open = search.open; open != 0; open &= open - 1) {
      const auto k = static_cast<std::size_t>(std::countr_zero(open));
      if (hides(item_of_[(*search.few)[k]])) return true;
    }
    return false;
  }

  std::size_t lists_made() const { return lists_.made(); }
  std::size_t bytes() const;

 private:
  static constexpr Item kNotSeen = std::numeric_limits<Item>::max();
  static_assert(CasterLists::kLongest <= 32);  // bits
  void take_lights(const glm::dmat3& turned);
  Search begin_search(Item item, double depth_error);

  const RetainedScene* scene_;
  WorldCasters casters_;
  CasterLists lists_;
  std::vector<Point3> toward_;  // the lights of the attributes, as they are turned now
  std::optional<WayToWorld> way_;
  std::vector<Item> item_of_;  // of primitives
  std::span<const std::uint32_t> primitive_of_;
};

}  // namespace displayfile
