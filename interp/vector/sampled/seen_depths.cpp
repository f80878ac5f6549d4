#include "interp/vector/sampled/seen_depths.h"

#include "interp/visibility/fill_depths.h"

namespace displayfile {

void SeenDepths::begin_polygon(std::span<const Point3> vertices, const Plane& plane) {
  depth_ = PixelDepth(plane, size_.width, size_.height);
  current_ = static_cast<Owner>(polygons_.size());
  const double error = depth_bound(vertices, plane, depth_, size_).error;
  largest_error_ = std::max(largest_error_, error);
  margin_ = 2.0 * (error + largest_error_);
  polygons_.push_back({plane, error});
  close_.begin(plane);
}

void SeenDepths::draw_span(int row, int first, int end, Cell* cells) {
  constexpr double kLargest = std::numeric_limits<double>::max();  // infinity is the background
  const double row_depth = depth_.row(row);
  run_.end = first;
  for (int i = first; i < end; ++i) {
    const double z = depth_.at(row_depth, i);
    const double nearer = z - cells[i].z;
    if (nearer < -margin_) continue;
    if (!(nearer > margin_) && !nearer_or_equal(nearer, {row, i, end}, cells)) continue;
    cells[i] = {std::clamp(z, -kLargest, kLargest), current_};
  }
}

/// What the rounded depths do not tell.
bool SeenDepths::nearer_or_equal(double nearer, const Rest& rest, const Cell* cells) {
  if (rest.column < run_.end) return run_.later_is_seen(rest.column);
  const Cell& cell = cells[rest.column];
  if (cell.is_background()) return true;
  const Polygon& other = polygons_[cell.owner];
  const int order = rounded_order(nearer, polygons_[current_].error + other.error);
  if (order != 0) return order > 0;
  if (!close_.is_compared_with(cell.owner)) close_.compare_with(cell.owner, other.plane);
  int end = rest.column + 1;
  while (end < rest.end && cells[end].owner == cell.owner && !cells[end].is_background()) ++end;
  run_ = close_.run(rest.row, rest.column, end);
  return run_.later_is_seen(rest.column);
}

}  // namespace displayfile
