#include "interp/steps/step_items.h"

#include <algorithm>

#include "displayfile/segments/display_file.h"
#include "hidden/exact/depth_order.h"
#include "interp/scan/pixel_depth.h"
#include "interp/scan/scan_convert.h"

namespace displayfile {

StepItems::StepItems(const DisplayFile& file, const PictureSize& size) : scene_(file), size_(size) {
  planes_.resize(scene_.items());
  for (ViewedScene::Fill fill = 1; fill < scene_.end(); ++fill) {
    const Polygon polygon = scene_.item_of(fill);
    fills_.push_back(polygon);
    planes_[polygon] = scene_.plane_in_common(fill);
  }
}

std::vector<Point3> StepItems::vertices(Polygon polygon) const {
  const PointRow points = scene_.points(polygon);
  return {points.begin(), points.end()};
}

std::vector<StepRun> StepItems::coverage(Polygon polygon) const {
  return coverage(polygon, {0, size_.width, 0, size_.height});
}

std::vector<StepRun> StepItems::coverage(Polygon polygon, const PixelBox& within) const {
  std::vector<StepRun> runs;
  ScanConverter converter;
  const std::vector<Point3> outline = vertices(polygon);
  converter.scan_convert(outline, {size_, within.first_row, within.end_row},
                         [&](int row, int first, int end) {
                           first = std::max(first, within.first_column);
                           end = std::min(end, within.end_column);
                           if (first < end) runs.push_back({row, first, end, polygon});
                         });
  return runs;
}

int StepItems::depth_order(Polygon a, Polygon b, int column, int row) const {
  return displayfile::depth_order(planes_[a], planes_[b], PixelCentre(column, row, size_));
}

double StepItems::depth(Polygon polygon, int column, int row) const {
  const PixelDepth depth(planes_[polygon], size_.width, size_.height);
  return depth.at(depth.row(row), column);
}

std::string name_of_polygon(std::uint32_t polygon) {
  std::string name;
  for (std::uint32_t rest = polygon + 1; rest > 0; rest = (rest - 1) / 26) {
    name.insert(name.begin(), static_cast<char>('A' + (rest - 1) % 26));
  }
  return name;
}

}  // namespace displayfile
