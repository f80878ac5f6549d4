#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "displayfile/segments/viewed_scene.h"

namespace displayfile {

/// The order in which a picture draws the items of a scene: in layers, one over the other, each
/// either by depth or in order of entry. Without layers all items are drawn by depth.
class DrawnLayers {
 public:
  using Item = ViewedScene::Item;

  /// The items from `first` on, up to those of the next layer.
  struct Layer {
    Item first;
    bool by_depth;  ///< or else in order of entry

    bool operator==(const Layer&) const = default;
  };
  /// Where a fill hides a line.
  enum class Hides { nowhere, where_nearer, where_it_covers };

  DrawnLayers() = default;
  /// Layers from the bottom up. With `shows_fills` false fills are not drawn, and hide lines of
  /// their own layer alone.
  DrawnLayers(std::vector<Layer> layers, bool shows_fills)
      : layers_(std::move(layers)), shows_fills_(shows_fills) {}

  Hides hides(Item fill, Item line) const {
    if (layers_.empty()) return Hides::where_nearer;
    const auto of_fill = layer_of(fill), of_line = layer_of(line);
    if (of_fill == of_line && of_fill->by_depth) return Hides::where_nearer;
    if (of_fill != of_line && !shows_fills_) return Hides::nowhere;
    return fill > line ? Hides::where_it_covers : Hides::nowhere;
  }

  /// True if a line is drawn over another, whatever their depths.
  bool is_over(Item line, Item other) const {
    if (layers_.empty() || line <= other) return false;
    const auto of_line = layer_of(line);
    return of_line != layer_of(other) || !of_line->by_depth;
  }

  bool operator==(const DrawnLayers&) const = default;

 private:
  std::vector<Layer>::const_iterator layer_of(Item item) const {
    return std::ranges::upper_bound(layers_, item, {}, &Layer::first) - 1;
  }

  std::vector<Layer> layers_;  // the first has item 0
  bool shows_fills_ = true;
};

}  // namespace displayfile
