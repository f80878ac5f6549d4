#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "displayfile/segments/display_file.h"
#include "displayfile/segments/viewed_scene.h"
#include "hidden/exact/plane.h"
#include "interp/scan/pixel_box.h"
#include "interp/steps/steps.h"

namespace displayfile {

/// Scene queries for algorithms that record steps: polygons by item index, coverage and depth order
/// at a pixel, decided exactly and one at a time. Slow and simple.
class StepItems {
 public:
  using Polygon = std::uint32_t;

  StepItems(const DisplayFile& file, const PictureSize& size);

  const ViewedScene& viewed() const { return scene_; }
  const PictureSize& size() const { return size_; }
  std::uint32_t polygons() const { return scene_.items(); }
  /// The polygons that cover pixels, in order of entry.
  const std::vector<Polygon>& fills() const { return fills_; }
  /// The polygon must cover pixels.
  const Plane& plane(Polygon polygon) const { return planes_[polygon]; }
  std::vector<Point3> vertices(Polygon polygon) const;

  /// The runs of pixels that it covers, row by row from the bottom; within a box, if one is given.
  std::vector<StepRun> coverage(Polygon polygon) const;
  std::vector<StepRun> coverage(Polygon polygon, const PixelBox& within) const;
  /// The sign of a's depth less b's at the centre of a pixel: 1 if a is nearer.
  int depth_order(Polygon a, Polygon b, int column, int row) const;
  /// True if a hides b: it is nearer, or equally near and entered later.
  bool hides(Polygon a, Polygon b, int column, int row) const {
    const int order = depth_order(a, b, column, row);
    return order != 0 ? order > 0 : a > b;
  }
  /// The depth there, rounded.
  double depth(Polygon polygon, int column, int row) const;

 private:
  ViewedScene scene_;
  PictureSize size_;
  std::vector<Polygon> fills_;
  std::vector<Plane> planes_;
};

/// A, B, ..., Z, AA, ...: names of polygons, from 0.
std::string name_of_polygon(std::uint32_t polygon);

}  // namespace displayfile
