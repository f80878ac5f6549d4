#include "hidden/depth_comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hidden/exact_point.h"
#include "hidden/exact_projector.h"
#include "hidden/predicate_counts.h"

namespace displayfile {

namespace {

constexpr std::int64_t kNoExponent = std::numeric_limits<std::int64_t>::min() / 2;

std::int64_t exponent_of(const ExactNumber& number) {
  return number.sign() == 0 ? kNoExponent : number.leading().exponent;
}

/// number / 2^exponent, which is less than 1.
double scaled(const ExactNumber& number, std::int64_t exponent) {
  constexpr std::int64_t kVanishes = -2000;
  if (number.sign() == 0) return 0.0;
  const ExactNumber::Leading leading = number.leading();
  return std::ldexp(leading.mantissa,
                    static_cast<int>(std::max(leading.exponent - exponent, kVanishes)));
}

Predicate predicate_at(const PixelCentre&) { return Predicate::depth_at_pixel; }
Predicate predicate_at(const Point2&) { return Predicate::depth_at_point; }

}  // namespace

/// With z = (h - A x - B y) / C on each plane: (za - zb) Ca Cb, turned to the sign of za - zb.
DepthComparison::Difference::Difference(const Plane& a, const Plane& b) {
  if (a.same_points(b)) return;
  const ExactPlane p(a), q(b);
  const ExactNumber &cp = p.normal.z, &cq = q.normal.z;
  const bool turned = cp.sign() != cq.sign();
  const auto difference = [&](const ExactNumber& of_p, const ExactNumber& of_q) {
    return turned ? of_q * cp - of_p * cq : of_p * cq - of_q * cp;
  };
  slope_x = difference(-p.normal.x, -q.normal.x);
  slope_y = difference(-p.normal.y, -q.normal.y);
  constant = difference(dot(p.normal, p.through), dot(q.normal, q.through));
  if (is_zero()) return;
  const std::int64_t largest =
      std::max({exponent_of(slope_x), exponent_of(slope_y), exponent_of(constant)});
  near_x = scaled(slope_x, largest);
  near_y = scaled(slope_y, largest);
  near_constant = scaled(constant, largest);
}

bool DepthComparison::Difference::is_zero() const {
  return slope_x.sign() == 0 && slope_y.sign() == 0 && constant.sign() == 0;
}

int DepthComparison::Difference::filtered(const Position& at) const {
  constexpr double kVanished = 0x1p-700;  // coefficients far smaller than the largest
  const double x = near_x * at.x, y = near_y * at.y;
  const double value = x + y + near_constant;
  const double bound = 6.0 * kUnit * (std::abs(x) + std::abs(y) + std::abs(near_constant)) +
                       2.0 * at.error * (std::abs(near_x) + std::abs(near_y)) + kVanished;
  return std::abs(value) > bound * kInflate ? decided_sign(value) : 0;
}

template <class At>
int DepthComparison::exact(const At& at) {
  if (!difference_) {
    if (a_.same_points(b_)) {
      count_by_definition(predicate_at(at));
    } else {
      count_exact(predicate_at(at));
    }
    make_exact();
    return order(at);
  }
  if (difference_->is_zero()) return 0;
  count_exact(predicate_at(at));
  const ExactProjector projector(at);
  return (difference_->slope_x * projector.x + difference_->slope_y * projector.y +
          difference_->constant * projector.w)
      .sign();
}

template int DepthComparison::exact(const PixelCentre&);
template int DepthComparison::exact(const Point2&);

}  // namespace displayfile
