#pragma once

#include <memory>
#include <utility>

#include "displayfile/segments/sorted_scene.h"

namespace displayfile {

/// The instructions as if a sort had left all polygons whole and in order of entry.
inline std::shared_ptr<SortedScene> in_order_of_entry(Instructions entered) {
  auto scene = std::make_shared<ViewedScene>(std::make_shared<Instructions>(std::move(entered)),
                                             ImageTransformation{});
  OrderedScene ordered{scene, {}};
  for (ViewedScene::Item item = 0; item < scene->items(); ++item) {
    ordered.pieces.pieces.push_back(
        {item, SortedPiece::kWhole, scene->primitives().items[item].sides});
  }
  auto sorted = std::make_shared<SortedScene>();
  sorted->parts.push_back(std::make_shared<OrderedScene>(std::move(ordered)));
  return sorted;
}

}  // namespace displayfile
