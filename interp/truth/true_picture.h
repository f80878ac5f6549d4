#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "clip/point.h"
#include "interp/device/picture.h"
#include "interp/truth/depth_ties.h"
#include "interp/truth/whole_numbers.h"

namespace displayfile {

/// A point of the picture in integers: x / w and y / w are in pixels, y up, and z / w is its depth.
struct TruePoint {
  Integer x, y, z, w;
};

/// The three vertices whose plane is a polygon's depth, by the definition, computed in doubles as
/// specified there, from device coordinates; none if the polygon is edge-on.
std::optional<std::array<std::size_t, 3>> support_of(std::span<const Point3> device);

/// A plane's depth at the pixel centres: (origin + row up + column right) / divisor, integers, with
/// a positive divisor.
class ExactDepth {
 public:
  /// The plane through three points, whose w may have any sign.
  ExactDepth(const TruePoint& p, const TruePoint& q, const TruePoint& r);

  /// True if the three points are collinear in the projection: there is no plane.
  bool edge_on() const { return divisor_ == 0; }
  const Integer& divisor() const { return divisor_; }
  const Integer& right() const { return right_; }
  void numerator(int column, int row, Integer& to) const {
    to = origin_;
    add_product(to, right_, static_cast<unsigned>(column));
    add_product(to, up_, static_cast<unsigned>(row));
  }

 private:
  Integer origin_, right_, up_, divisor_;
};

/// The pixels that a polygon covers: for each row, the columns that begin after an odd number of
/// its edges.
class CentreMarks {
 public:
  CentreMarks(int width, int height);

  /// Calls run(row, first, end) for each run of covered pixels first <= i < end.
  template <class Run>
  void for_each_run(std::span<const TruePoint> polygon, Run&& run) {
    mark(polygon);
    for (int row = first_row_; row < end_row_; ++row) read_row(row, run);
  }

 private:
  struct Columns {
    int first, last;  // of those marked; last may be the width
  };
  static constexpr Columns kNoColumns{std::numeric_limits<int>::max(), -1};

  void mark(std::span<const TruePoint> polygon);
  void mark_edge(const TruePoint& low, const TruePoint& high, int first, int end);
  int row_above(const TruePoint& vertex);
  std::uint8_t* changes(int row) {
    return changes_.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(width_);
  }
  template <class Run>
  void read_row(int row, Run&& run);

  int width_, height_;
  std::vector<std::uint8_t> changes_;  // 1 where a column begins after an odd number of edges
  std::vector<Columns> reached_;       // by row
  int first_row_ = 0, end_row_ = 0;
  std::vector<int> row_above_;  // of the vertices
  Integer numerator_, denominator_, step_;
  Division division_;
};

/// The polygon visible at each pixel centre, for polygons entered in order.
class TruePicture {
 public:
  /// `ties`, which outlives the picture, collects the ties if it is not null.
  TruePicture(int width, int height, DepthTies* ties = nullptr);

  /// A point given in device coordinates.
  TruePoint point(const Point3& device) const;

  /// The polygon's w are positive. Its depth is that of the plane through the support's three
  /// points; where these are in line in the projection it covers nothing.
  using Support = std::array<const TruePoint*, 3>;
  void enter(std::span<const TruePoint> polygon, const Support& support, std::int32_t pick);
  /// Moves the picture out.
  Picture take(bool depth);

  /// Coverage, identifier, depth and owner.
  static constexpr std::size_t kBytesOfPixel = 17;

 private:
  /// A polygon that is, or was, visible somewhere: its index in `seen_`.
  using Owner = std::uint32_t;
  static constexpr Owner kNone = std::numeric_limits<Owner>::max();

  struct Entered {
    ExactDepth depth;
    std::int32_t pick;
    Owner owner = kNone;  // until visible
  };

  std::size_t pixels() const {
    return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  }
  void enter_run(Entered& polygon, int row, int first, int end);
  std::strong_ordering compared(const ExactDepth& depth, Owner owner, int column, int row);

  int width_, height_;
  CentreMarks coverage_;
  std::vector<std::int32_t> ids_;
  std::vector<double> depth_;  // rounded to the nearest double
  std::vector<Owner> owner_;
  std::vector<ExactDepth> seen_;
  DepthTies* ties_;

  Integer numerator_, other_numerator_, left_, right_;
  Division division_;
};

template <class Run>
void CentreMarks::read_row(int row, Run&& run) {
  const auto [first, last] = std::exchange(reached_[static_cast<std::size_t>(row)], kNoColumns);
  if (first > last) return;
  std::uint8_t* change = changes(row);
  std::uint8_t* limit = change + std::min(last + 1, width_);
  const auto next_change = [&](std::uint8_t* from) {
    std::uint8_t* found = std::find(from, limit, std::uint8_t{1});
    if (found != limit) *found = 0;
    return found;
  };
  for (std::uint8_t* at = change + first;;) {
    std::uint8_t* begin = next_change(at);
    if (begin == limit) return;
    std::uint8_t* end = next_change(begin + 1);
    run(row, static_cast<int>(begin - change), static_cast<int>(end - change));
    if (end == limit) return;
    at = end + 1;
  }
}

}  // namespace displayfile
