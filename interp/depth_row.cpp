#include "interp/depth_row.h"

#include <algorithm>
#include <limits>

#include "hidden/plane.h"

namespace displayfile {

namespace {

constexpr double kFarthest = -std::numeric_limits<double>::infinity();

/// Pairs of fills whose planes are remembered to be one plane or two.
constexpr std::size_t kPairs = 4096;
constexpr std::uint32_t kHashFactor = 2654435769u;  // 2^32 over the golden ratio

}  // namespace

DepthRow::DepthRow(const FillScene& scene, const PictureSize& size, std::optional<double> roundoff)
    : scene_(scene),
      size_(size),
      exact_(!roundoff),
      depth_(static_cast<std::size_t>(size.width)),
      owner_(depth_.size()),
      compared_(kPairs) {}

void DepthRow::begin(int row) {
  row_ = row;
  std::ranges::fill(depth_, kFarthest);
  std::ranges::fill(owner_, kBackground);
  drawn_.assign(1, {FillScene::kBackground, 0.0});
  largest_error_ = 0.0;
}

void DepthRow::begin_fill(Fill fill, const FillDepth& depth) {
  drawn_.push_back({fill, depth.error});
  largest_error_ = std::max(largest_error_, depth.error);
  current_ = depth;
}

void DepthRow::draw_span(int first, int end) {
  const PixelDepth depth = current_.depth;  // the loop's own: its stores cannot change them
  const double row_depth = depth.row(row_);
  const double margin = 2.0 * (current_.error + largest_error_);
  const auto current = static_cast<Owner>(drawn_.size() - 1);
  double* const depths = depth_.data();
  Owner* const owners = owner_.data();
  run_.end = first;
  for (int i = first; i < end; ++i) {
    const double z = depth.at(row_depth, i);
    const double nearer = z - depths[i];
    if (nearer < -margin) continue;
    if (!(nearer > margin) && !hides_closely(nearer, {i, end})) continue;
    depths[i] = z;
    owners[i] = current;
  }
}

std::span<const DepthRow::Fill> DepthRow::seen() {
  static_assert(sizeof(Owner) == sizeof(Fill));
  for (Owner& owner : owner_) owner = drawn_[owner].fill;
  return owner_;
}

/// What the rounded depths do not tell, by the largest error of the row's fills.
bool DepthRow::hides_closely(double nearer, const Rest& rest) {
  if (rest.column < run_.end) return run_.hides;
  const Owner owner = owner_[static_cast<std::size_t>(rest.column)];
  if (owner == kBackground) return true;
  const Drawn& other = drawn_[owner];
  const int order = rounded_order(nearer, current_.error + other.error);
  if (order != 0) return order > 0;
  if (!exact_) return true;  // equal, and later
  const Fill fill = drawn_.back().fill;
  if (coplanar(fill, other.fill)) {
    run_ = {end_of_run(rest), true};
  } else {
    run_ = decide_run(fill, other.fill, rest);
  }
  return run_.hides;
}

/// Along a row the difference of two planes' depths is linear: if it has one sign at both ends of a
/// run of pixels that show the same fill, it has that sign between them; if not, it changes once.
DepthRow::Run DepthRow::decide_run(Fill fill, Fill other, const Rest& rest) const {
  const auto hides = [&](int column) {
    return hides_exactly(scene_, fill, other, {column, row_, size_});
  };
  const bool first_hides = hides(rest.column);
  const int end = end_of_run(rest);
  if (end - rest.column < 5) return {rest.column + 1, first_hides};  // as soon asked one by one
  int same = rest.column;
  for (int different = end; different - same > 1;) {
    const int middle = different == end ? end - 1 : same + (different - same) / 2;
    (hides(middle) == first_hides ? same : different) = middle;
  }
  return {same + 1, first_hides};
}

/// Of the pixels from there on that show the same fill.
int DepthRow::end_of_run(const Rest& rest) const {
  const Owner* const owners = owner_.data();
  int end = rest.column + 1;
  while (end < rest.end && owners[end] == owners[rest.column]) ++end;
  return end;
}

bool DepthRow::coplanar(Fill a, Fill b) {
  Compared& compared = compared_[((a * kHashFactor) ^ b) % kPairs];
  if (compared.a != a || compared.b != b) {
    const Plane plane = scene_.plane(a), other = scene_.plane(b);
    const auto on = [&](const Point3& v) { return side_of_plane(v, other) == 0; };
    compared = {a, b, on(plane.p) && on(plane.q) && on(plane.r)};
  }
  return compared.coplanar;
}

}  // namespace displayfile
