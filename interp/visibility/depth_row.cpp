#include "interp/visibility/depth_row.h"

#include <algorithm>
#include <limits>

namespace displayfile {

namespace {

constexpr double kFarthest = -std::numeric_limits<double>::infinity();

}  // namespace

DepthRow::DepthRow(const ViewedScene& scene, const PictureSize& size,
                   std::optional<double> roundoff)
    : size_(size),
      exact_(!roundoff),
      depth_(static_cast<std::size_t>(size.width)),
      owner_(depth_.size()),
      orders_(scene) {}

void DepthRow::begin(int row) {
  row_ = row;
  std::ranges::fill(depth_, kFarthest);
  std::ranges::fill(owner_, kBackground);
  drawn_.assign(1, {ViewedScene::kBackground, 0.0});
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

/// Decides where the rounded depths, with the largest error of the row's fills, do not.
bool DepthRow::hides_closely(double nearer, const Rest& rest) {
  if (rest.column < run_.end) return run_.later_is_seen(rest.column);
  const Owner owner = owner_[static_cast<std::size_t>(rest.column)];
  if (owner == kBackground) return true;
  const Drawn& other = drawn_[owner];
  const int order = rounded_order(nearer, current_.error + other.error);
  if (order != 0) return order > 0;
  if (!exact_) return true;  // equal, and later
  run_ = decided_run(rest);
  return run_.later_is_seen(rest.column);
}

/// Decides by exact arithmetic: at once for all common pixels of the two fills, or else for a run
/// of pixels.
DecidedRun DepthRow::decided_run(const Rest& rest) {
  const Owner owner = owner_[static_cast<std::size_t>(rest.column)];
  const Fill fill = drawn_.back().fill, other = drawn_[owner].fill;
  return run_of(rest.column, end_of_run(rest), [&](int column) {
    return orders_.later_is_seen(other, fill, PixelCentre(column, row_, size_));
  });
}

/// The end of the run of pixels from there on that show the same fill.
int DepthRow::end_of_run(const Rest& rest) const {
  const Owner* const owners = owner_.data();
  int end = rest.column + 1;
  while (end < rest.end && owners[end] == owners[rest.column]) ++end;
  return end;
}

}  // namespace displayfile
