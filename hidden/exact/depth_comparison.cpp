#include "hidden/exact/depth_comparison.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "hidden/exact/exact_point.h"
#include "hidden/exact/plane_in_picture.h"
#include "hidden/exact/predicate_counts.h"

namespace displayfile {

namespace {

constexpr std::int64_t kNoExponent = std::numeric_limits<std::int64_t>::min() / 2;

std::int64_t exponent_of(const ExactNumber& number) {
  return number.sign() == 0 ? kNoExponent : number.leading().exponent;
}

/// number / 2^exponent, which is below 1 in magnitude.
double scaled(const ExactNumber& number, std::int64_t exponent) {
  constexpr std::int64_t kVanishes = -2000;
  if (number.sign() == 0) return 0.0;
  const ExactNumber::Leading leading = number.leading();
  assert(leading.exponent <= exponent);
  return std::ldexp(leading.mantissa,
                    static_cast<int>(std::max(leading.exponent - exponent, kVanishes)));
}

/// The exponent of the lowest nonzero binary digit: number / 2^result is an integer. The number
/// must be exactly its leading digits.
std::int64_t lowest_digit(const ExactNumber::Leading& number) {
  const auto digits = static_cast<std::int64_t>(std::ldexp(number.mantissa, 53));
  return number.exponent - 53 + std::countr_zero(static_cast<std::uint64_t>(digits));
}

int side_of_line(const Point2& from, const Point2& to, const Point2& at) {
  return orientation(from, to, at);
}

/// The side of the line on which a pixel's centre is, exactly: 1 on the left, -1 on the right, 0 on
/// it.
int side_of_line(const Point2& from, const Point2& to, const PixelCentre& centre) {
  if (from.y != to.y) return (to.y > from.y ? 1 : -1) * crossing(from, to, centre);
  return (to.x > from.x ? -1 : 1) * compare_with_centres(from.y, centre.size.height, centre.row);
}

template <class Difference>
int sign_at(const Difference& d, const ExactProjector& projector) {
  return (d.slope_x * projector.x + d.slope_y * projector.y + d.constant * projector.w).sign();
}

/// Holds the sum of three products of numbers of 62, 31 and 30 bits exactly.
__extension__ using Wide = __int128;

Predicate predicate_at(const PixelCentre&) { return Predicate::depth_at_pixel; }
Predicate predicate_at(const Point2&) { return Predicate::depth_at_point; }

}  // namespace

/// From z = (h - A x - B y) / C on each plane: (za - zb) Ca Cb with the sign of za - zb.
DepthComparison::Difference::Difference(const Plane& a, const Plane& b) {
  const ExactPlane p(a), q(b);
  const ExactNumber &cp = p.normal.z, &cq = q.normal.z;
  const bool turned = cp.sign() != cq.sign();
  const auto difference = [&](const ExactNumber& of_p, const ExactNumber& of_q) {
    return turned ? of_q * cp - of_p * cq : of_p * cq - of_q * cp;
  };
  slope_x = difference(-p.normal.x, -q.normal.x);
  slope_y = difference(-p.normal.y, -q.normal.y);
  constant = difference(dot(p.normal, p.through), dot(q.normal, q.through));
  make_near();
}

/// From z = -(a x + b y + d) / c on each plane.
DepthComparison::Difference::Difference(const PlaneInPicture& a, const PlaneInPicture& b) {
  const bool turned = a.c.sign() != b.c.sign();
  const auto difference = [&](const ExactNumber& of_a, const ExactNumber& of_b) {
    return turned ? of_a * b.c - of_b * a.c : of_b * a.c - of_a * b.c;
  };
  slope_x = difference(a.a, b.a);
  slope_y = difference(a.b, b.b);
  constant = difference(a.d, b.d);
  make_near();
}

void DepthComparison::Difference::make_near() {
  if (is_zero()) return;
  const std::int64_t largest =
      std::max({exponent_of(slope_x), exponent_of(slope_y), exponent_of(constant)});
  near = {scaled(slope_x, largest), scaled(slope_y, largest), scaled(constant, largest)};

  std::int64_t lowest = largest;
  for (const ExactNumber* number : {&slope_x, &slope_y, &constant}) {
    const ExactNumber::Leading leading = number->leading();
    if (!leading.is_all) return;
    if (leading.mantissa != 0.0) lowest = std::min(lowest, lowest_digit(leading));
  }
  constexpr std::int64_t kWholeBits = 62;
  if (largest - lowest > kWholeBits) return;
  const auto in_whole = [&](double part) {
    return static_cast<std::int64_t>(std::ldexp(part, static_cast<int>(largest - lowest)));
  };
  whole = {in_whole(near.slope_x), in_whole(near.slope_y), in_whole(near.constant)};
}

bool DepthComparison::Difference::is_zero() const {
  return slope_x.sign() == 0 && slope_y.sign() == 0 && constant.sign() == 0;
}

int DepthComparison::Difference::filtered(const Position& at) const {
  constexpr double kVanished = 0x1p-700;  // bounds coefficients that underflowed
  const double x = near.slope_x * at.x, y = near.slope_y * at.y;
  const double value = x + y + near.constant;
  const double bound = 6.0 * kUnit * (std::abs(x) + std::abs(y) + std::abs(near.constant)) +
                       2.0 * at.error * (std::abs(near.slope_x) + std::abs(near.slope_y)) +
                       kVanished;
  return std::abs(value) > bound * kInflate ? decided_sign(value) : 0;
}

std::optional<DepthComparison::Hinge> DepthComparison::hinge_of(const Plane& a, const Plane& b) {
  if (!a.is_plain() || !b.is_plain()) return std::nullopt;
  std::array<Point2, 3> common;
  std::size_t n = 0;
  for (const Point3* point : {&a.p, &a.q, &a.r}) {
    if (b.goes_through(*point)) common[n++] = Point2(*point);
  }
  if (n < 2) return std::nullopt;
  assert(common[0] != common[1]);  // no plane is edge-on
  const auto is_off = [&](const Point3& v) { return !a.goes_through(v); };
  const Point3& third = is_off(b.p) ? b.p : is_off(b.q) ? b.q : b.r;
  const int nearer_than_a = side_of_plane(third, a) * facing(a);
  return Hinge{common[0], common[1],
               -nearer_than_a * orientation(common[0], common[1], Point2(third))};
}

void DepthComparison::make_ready() {
  if (is_ready()) return;
  hinge_ = hinge_of(a_, b_);
  if (!hinge_) difference_.emplace(a_, b_);
  assert(hinge_.has_value() != difference_.has_value());
}

std::optional<int> DepthComparison::order_at_hand(const Point2& at) const {
  if (hinge_) {
    if (at == hinge_->from || at == hinge_->to) return 0;
    return hinge_->order_on_left * orientation(hinge_->from, hinge_->to, at);
  }
  const int order = filtered({at.x, at.y, 0.0});
  if (order != 0) return order;
  return difference_ && difference_->is_zero() ? std::optional(0) : std::nullopt;
}

std::optional<DepthComparison::Linear> DepthComparison::rounded() const {
  constexpr double kFar = 1024.0, kLeast = 0x1p-900;
  if (difference_) return difference_->near;
  if (!hinge_) return std::nullopt;
  const auto& [from, to, order] = *hinge_;
  if (!(std::max(std::abs(from.x), std::abs(from.y)) < kFar)) return std::nullopt;
  const double run = to.x - from.x, rise = to.y - from.y;
  const double constant = rise * from.x - run * from.y;
  const double largest = std::max({std::abs(run), std::abs(rise), std::abs(constant)});
  if (largest < kLeast) return std::nullopt;
  const double scale = order / largest;
  return Linear{-rise * scale, run * scale, constant * scale};
}

template <class At>
int DepthComparison::exact(const At& at) {
  if (!is_ready()) {
    make_ready();
    if (!hinge_) {
      count_exact(predicate_at(at));
    } else if (hinge_->order_on_left == 0) {
      count_by_definition(predicate_at(at));
    }
    return order(at);
  }
  if (hinge_) return hinge_->order_on_left * side_of_line(hinge_->from, hinge_->to, at);
  if (difference_->is_zero()) return 0;
  count_exact(predicate_at(at));
  return difference_->exact(at);
}

int DepthComparison::Difference::exact(const Point2& at) const {
  return sign_at(*this, ExactProjector(at));
}

/// Multiplied by twice the picture's width and height, so that all numbers are integers.
int DepthComparison::Difference::exact(const PixelCentre& centre) const {
  if (!whole) return sign_at(*this, ExactProjector(centre));
  const Wide width = centre.size.width, height = centre.size.height;
  const Wide value = whole->slope_x * ((2 * Wide{centre.column} + 1) * height) +
                     whole->slope_y * ((2 * Wide{centre.row} + 1) * width) +
                     whole->constant * (2 * width * height);
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

template int DepthComparison::exact(const PixelCentre&);
template int DepthComparison::exact(const Point2&);

}  // namespace displayfile
