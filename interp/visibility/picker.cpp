#include "interp/visibility/picker.h"

#include <fmt/format.h>

#include <cmath>

#include "clip/base/error.h"
#include "interp/device/picture.h"
#include "interp/scan/shown_depth.h"

namespace displayfile {

Picker::Picker(std::shared_ptr<const ViewedScene> scene, const PictureSize& size, int threads)
    : scene_(std::move(scene)), size_(size), threads_(threads) {
  fills_.prepare({*scene_, size_, std::nullopt}, threads_);
  decided_.find(*scene_, size_, threads_);
}

std::optional<Pick> Picker::pick(double x, double y, double reach) {
  if (!std::isfinite(x) || !std::isfinite(y)) throw Error("a point to pick at is not finite");
  if (!(reach >= 0.0 && reach <= kLargestSide)) {
    throw Error(
        fmt::format("reach {} to pick lines: expected 0 to {} pixels", reach, kLargestSide));
  }
  if (!(x >= 0.0 && x < size_.width && y >= 0.0 && y < size_.height)) return std::nullopt;
  const int column = static_cast<int>(x), row = size_.height - 1 - static_cast<int>(y);
  const auto decided = decided_.at(row, column);
  const ViewedScene::Fill fill = decided ? *decided : fills_.seen_at(column, row);
  if (reach > 0.0 && scene_->has_lines()) {
    if (!lines_) lines_.emplace(*scene_, size_, threads_);
    if (const auto line = lines_->nearest({column + 0.5, row + 0.5}, reach, fill)) {
      return Pick{line->is_edge ? Pick::Kind::edge : Pick::Kind::line,
                  scene_->pick_of_item(line->item), scene_->segment_name(line->item), line->depth,
                  std::nullopt};
    }
  }
  if (fill == ViewedScene::kBackground) return std::nullopt;
  return Pick{Pick::Kind::polygon, scene_->pick(fill), scene_->segment_name(scene_->item_of(fill)),
              ShownDepth(scene_->plane(fill), size_).at(column, row), std::nullopt};
}

}  // namespace displayfile
