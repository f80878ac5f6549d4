#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "displayfile/scene_viewer.h"
#include "interp/raster/caster_lists.h"
#include "interp/raster/way_to_world.h"
#include "interp/raster/world_casters.h"

namespace displayfile {

/// What is kept of the shadows of a retained scene from view to view, and how one view's items are
/// found by it (interp/raster/shadows.md): the tree of casters for all views, and, while the lights
/// stay where they are in the world, what can hide the light of each polygon that was seen.
class RetainedCasters {
 public:
  using Item = ViewedScene::Item;

  /// The scene must live on and stay as it is.
  RetainedCasters(const RetainedScene& scene, int threads);

  /// Takes up what the viewer made of the scene last, which was what is wanted. False if shadows
  /// in that view are not those of the world, or not to within the rounding that is allowed for:
  /// where images are transformed, or the view is extreme.
  bool take(const SceneViewer& viewer, const SceneViewer::Wanted& wanted, const ViewedScene& seen);

  /// Where to look for what hides the light from points of an item.
  struct Search {
    Point3 toward;  ///< the light
    /// All that comes into question; without it, the tree is asked.
    std::optional<std::span<const CasterLists::Primitive>> few;
    bool is_never_hidden() const { return few && few->empty(); }
  };
  /// Its depths are off by no more than that.
  Search search_on(Item item, double depth_error);
  /// Calls hides(item) for the items of the view that may lie between the light and a point, until
  /// it returns true: then true. Device coordinates.
  template <class Hides>
  bool any(const Search& search, const Point3& point, Hides&& hides) const {
    const auto is_hidden_by = [&](WorldCasters::Primitive primitive) {
      const Item item = item_of_[primitive];
      return item != kNotSeen && hides(item);
    };
    if (!search.few) return casters_.any((*way_)(point), search.toward, is_hidden_by);
    for (const auto primitive : *search.few) {
      if (is_hidden_by(primitive)) return true;
    }
    return false;
  }

  std::size_t lists_made() const { return lists_.made(); }
  std::size_t bytes() const;

 private:
  static constexpr Item kNotSeen = std::numeric_limits<Item>::max();
  void take_lights(const glm::dmat3& turned);

  const RetainedScene* scene_;
  WorldCasters casters_;
  CasterLists lists_;
  std::vector<Point3> toward_;  // the lights of the attributes, as they are turned now
  bool lights_stayed_ = false;
  std::optional<WayToWorld> way_;
  std::vector<Item> item_of_;  // of primitives
  std::span<const std::uint32_t> primitive_of_;
};

}  // namespace displayfile
