#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "interp/scan/pixel_box.h"
#include "interp/visibility/close_depths.h"

namespace displayfile {

/// Neighbouring rays along z, from the viewer's side, cast together through the centres of a square
/// of pixels or a part of one, and the visible fill of each.
///
/// Exact: the nearest fill, the later of equally near ones. With a ROUNDOFF: the one entered last
/// of those within ROUNDOFF of the nearest. "Closer than ROUNDOFF" is not an order, so the result
/// of a single cast would depend on the order of the hits: rays are cast again when the nearest
/// depths are known. A ROUNDOFF of 0 is an order, and one cast suffices.
class RayPacket {
 public:
  using Fill = ViewedScene::Fill;
  static constexpr int kSide = 8;

  RayPacket(const ViewedScene& scene, const FillDepths& depths, const PictureSize& size)
      : depths_(depths), close_(scene, depths, size) {}

  /// Restarts with rays through these centres, at most kSide columns and rows.
  void begin(const PixelBox& rays);

  /// After a cast: true if the rays are to be cast once more.
  bool begin_next_cast();

  const PixelBox& rays() const { return rays_; }

  /// True if no ray sees a fill at this depth or farther.
  bool hides_all_beyond(float nearest) const { return nearest < farthest_; }

  /// Begins a fill, whose spans follow.
  void begin_fill(Fill fill) {
    fill_ = fill;
    depth_ = depths_.depth(fill);
    const double error = error_of(fill);
    largest_error_ = std::max(largest_error_, error);
    margin_ = 2.0 * (error + largest_error_);
  }
  /// Records that the fill is hit by the rays first <= column < end of a row, all of this packet.
  void hit(int row, int first, int end);
  void end_fill() {
    if (changed_) find_farthest();
  }

  /// The visible fills of the rays of a row, after the last cast.
  std::span<const Fill> seen(int row) const {
    return std::span(seen_).subspan(
        index(row, rays_.first_column),
        static_cast<std::size_t>(rays_.end_column - rays_.first_column));
  }

 private:
  static constexpr std::size_t kRays = std::size_t{kSide} * kSide;
  enum class Cast {
    for_fills,   ///< the only one, or the second
    for_depths,  ///< the first of two
  };

  std::size_t index(int row, int column) const {
    return static_cast<std::size_t>((row - rays_.first_row) * kSide + column - rays_.first_column);
  }
  /// The error used to distinguish depths: 0 while only the nearest is searched.
  double error_of(Fill fill) const { return cast_ == Cast::for_fills ? depths_.error(fill) : 0.0; }
  bool hides_closely(Fill other, int column, int row) {
    return other == ViewedScene::kBackground || close_.hides(fill_, other, column, row);
  }
  bool is_cast_once() const { return depths_.are_exact() || *depths_.roundoff() == 0.0; }
  void find_farthest();

  const FillDepths& depths_;
  CloseDepths close_;
  PixelBox rays_{};
  Cast cast_ = Cast::for_fills;
  std::array<Fill, kRays> seen_;
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
  const bool ordered = is_cast_once();
  double* z_of = z_.data() + index(row, first);
  Fill* seen = seen_.data() + index(row, first);
  for (int column = first; column < end; ++column, ++z_of, ++seen) {
    const double z = depth.at(row_depth, column);
    const double nearer = z - *z_of;
    if (nearer < -margin) continue;
    if (!(nearer > margin) && !hides_closely(*seen, column, row)) continue;
    if (ordered || nearer > 0.0) *z_of = z;  // with a ROUNDOFF the nearest stays
    *seen = fill_;
    changed_ = true;
  }
}

}  // namespace displayfile
