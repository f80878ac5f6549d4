#include "interp/visibility/row_triangles.h"

#include "clip/base/vector_kind.h"
#include "hidden/exact/rounding.h"
#include "interp/visibility/row_bounds.h"

// The code below is compiled once for each kind of vector.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "interp/visibility/row_triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace displayfile::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using DoubleTag = hn::CappedTag<double, TriangleBlock::kMost>;
using Doubles = hn::Vec<DoubleTag>;
using DoubleMask = hn::Mask<DoubleTag>;
constexpr DoubleTag kDoubles{};
constexpr hn::Rebind<std::int32_t, DoubleTag> kInts{};
constexpr hn::Rebind<float, DoubleTag> kFloats{};

HWY_INLINE Doubles all(double value) { return hn::Set(kDoubles, value); }
HWY_INLINE Doubles least(Doubles a, Doubles b, Doubles c) { return hn::Min(hn::Min(a, b), c); }
HWY_INLINE Doubles most(Doubles a, Doubles b, Doubles c) { return hn::Max(hn::Max(a, b), c); }
HWY_INLINE Doubles times(Doubles a, Doubles b) { return hn::Mul(a, b); }
HWY_INLINE Doubles sum(Doubles a, Doubles b) { return hn::Add(a, b); }

/// As many of a block's triangles as a vector has doubles, from the i-th on.
class Made {
 public:
  Made(const TriangleBlock& block, int i, const PictureSize& size, const RowSlack& slack)
      : i_(i),
        width_(all(size.width)),
        height_(all(size.height)),
        column_slack_(all(slack.column)),
        row_slack_(all(slack.row)) {
    for (int k = 0; k < 3; ++k) {
      x_[k] = times(hn::Load(kDoubles, block.x[k] + i), width_);
      y_[k] = hn::Load(kDoubles, block.y[k] + i);
      z_[k] = hn::Load(kDoubles, block.z[k] + i);
      row_[k] = first_row_above(y_[k]);
      y_[k] = times(y_[k], height_);
    }
  }

  void make(double depth_error, RowTriangles& made) {
    find_box(made);
    find_depth(depth_error, made);
    find_sides(made);
    put(needs_more_, made.needs_more);
  }

 private:
  /// As the function of that name (hidden/exact/pixel_centre.h), to which cases exactly on a row of
  /// centres are left.
  HWY_INLINE Doubles first_row_above(Doubles y) {
    const Doubles one = all(1.0), two = all(2.0);
    const Doubles t = hn::Sub(times(y, height_), all(0.5)), row = hn::Floor(t);
    const Doubles twice = times(y, times(height_, two)), centre = sum(times(row, two), one);
    const Doubles next = sum(centre, two);
    const Doubles close = times(two, row_slack_);
    const auto is_close = [&](Doubles at) { return hn::Le(hn::Abs(hn::Sub(twice, at)), close); };
    needs_more_ = hn::Or(needs_more_, hn::Or(is_close(centre), is_close(next)));
    const DoubleMask is_here = hn::And(hn::Lt(twice, centre), hn::Ge(row, hn::Zero(kDoubles)));
    const Doubles later = hn::IfThenElse(hn::Lt(twice, next), sum(row, one), sum(row, two));
    const Doubles found = hn::Min(hn::IfThenElse(is_here, row, later), height_);
    const Doubles in_picture = hn::IfThenElse(hn::Lt(t, height_), found, height_);
    return hn::IfThenElse(hn::Lt(t, all(-0.5)), hn::Zero(kDoubles), in_picture);
  }

  /// The first column, from 0 to width, whose centre is at x or after it, in pixels.
  HWY_INLINE Doubles first_column_after(Doubles x) const {
    const Doubles column = hn::Ceil(hn::Sub(x, all(0.5)));
    return hn::Min(hn::Max(column, hn::Zero(kDoubles)), width_);
  }

  HWY_INLINE void find_box(RowTriangles& made) {
    const Doubles left = least(x_[0], x_[1], x_[2]), right = most(x_[0], x_[1], x_[2]);
    const Doubles bottom = least(y_[0], y_[1], y_[2]), top = most(y_[0], y_[1], y_[2]);
    const auto near = [](Doubles low, Doubles high, Doubles side) {
      return hn::And(hn::Ge(low, hn::Neg(side)), hn::Le(high, times(all(2.0), side)));
    };
    needs_more_ = hn::Or(needs_more_,
                         hn::Not(hn::And(near(left, right, width_), near(bottom, top, height_))));
    across_ = hn::Max(hn::Sub(right, left), hn::Sub(top, bottom));
    const Doubles of_columns = all(row_bounds::kColumnError);
    column_ =
        first_column_after(hn::Sub(left, sum(times(hn::Abs(left), of_columns), column_slack_)));
    column_end_ =
        first_column_after(sum(right, sum(times(hn::Abs(right), of_columns), column_slack_)));
    row_begin_ = least(row_[0], row_[1], row_[2]);
    row_end_ = most(row_[0], row_[1], row_[2]);
    put(hn::Or(hn::Eq(column_, column_end_), hn::Eq(row_begin_, row_end_)), made.covers_none);
    put(column_, made.column);
    put(column_end_, made.column_end);
    put(row_begin_, made.row_begin);
    put(row_end_, made.row_end);
  }

  HWY_INLINE void find_depth(double depth_error, RowTriangles& made) {
    const Doubles px = hn::Sub(x_[1], x_[0]), py = hn::Sub(y_[1], y_[0]);
    const Doubles qx = hn::Sub(x_[2], x_[0]), qy = hn::Sub(y_[2], y_[0]);
    const Doubles pz = hn::Sub(z_[1], z_[0]), qz = hn::Sub(z_[2], z_[0]);
    const Doubles area = hn::Sub(times(px, qy), times(py, qx));
    const Doubles per_area = hn::Div(all(1.0), area);
    const Doubles half = all(0.5), two = all(2.0);
    const Doubles coordinates =
        times(all(row_bounds::kOfCoordinates), sum(times(all(3.0), sum(width_, height_)), across_));
    const Doubles area_error = times(coordinates, across_);
    needs_more_ = hn::Or(needs_more_, hn::Not(hn::Gt(hn::Abs(area), times(two, area_error))));
    const Doubles dz_dx = times(hn::Sub(times(pz, qy), times(qz, py)), per_area);
    const Doubles dz_dy = times(hn::Sub(times(qz, px), times(pz, qx)), per_area);
    const Doubles slopes = sum(hn::Abs(dz_dx), hn::Abs(dz_dy));
    const Doubles deep = sum(hn::Abs(pz), hn::Abs(qz));
    const Doubles slope_error =
        times(times(two, hn::Abs(per_area)),
              sum(times(times(all(4.0), coordinates), deep), times(slopes, area_error)));
    const Doubles reach = sum(across_, two);
    const Doubles z = sum(sum(z_[0], times(hn::Sub(sum(row_begin_, half), y_[0]), dz_dy)),
                          times(hn::Sub(sum(column_, half), x_[0]), dz_dx));
    const Doubles largest =
        sum(sum(hn::Abs(z), times(hn::Sub(column_end_, column_), hn::Abs(dz_dx))),
            times(hn::Sub(row_end_, row_begin_), hn::Abs(dz_dy)));
    const Doubles error =
        sum(sum(sum(times(times(two, reach), slope_error), times(slopes, coordinates)),
                times(all(row_bounds::kOfCoordinates), sum(hn::Abs(z_[0]), times(reach, slopes)))),
            times(all(row_bounds::kDepthUnit), largest));
    put(hn::And(hn::Le(error, all(depth_error)), hn::Le(largest, all(row_bounds::kLargestDepth))),
        made.is_certain);
    put(hn::Lt(area, hn::Zero(kDoubles)), made.turned_away);
    put(z, made.z);
    put(dz_dx, made.dz_dx);
    put(dz_dy, made.dz_dy);
    is_counterclockwise_ = hn::Gt(area, hn::Zero(kDoubles));
  }

  HWY_INLINE void find_sides(RowTriangles& made) {
    const Doubles all_rows = hn::Sub(row_end_, row_begin_), half = all(0.5);
    Doubles error = hn::Zero(kDoubles);
    DoubleMask unknown = hn::Lt(error, error);
    for (int k = 0, from = 2; k < 3; from = k++) {
      const DoubleMask crosses = hn::Ne(row_[from], row_[k]);
      const Doubles rise = hn::Sub(y_[k], y_[from]);
      const Doubles slope = hn::Div(hn::Sub(x_[k], x_[from]), rise);
      const Doubles heights = sum(hn::Abs(y_[from]), hn::Abs(y_[k]));
      const DoubleMask is_steep = hn::Gt(hn::Abs(rise), times(all(8.0 * kUnit), heights));
      unknown = hn::Or(unknown, hn::AndNot(is_steep, crosses));
      const Doubles at = hn::Sub(
          hn::Sub(sum(x_[from], times(hn::Sub(sum(row_begin_, half), y_[from]), slope)), half),
          column_);
      const Doubles ends = sum(hn::Abs(x_[from]), hn::Abs(x_[k]));
      const Doubles of_double =
          times(times(all(16.0 * kUnit), sum(ends, times(hn::Abs(slope), heights))),
                sum(all(2.0), hn::Div(all_rows, hn::Abs(rise))));
      const Doubles of_single =
          times(all(row_bounds::kEdgeUnit), sum(hn::Abs(at), times(hn::Abs(slope), all_rows)));
      const Doubles of_viewing =
          sum(column_slack_, times(hn::Abs(slope), times(all(2.0), row_slack_)));
      error = hn::IfThenElse(crosses, hn::Max(error, sum(sum(of_double, of_single), of_viewing)),
                             error);
      const DoubleMask rises = hn::Gt(rise, hn::Zero(kDoubles));
      put(crosses, made.crosses[k]);
      put(hn::Not(hn::Xor(rises, is_counterclockwise_)), made.on_right[k]);
      put(at, made.x[k]);
      put(slope, made.slope[k]);
    }
    const DoubleMask known = hn::Lt(error, all(row_bounds::kLargestEdgeError));
    put(hn::AndNot(unknown, known), made.has_sides);
    put(times(error, all(1.0 + 0x1p-20)), made.edge_error);
  }

  HWY_INLINE void put(Doubles whole, std::int32_t* to) const {
    hn::Store(hn::DemoteTo(kInts, whole), kInts, to + i_);
  }
  HWY_INLINE void put(Doubles value, float* to) const {
    hn::Store(hn::DemoteTo(kFloats, value), kFloats, to + i_);
  }
  HWY_INLINE void put(DoubleMask mask, std::uint32_t& bits) const {
    alignas(8) std::uint8_t own[8] = {};
    hn::StoreMaskBits(kDoubles, mask, own);
    bits |= static_cast<std::uint32_t>(own[0]) << i_;
  }

  int i_;
  Doubles width_, height_, column_slack_, row_slack_;
  Doubles x_[3], y_[3], z_[3], row_[3];  // in pixels but for z
  Doubles column_, column_end_, row_begin_, row_end_, across_;
  DoubleMask is_counterclockwise_, needs_more_ = hn::FirstN(kDoubles, 0);
};

void MakeRowTriangles(const TriangleBlock& block, int n, const PictureSize& size,
                      double depth_error, RowTriangles& made, const RowSlack& slack) {
  made.needs_more = made.covers_none = made.is_certain = made.turned_away = made.has_sides = 0;
  for (int k = 0; k < 3; ++k) made.crosses[k] = made.on_right[k] = 0;
  for (int i = 0; i < n; i += static_cast<int>(hn::Lanes(kDoubles))) {
    Made(block, i, size, slack).make(depth_error, made);
  }
}

}  // namespace displayfile::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace displayfile {

void make_row_triangles(const TriangleBlock& block, int n, const PictureSize& size,
                        double depth_error, RowTriangles& made, const RowSlack& slack) {
  DISPLAYFILE_WIDEST_FORM(MakeRowTriangles)(block, n, size, depth_error, made, slack);
}

}  // namespace displayfile
#endif
