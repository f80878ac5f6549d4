#include "interp/raster/undecided_centres.h"

#include <algorithm>
#include <cmath>

#include "clip/corners.h"
#include "clip/rectangle.h"
#include "hidden/exact/rounding.h"

namespace displayfile {

namespace {

/// How far a boundary may be off, as a part of the largest coordinate. Rounding moves a vertex by
/// half of kUnit; the rest is more than the tests lose (interp/raster/undecided_centres.md).
constexpr double kBoundaryError = 64.0 * kUnit;

/// An error up to which a vertex is close to one row of centres at most.
constexpr double kSmallError = 0.25;

struct Interval {
  double low, high;
};

/// The pixels whose centres lie in the interval (pixel units), as first and end.
struct Pixels {
  int first, end;
};
Pixels centres_in(const Interval& interval, int begin, int end) {
  const auto within = [&](double index) {
    return static_cast<int>(std::clamp<double>(index, begin, end));
  };
  return {within(std::ceil(interval.low - 0.5)), within(std::floor(interval.high - 0.5) + 1.0)};
}

/// The polygon's bounding box with a margin, in pixel units.
Rectangle bounding_box(std::span<const Point3> polygon, const PictureSize& size,
                       const Point2& margin) {
  const Rectangle e = bounding_rectangle(polygon);
  return {e.x_min * size.width - margin.x, e.x_max * size.width + margin.x,
          e.y_min * size.height - margin.y, e.y_max * size.height + margin.y};
}

void note_bounding_box(std::span<const Point3> polygon, const Point2& error,
                       const PictureSize& size, PixelSet& noted) {
  const Rectangle box = bounding_box(polygon, size, error);
  const Pixels rows = centres_in({box.y_min, box.y_max}, noted.row_begin(), noted.row_end());
  const Pixels columns = centres_in({box.x_min, box.x_max}, 0, size.width);
  for (int row = rows.first; row < rows.end; ++row) noted.add(row, columns.first, columns.end);
}

/// The x of the side from `at`, whose y is close to a row of centres, to `to`, as far as the side
/// is close to the row; pixel units.
Interval close_part(const Point2& at, const Point2& to, const Point2& error) {
  const double rise = std::abs(to.y - at.y), run = to.x - at.x;
  const double part = rise > 4.0 * error.y ? 4.0 * error.y / rise : 1.0;
  const double end = at.x + part * run;
  return {std::min(at.x, end) - error.x, std::max(at.x, end) + error.x};
}

}  // namespace

Point2 boundary_error(std::span<const Point3> polygon, const PictureSize& size) {
  double x = 0.0, y = 0.0;
  for (const Point3& v : polygon) {
    x = std::max(x, std::abs(v.x));
    y = std::max(y, std::abs(v.y));
  }
  return {kBoundaryError * x * size.width, kBoundaryError * y * size.height};
}

void note_rows_of_vertices(std::span<const Point3> polygon, const Point2& error,
                           const PictureSize& size, PixelSet& noted) {
  if (!(error.x <= kSmallError && error.y <= kSmallError)) [[unlikely]]
    return note_bounding_box(polygon, error, size, noted);
  const auto pixel = [&](std::size_t i) {
    return Point2(polygon[i].x * size.width, polygon[i].y * size.height);
  };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const double y = polygon[i].y * size.height;
    if (!(y >= noted.row_begin() && y < noted.row_end())) continue;
    const int row = static_cast<int>(y);
    if (std::abs(y - row - 0.5) > error.y) [[likely]]
      continue;
    const std::size_t before = previous_corner(i, polygon.size());
    const std::size_t after = next_corner(i, polygon.size());
    for (const std::size_t other : {before, after}) {
      const Pixels columns = centres_in(close_part(pixel(i), pixel(other), error), 0, size.width);
      noted.add(row, columns.first, columns.end);
    }
  }
}

NearestAtCentres::NearestAtCentres(const PixelSet& centres, const PictureSize& size,
                                   const Shadows* shadows)
    : centres_(centres), size_(size), shadows_(shadows), row_start_{0}, close_(size) {
  const std::size_t count = centres.size();
  column_.reserve(count);
  owner_.assign(count, kNone);
  const auto rows_before = [&] { return static_cast<int>(row_start_.size()) - 1; };
  centres.for_each([&](int row, int column) {
    while (rows_before() < row - centres.row_begin()) row_start_.push_back(column_.size());
    column_.push_back(column);
  });
  while (rows_before() < centres.row_end() - centres.row_begin()) {
    row_start_.push_back(column_.size());
  }
}

void NearestAtCentres::begin_layer(Layer layer) {
  layer_ = layer;
  ++layers_;
}

/// Most polygons are far from all centres: a look at the bits of their bounding box tells.
ScanConverter::Region NearestAtCentres::rows_with_centres(std::span<const Point3> polygon) const {
  const Rectangle box = bounding_box(polygon, size_, {1.0, 1.0});
  Pixels rows = centres_in({box.y_min, box.y_max}, centres_.row_begin(), centres_.row_end());
  const Pixels columns = centres_in({box.x_min, box.x_max}, 0, size_.width);
  const auto any = [&](int row) { return centres_.any(row, columns.first, columns.end); };
  while (rows.first < rows.end && !any(rows.first)) ++rows.first;
  while (rows.first < rows.end && !any(rows.end - 1)) --rows.end;
  return {size_, rows.first, rows.end};
}

void NearestAtCentres::enter(const DrawnPolygon& drawn, const Plane& plane) {
  const std::span<const Point3> polygon = drawn.vertices;
  const ScanConverter::Region region = rows_with_centres(polygon);
  if (region.row_begin >= region.row_end) return;
  const Seen seen{plane, FillColour(drawn, size_, shadows_), drawn.pick};
  Owner own = kNone;
  close_.begin(seen.plane);
  converter_.scan_convert(polygon, region, [&](int row, int first, int end) {
    enter_run({row, first, end}, seen, own);
  });
}

void NearestAtCentres::enter_run(const Run& run, const Seen& polygon, Owner& own) {
  const auto row = static_cast<std::size_t>(run.row - centres_.row_begin());
  const auto row_end = column_.begin() + static_cast<std::ptrdiff_t>(row_start_[row + 1]);
  auto at = std::lower_bound(column_.begin() + static_cast<std::ptrdiff_t>(row_start_[row]),
                             row_end, run.first);
  for (; at != row_end && *at < run.end; ++at) {
    Owner& owner = owner_[static_cast<std::size_t>(at - column_.begin())];
    if (owner != kNone && !is_seen(owner, run.row, *at)) continue;
    // The old owner's place is not free before the new one has its own: close_ stays valid.
    if (own == kNone) own = take_place(polygon);
    if (owner != kNone && --owners_[owner].centres == 0) free_.push_back(owner);
    owner = own;
    ++owners_[own].centres;
  }
}

bool NearestAtCentres::is_seen(Owner other, int row, int column) {
  if (layer_ == Layer::painted || owners_[other].layer != layers_) return true;
  if (!close_.is_compared_with(other)) close_.compare_with(other, owners_[other].seen.plane);
  return close_.later_is_seen(column, row);
}

NearestAtCentres::Owner NearestAtCentres::take_place(const Seen& polygon) {
  auto place = static_cast<Owner>(owners_.size());
  if (free_.empty()) {
    owners_.push_back({polygon, layers_, 0});
  } else {
    place = free_.back();
    free_.pop_back();
    owners_[place] = {polygon, layers_, 0};
  }
  return place;
}

}  // namespace displayfile
