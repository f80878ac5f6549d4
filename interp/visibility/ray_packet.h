#pragma once

#include <algorithm>
#include <array>

#include "interp/visibility/pair_orders.h"
#include "interp/visibility/ray_square.h"

namespace displayfile {

/// A square of rays along z, from the viewer's side, that see what is nearest exactly.
class RayPacket : public RaySquare {
 public:
  RayPacket(const ViewedScene& scene, const FillDepths& depths, const PictureSize& size)
      : depths_(depths), close_(scene, depths, size) {}

  /// Starts anew with rays through these centres, of kSide columns and rows at most.
  void begin(const PixelBox& rays);

  /// True if a fill no nearer than this is seen by none of the rays.
  bool hides_all_beyond(float nearest) const { return nearest < farthest_; }

  /// The fill whose spans follow.
  void begin_fill(Fill fill) {
    fill_ = fill;
    depth_ = depths_.depth(fill);
    largest_error_ = std::max(largest_error_, depths_.error(fill));
    margin_ = 2.0 * (depths_.error(fill) + largest_error_);
  }
  /// The fill is hit by the rays first <= column < end of a row, all of this packet.
  void hit(int row, int first, int end);
  void end_fill() {
    if (changed_) find_farthest();
  }

 private:
  bool hides_closely(Fill other, int column, int row) {
    return other == ViewedScene::kBackground || close_.hides(fill_, other, column, row);
  }
  void find_farthest();

  const FillDepths& depths_;
  CloseDepths close_;
  std::array<double, kRays> z_;
  double largest_error_ = 0.0;  // of the depths in z_
  double farthest_ = 0.0;       // no ray sees anything beyond
  bool changed_ = false;

  Fill fill_ = ViewedScene::kBackground;
  PixelDepth depth_;
  double margin_ = 0.0;
};

inline void RayPacket::hit(int row, int first, int end) {
  const PixelDepth depth = depth_;  // the loop's own: its stores cannot change them
  const double row_depth = depth.row(row), margin = margin_;
  double* z_of = z_.data() + index(row, first);
  Fill* seen = seen_.data() + index(row, first);
  for (int column = first; column < end; ++column, ++z_of, ++seen) {
    const double z = depth.at(row_depth, column);
    const double nearer = z - *z_of;
    if (nearer < -margin) continue;
    if (!(nearer > margin) && !hides_closely(*seen, column, row)) continue;
    *z_of = z;
    *seen = fill_;
    changed_ = true;
  }
}

}  // namespace displayfile
