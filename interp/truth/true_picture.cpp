#include "interp/truth/true_picture.h"

#include <algorithm>
#include <cmath>

#include "clip/base/budgeted_work.h"
#include "clip/base/memory.h"
#include "clip/base/work_budget.h"
#include "interp/truth/whole_numbers.h"

namespace displayfile {

namespace {

constexpr double kBackgroundDepth = -std::numeric_limits<double>::infinity();

/// A determinant's part: a.i b.j - a.j b.i.
Integer minor(const TruePoint& a, const TruePoint& b, Integer TruePoint::*i,
              Integer TruePoint::*j) {
  return a.*i * b.*j - a.*j * b.*i;
}

/// True if the three points are collinear in the projection, exactly.
bool in_line(const Point3& p, const Point3& q, const Point3& r) {
  const int places = common_places(std::array{p.x, p.y, q.x, q.y, r.x, r.y});
  const auto apart = [&](double a, double b) -> Integer {
    return scaled(a, places) - scaled(b, places);
  };
  const Integer left = apart(q.x, p.x) * apart(r.y, p.y);
  const Integer right = apart(q.y, p.y) * apart(r.x, p.x);
  return left == right;
}

}  // namespace

std::optional<std::array<std::size_t, 3>> support_of(std::span<const Point3> v) {
  const Point3& p = v[0];
  const auto distance = [&](const Point3& i) {
    return (i.x - p.x) * (i.x - p.x) + (i.y - p.y) * (i.y - p.y);
  };
  const auto beside_line = [&](const Point3& q, const Point3& i) {
    return std::abs((q.x - p.x) * (i.y - p.y) - (q.y - p.y) * (i.x - p.x));
  };
  std::size_t q = 0, r = 0;
  if (v.size() == 3) {
    q = 1;
    r = 2;
  } else {
    for (std::size_t i = 1; i < v.size(); ++i) {
      if (distance(v[i]) > distance(v[q])) q = i;
    }
    for (std::size_t i = 1; i < v.size(); ++i) {
      if (beside_line(v[q], v[i]) > beside_line(v[q], v[r])) r = i;
    }
  }
  for (std::size_t i = 0; i < v.size() && in_line(p, v[q], v[r]); ++i) {
    if (!in_line(p, v[q], v[i])) r = i;
  }
  if (in_line(p, v[q], v[r])) return std::nullopt;
  return std::array<std::size_t, 3>{0, q, r};
}

// ---- The support plane -------------------------------------------------------------------

/// The plane A x + B y + C z + D w = 0 contains p, q and r; A to D are determinants of three of
/// their coordinates. At a centre ((2 column + 1) / 2, (2 row + 1) / 2) its depth is -(A (2 column
/// + 1) + B (2 row + 1) + 2 D) / (2 C).
ExactDepth::ExactDepth(const TruePoint& p, const TruePoint& q, const TruePoint& r) {
  using P = TruePoint;
  const Integer xy = minor(q, r, &P::x, &P::y), xw = minor(q, r, &P::x, &P::w),
                yw = minor(q, r, &P::y, &P::w);
  divisor_ = p.x * yw - p.y * xw + p.w * xy;
  if (divisor_ == 0) return;
  const Integer xz = minor(q, r, &P::x, &P::z), yz = minor(q, r, &P::y, &P::z),
                zw = minor(q, r, &P::z, &P::w);
  const Integer minus_a = p.z * yw - p.y * zw - p.w * yz;
  const Integer minus_b = p.x * zw - p.z * xw + p.w * xz;
  const Integer minus_d = p.x * yz - p.y * xz + p.z * xy;
  origin_ = minus_a + minus_b + 2 * minus_d;
  right_ = 2 * minus_a;
  up_ = 2 * minus_b;
  divisor_ *= 2;
  const std::size_t common = std::min({trailing_zeros(origin_), trailing_zeros(right_),
                                       trailing_zeros(up_), trailing_zeros(divisor_)});
  const bool turned = divisor_ < 0;
  for (Integer* n : {&origin_, &right_, &up_, &divisor_}) {
    *n >>= common;
    if (turned) *n = -*n;
  }
}

// ---- Coverage -------------------------------------------------------------------------------

CentreMarks::CentreMarks(int width, int height)
    : width_(width),
      height_(height),
      changes_(in_large_pages<std::uint8_t>(
          static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0)),
      reached_(static_cast<std::size_t>(height), kNoColumns) {}

/// The least j, from 0 to the height, with j + 1/2 > y / w.
int CentreMarks::row_above(const TruePoint& vertex) {
  denominator_ = 2 * vertex.w;
  numerator_ = 2 * vertex.y - vertex.w + 1;
  return division_.ceiling(numerator_, denominator_, height_);
}

void CentreMarks::mark(std::span<const TruePoint> polygon) {
  row_above_.resize(polygon.size());
  first_row_ = height_;
  end_row_ = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    row_above_[k] = row_above(polygon[k]);
    first_row_ = std::min(first_row_, row_above_[k]);
    end_row_ = std::max(end_row_, row_above_[k]);
  }
  std::size_t from = polygon.size() - 1;
  for (std::size_t to = 0; to < polygon.size(); from = to++) {
    if (row_above_[from] < row_above_[to]) {
      mark_edge(polygon[from], polygon[to], row_above_[from], row_above_[to]);
    } else if (row_above_[to] < row_above_[from]) {
      mark_edge(polygon[to], polygon[from], row_above_[to], row_above_[from]);
    }
  }
}

/// In each row that the edge crosses, the first column whose centre is at or right of the crossing.
/// The edge is on the line a x + b y + c w = 0, where a is negative, since it rises: in the row of
/// centres (2 row + 1) / 2 the crossing is at (b (2 row + 1) + 2 c) / (-2 a).
void CentreMarks::mark_edge(const TruePoint& low, const TruePoint& high, int first, int end) {
  using P = TruePoint;
  const Integer a = minor(low, high, &P::y, &P::w), b = minor(high, low, &P::x, &P::w),
                c = minor(low, high, &P::x, &P::y);
  numerator_ = b * (2 * first + 1) + 2 * c + a;
  denominator_ = -2 * a;
  step_ = 2 * b;
  for (int row = first; row < end; ++row, numerator_ += step_) {
    const int column = division_.ceiling(numerator_, denominator_, width_);
    if (column < width_) changes(row)[column] ^= 1;
    auto& [from, last] = reached_[static_cast<std::size_t>(row)];
    from = std::min(from, column);
    last = std::max(last, column);
  }
}

// ---- Visibility --------------------------------------------------------------------------

TruePicture::TruePicture(int width, int height, DepthTies* ties)
    : width_(width),
      height_(height),
      coverage_(width, height),
      ids_(in_large_pages(pixels(), std::int32_t{-1})),
      depth_(in_large_pages(pixels(), kBackgroundDepth)),
      owner_(in_large_pages(pixels(), kNone)),
      ties_(ties) {}

TruePoint TruePicture::point(const Point3& p) const {
  const int places = std::max({binary_places(p.x), binary_places(p.y), binary_places(p.z)});
  return {scaled(p.x, places) * width_, scaled(p.y, places) * height_, scaled(p.z, places),
          Integer(1) << static_cast<std::size_t>(places)};
}

void TruePicture::enter(std::span<const TruePoint> polygon, const Support& support,
                        std::int32_t pick) {
  std::optional<Entered> entered;  // not worked out for a polygon between the centres
  coverage_.for_each_run(polygon, [&](int row, int first, int end) {
    if (!entered) entered.emplace(Entered{{*support[0], *support[1], *support[2]}, pick});
    ask_budget();
    if (!entered->depth.edge_on()) enter_run(*entered, row, first, end);
  });
}

/// Rounding to the nearest double keeps order, so rounded depths that differ are in the order of
/// the exact ones; the exact ones are compared only where the rounded are equal.
void TruePicture::enter_run(Entered& polygon, int row, int first, int end) {
  constexpr int kLongRun = 4;
  const Integer& divisor = polygon.depth.divisor();
  double bound = std::numeric_limits<double>::infinity();
  if (end - first > kLongRun) {  // a plane is nearest at one of the ends
    polygon.depth.numerator(end - 1, row, numerator_);
    bound = division_.nearest_double(numerator_, divisor);
    polygon.depth.numerator(first, row, numerator_);
    bound = std::max(bound, division_.nearest_double(numerator_, divisor));
  } else {
    polygon.depth.numerator(first, row, numerator_);
  }
  auto at = static_cast<std::size_t>(height_ - 1 - row) * static_cast<std::size_t>(width_) +
            static_cast<std::size_t>(first);
  for (int column = first; column < end; ++column, ++at, numerator_ += polygon.depth.right()) {
    if (depth_[at] > bound) continue;
    const double z = division_.nearest_double(numerator_, divisor);
    auto order = std::strong_ordering::greater;
    if (owner_[at] != kNone && z <= depth_[at]) {
      if (z < depth_[at]) continue;
      order = compared(polygon.depth, owner_[at], column, row);
      if (order < 0) continue;
    }
    if (ties_ != nullptr) order == 0 ? ties_->add(at, ids_[at]) : ties_->clear(at);
    if (polygon.owner == kNone) {
      polygon.owner = static_cast<Owner>(seen_.size());
      seen_.push_back(polygon.depth);
    }
    owner_[at] = polygon.owner;
    depth_[at] = z;
    ids_[at] = polygon.pick;
  }
}

/// Compares the depth, whose numerator at the centre is numerator_, with that of the visible
/// polygon.
std::strong_ordering TruePicture::compared(const ExactDepth& depth, Owner owner, int column,
                                           int row) {
  const ExactDepth& other = seen_[owner];
  other.numerator(column, row, other_numerator_);
  left_ = numerator_ * other.divisor();
  right_ = other_numerator_ * depth.divisor();
  return left_ == right_  ? std::strong_ordering::equal
         : left_ < right_ ? std::strong_ordering::less
                          : std::strong_ordering::greater;
}

Picture TruePicture::take(bool depth) {
  Picture picture;
  picture.width = width_;
  picture.height = height_;
  picture.ids = std::move(ids_);
  if (depth) picture.depth = std::move(depth_);
  return picture;
}

}  // namespace displayfile
