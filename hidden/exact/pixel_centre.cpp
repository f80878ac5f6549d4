#include "hidden/exact/pixel_centre.h"

#include <algorithm>
#include <cassert>

#include "hidden/exact/ball.h"
#include "hidden/exact/exact_number.h"
#include "hidden/exact/predicate_counts.h"

namespace displayfile {

namespace {

/// 2 (coordinate * pixels - (index + 1/2)).
ExactNumber twice_from_centre(double coordinate, std::int32_t pixels, std::int32_t index) {
  return ExactNumber(coordinate) * ExactNumber(2 * std::int64_t{pixels}) -
         ExactNumber(2 * std::int64_t{index} + 1);
}

/// An enclosure of the crossing's x in pixels, minus the half pixel by which centres are offset.
Ball crossing_in_columns(const Point2& a, const Point2& b, std::int32_t row,
                         const PictureSize& size) {
  const double centre = (2.0 * row + 1.0) / (2.0 * size.height);
  const Ball height = {centre, kUnit * std::abs(centre) * kInflate};
  const Ball up = height - Ball{a.y, 0.0};
  const Ball x = Ball{a.x, 0.0} + up * ball_of_difference(b.x, a.x) / ball_of_difference(b.y, a.y);
  return x * Ball{static_cast<double>(size.width), 0.0} - Ball{0.5, 0.0};
}

}  // namespace

int exact_compare_with_centres(double coordinate, std::int32_t pixels, std::int32_t index) {
  count_exact(Predicate::row);
  return twice_from_centre(coordinate, pixels, index).sign();
}

int exact_crossing(const Point2& a, const Point2& b, const PixelCentre& centre) {
  count_exact(Predicate::crossing);
  const ExactNumber run = ExactNumber(b.x) - ExactNumber(a.x);
  const ExactNumber rise = ExactNumber(b.y) - ExactNumber(a.y);
  const ExactNumber left = twice_from_centre(a.x, centre.size.width, centre.column) * rise *
                           ExactNumber(std::int64_t{centre.size.height});
  const ExactNumber right = twice_from_centre(a.y, centre.size.height, centre.row) * run *
                            ExactNumber(std::int64_t{centre.size.width});
  return (left - right).sign() * rise.sign();
}

std::int32_t first_column_after_crossing(const Point2& a, const Point2& b, std::int32_t row,
                                         const PictureSize& size) {
  const Ball estimate = crossing_in_columns(a, b, row, size);
  const double margin = (estimate.radius + kUnit * std::abs(estimate.middle)) * kInflate + kTiny;
  double low = std::ceil(estimate.middle - margin);
  double high = std::ceil(estimate.middle + margin);
  const double width = size.width;
  if (!(low <= high)) low = 0.0, high = width;  // the filter is undecided
  auto first = static_cast<std::int32_t>(std::clamp(low, 0.0, width));
  auto last = static_cast<std::int32_t>(std::clamp(high, 0.0, width));
  // The answer is in [first, last]; from it on, the crossing is not right of the centre.
  assert(0 <= first && first <= last && last <= size.width);
  while (first < last) {
    const std::int32_t middle = first + (last - first) / 2;
    if (crossing(a, b, PixelCentre(middle, row, size)) <= 0) {
      last = middle;
    } else {
      first = middle + 1;
    }
  }
  return first;
}

}  // namespace displayfile
