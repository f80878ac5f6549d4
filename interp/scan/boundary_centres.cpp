#include "interp/scan/boundary_centres.h"

#include <algorithm>
#include <cmath>

#include "clip/geometry/corners.h"
#include "clip/geometry/rectangle.h"
#include "hidden/exact/rounding.h"

namespace displayfile {

namespace {

/// The largest displacement of a boundary, as a fraction of the largest coordinate. Rounding moves
/// a vertex by half of kUnit; the rest exceeds the rounding of the tests
/// (interp/raster/undecided_centres.md).
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

/// The x range of the side from `at`, whose y is close to a row of centres, toward `to`, as far as
/// the side is close to the row; pixel units.
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

NotedCentres::NotedCentres(const PixelSet& centres, const PictureSize& size)
    : centres_(centres), size_(size), row_start_{0} {
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

/// A fast test for most polygons, which are far from all centres: no centre in its rows, or none in
/// the bits of the bounding box.
ScanConverter::Region NotedCentres::rows_of(std::span<const Point3> polygon) const {
  const Rectangle box = bounding_box(polygon, size_, {1.0, 1.0});
  Pixels rows = centres_in({box.y_min, box.y_max}, centres_.row_begin(), centres_.row_end());
  const Pixels columns = centres_in({box.x_min, box.x_max}, 0, size_.width);
  const auto any = [&](int row) {
    const auto k = static_cast<std::size_t>(row - centres_.row_begin());
    return row_start_[k] < row_start_[k + 1] && centres_.any(row, columns.first, columns.end);
  };
  while (rows.first < rows.end && !any(rows.first)) ++rows.first;
  while (rows.first < rows.end && !any(rows.end - 1)) --rows.end;
  return {size_, rows.first, rows.end};
}

}  // namespace displayfile
