#pragma once

#include <optional>
#include <vector>

#include "displayfile/segments/viewed_scene.h"
#include "hidden/exact/pixel_centre.h"
#include "hidden/exact/plane.h"
#include "interp/scan/pixel_depth.h"

namespace displayfile {

/// A fill's depth over the pixels of a picture.
struct FillDepth {
  PixelDepth depth;
  /// Bounds the error of depth at the centres that the fill may cover; infinity if unknown. With a
  /// ROUNDOFF a quarter of it: depths are distinguished by twice the sum of two.
  double error = 0.0;

  FillDepth() = default;
  FillDepth(const ViewedScene& scene, ViewedScene::Fill fill, const PictureSize& size,
            std::optional<double> roundoff);

  static double error_of_roundoff(double roundoff) { return roundoff / 4.0; }
};

/// Bounds the distance, over the polygon, of a fill's depth from its depth as entered, and for a
/// shared plane from that of a plane common to all its fills. With a radius
/// (ViewedScene::viewing_radius, touching_radius) its support vertices are off by that in each
/// coordinate, and a point of the polygon is a combination of them with small weights.
double rounding_error(const ViewedScene& scene, ViewedScene::Fill fill, const PixelDepth& depth,
                      const PictureSize& size);

/// The sum of the magnitudes of the weights with which a point in the projection is a combination
/// of the plane's three points.
double sum_of_weights(const Plane& plane, const Point2& at);

/// The order of two fills by their rounded depths, given a's less b's and the sum of their errors:
/// 1 if a is nearer, -1 if b is, 0 if they are too close.
inline int rounded_order(double nearer, double errors) {
  return nearer > 2.0 * errors ? 1 : nearer < -2.0 * errors ? -1 : 0;
}

/// The depths of a scene's fills over the pixels of a picture, in doubles, each with its error
/// bound; with a ROUNDOFF, below which depths count as equal, a part of that in place of the bound.
class FillDepths {
 public:
  using Fill = ViewedScene::Fill;

  FillDepths() = default;
  FillDepths(const ViewedScene& scene, const PictureSize& size, std::optional<double> roundoff);

  const PixelDepth& depth(Fill fill) const { return of_fill_[fill].depth; }
  double error(Fill fill) const { return of_fill_[fill].error; }  ///< as in FillDepth
  double at(Fill fill, int column, int row) const {
    const PixelDepth& d = of_fill_[fill].depth;
    return d.at(d.row(row), column);
  }

  const std::optional<double>& roundoff() const { return roundoff_; }
  bool are_exact() const { return !roundoff_; }

 private:
  std::optional<double> roundoff_;
  std::vector<FillDepth> of_fill_;
};

/// Bounds, for a polygon (device coordinates) and the depth of its plane, of the error of the depth
/// at the centres that the polygon may cover, and of the size of intermediate values.
struct DepthBound {
  double error;    ///< infinity if it is not known
  double largest;  ///< of the depths, in size
};
DepthBound depth_bound(std::span<const Point3> vertices, const Plane& plane,
                       const PixelDepth& depth, const PictureSize& size);

}  // namespace displayfile
