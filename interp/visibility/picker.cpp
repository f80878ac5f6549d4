#include "interp/visibility/picker.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "interp/device/picture.h"
#include "interp/scan/scan_convert.h"
#include "interp/scan/shown_depth.h"

namespace displayfile {

Picker::Picker(std::shared_ptr<const ViewedScene> scene, const PictureSize& size, int threads)
    : scene_(std::move(scene)), size_(size), threads_(threads) {
  fills_.prepare({*scene_, size_, std::nullopt}, threads_);
  decided_.find(*scene_, size_, threads_);
}

std::optional<Picker::Pixel> Picker::pixel_at(double x, double y, double reach) const {
  if (!std::isfinite(x) || !std::isfinite(y)) throw Error("a point to pick at is not finite");
  if (!(reach >= 0.0 && reach <= kLargestSide)) {
    throw Error(
        fmt::format("reach {} to pick lines: expected 0 to {} pixels", reach, kLargestSide));
  }
  if (!(x >= 0.0 && x < size_.width && y >= 0.0 && y < size_.height)) return std::nullopt;
  return Pixel{static_cast<int>(x), size_.height - 1 - static_cast<int>(y)};
}

std::optional<Pick> Picker::line_at(const Pixel& at, double reach, const DrawnLayers& layers,
                                    Fill fill) {
  if (!(reach > 0.0) || !scene_->has_lines()) return std::nullopt;
  if (!lines_ || !(lines_->layers() == layers)) lines_.emplace(*scene_, size_, threads_, layers);
  const auto line = lines_->nearest({at.column + 0.5, at.row + 0.5}, reach, fill);
  if (!line) return std::nullopt;
  return Pick{line->is_edge ? Pick::Kind::edge : Pick::Kind::line, scene_->pick_of_item(line->item),
              scene_->segment_name(line->item), line->depth, std::nullopt};
}

std::optional<Pick> Picker::pick(const Pixel& at, double reach, const DrawnLayers& layers) {
  const auto decided = decided_.at(at.row, at.column);
  const Fill fill = decided ? *decided : fills_.seen_at(at.column, at.row);
  if (const auto line = line_at(at, reach, layers, fill)) return line;
  if (fill == ViewedScene::kBackground) return std::nullopt;
  return Pick{Pick::Kind::polygon, scene_->pick(fill), scene_->segment_name(scene_->item_of(fill)),
              ShownDepth(scene_->plane(fill), size_).at(at.column, at.row), std::nullopt};
}

/// The fill that the picture shows: an item buffer does not state its segment. Of the fills with
/// the identifier one that covers the centre, and of these the one whose depth is closest.
ViewedScene::Fill Picker::drawn_fill(const Pixel& at, const DrawnPixel& drawn) const {
  ScanConverter converter;
  Fill best = ViewedScene::kBackground;
  std::pair<bool, double> least{true, 0.0};  // does not cover; how far its depth is off
  for (Fill fill = ViewedScene::kBackground + 1; fill < scene_->end(); ++fill) {
    if (scene_->pick(fill) != drawn.id) continue;
    const PointRow row = scene_->vertices(fill);
    const std::vector<Point3> vertices(row.begin(), row.end());
    bool covers = false;
    converter.scan_convert(vertices, {size_, at.row, at.row + 1}, [&](int, int first, int end) {
      covers = covers || (first <= at.column && at.column < end);
    });
    const double depth = ShownDepth(scene_->plane(fill), size_).at(at.column, at.row);
    const std::pair off{!covers, std::abs(depth - drawn.depth)};
    if (best != ViewedScene::kBackground && off > least) continue;
    best = fill;
    least = off;
  }
  return best;
}

std::optional<Pick> Picker::pick(const Pixel& at, double reach, const DrawnLayers& layers,
                                 const DrawnPixel& drawn) {
  const Fill fill = drawn.id < 0 ? ViewedScene::kBackground : drawn_fill(at, drawn);
  if (const auto line = line_at(at, reach, layers, fill)) return line;
  if (fill == ViewedScene::kBackground) return std::nullopt;
  return Pick{Pick::Kind::polygon, drawn.id, scene_->segment_name(scene_->item_of(fill)),
              drawn.depth, std::nullopt};
}

}  // namespace displayfile
