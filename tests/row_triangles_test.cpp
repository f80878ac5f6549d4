// Triangles prepared for rows of pixels in vectors: the flags of each are correct by the exact scan
// conversion and by its plane, and few are left to be prepared one by one.

#include "interp/visibility/row_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "interp/scan/scan_convert.h"

namespace displayfile {
namespace {

using Triangle = std::array<Point3, 3>;
constexpr double kDepthError = 0x1p-17;

/// In pixels: corners around a place, anywhere or on a grid, some far away from the picture.
class Triangles {
 public:
  Triangles(const PictureSize& size, double extent, double grid, unsigned seed)
      : size_(size), grid_(grid), random_(seed), near_(-extent, extent) {}

  Triangle next() {
    const double x = part_(random_) * size_.width, y = part_(random_) * size_.height;
    Triangle t;
    for (Point3& p : t) {
      p = Point3(on_grid(x + near_(random_)) / size_.width,
                 on_grid(y + near_(random_)) / size_.height, part_(random_));
    }
    return t;
  }

 private:
  double on_grid(double pixels) const {
    return grid_ > 0.0 ? std::round(pixels / grid_) * grid_ : pixels;
  }
  PictureSize size_;
  double grid_;
  std::mt19937 random_;
  std::uniform_real_distribution<double> near_, part_{-0.1, 1.1};
};

class Checked {
 public:
  Checked(const PictureSize& size, const RowTriangles& made) : size_(size), made_(made) {}

  void check(const Triangle& t, int i) {
    i_ = i;
    const auto rows =
        std::minmax({first_row_above(t[0].y, size_.height), first_row_above(t[1].y, size_.height),
                     first_row_above(t[2].y, size_.height)});
    bool covers = false;
    converter_.scan_convert(t, {size_, 0, size_.height}, [&](int row, int first, int end) {
      covers = true;
      check_span(t, row, first, end);
    });
    if (is(made_.covers_none)) {
      EXPECT_FALSE(covers);
      return;
    }
    EXPECT_EQ(made_.row_begin[i], rows.first);
    EXPECT_EQ(made_.row_end[i], rows.second);
    const Point3 p = t[1] - t[0], q = t[2] - t[0];
    EXPECT_EQ(is(made_.turned_away), p.x * q.y - p.y * q.x < 0.0);
  }

 private:
  bool is(std::uint32_t bits) const { return (bits >> i_ & 1) != 0; }

  void check_span(const Triangle& t, int row, int first, int end) const {
    if (is(made_.covers_none)) return;  // an error that check reports
    EXPECT_GE(first, made_.column[i_]);
    EXPECT_LE(end, made_.column_end[i_]);
    if (is(made_.has_sides)) {
      check_crossing(row, true, end);
      check_crossing(row, false, first);
    }
    if (!is(made_.is_certain)) return;
    for (const int column : {first, end - 1}) {
      const float z = made_.z[i_] +
                      static_cast<float>(column - made_.column[i_]) * made_.dz_dx[i_] +
                      static_cast<float>(row - made_.row_begin[i_]) * made_.dz_dy[i_];
      EXPECT_NEAR(static_cast<double>(z), depth(t, column, row), kDepthError);
    }
  }

  /// The side that bounds a row ends it at that column, unless the crossing is as close to a centre
  /// as the bound allows.
  void check_crossing(int row, bool on_right, int column) const {
    float bound = on_right ? 1e30F : -1e30F;
    for (int k = 0; k < 3; ++k) {
      if (!is(made_.crosses[k]) || is(made_.on_right[k]) != on_right) continue;
      const float x =
          made_.x[k][i_] + static_cast<float>(row - made_.row_begin[i_]) * made_.slope[k][i_];
      bound = on_right ? std::min(bound, x) : std::max(bound, x);
    }
    const float off = std::abs(std::ceil(bound) - bound - 0.5F);
    if (off >= 0.5F - made_.edge_error[i_]) return;
    const int found = static_cast<int>(std::ceil(bound)) + made_.column[i_];
    EXPECT_EQ(std::clamp(found, 0, size_.width), column) << "row " << row;
  }

  double depth(const Triangle& t, int column, int row) const {
    using Long = long double;
    const Long px = t[1].x - Long(t[0].x), py = t[1].y - Long(t[0].y), pz = t[1].z - Long(t[0].z);
    const Long qx = t[2].x - Long(t[0].x), qy = t[2].y - Long(t[0].y), qz = t[2].z - Long(t[0].z);
    const Long x = (column + 0.5L) / size_.width - t[0].x;
    const Long y = (row + 0.5L) / size_.height - t[0].y;
    const Long area = px * qy - py * qx;
    return static_cast<double>(t[0].z + ((pz * qy - qz * py) * x + (qz * px - pz * qx) * y) / area);
  }

  PictureSize size_;
  const RowTriangles& made_;
  int i_ = 0;
  ScanConverter converter_;
};

/// The number of triangles, in blocks of up to eight, that need more work.
int needing_more(const PictureSize& size, double extent, double grid, int blocks) {
  Triangles triangles(size, extent, grid, 7);
  int more = 0;
  for (int b = 0; b < blocks; ++b) {
    const int n = 1 + b % TriangleBlock::kMost;
    std::array<Triangle, TriangleBlock::kMost> all;
    TriangleBlock block{};
    for (int i = 0; i < n; ++i) {
      all[static_cast<std::size_t>(i)] = triangles.next();
      for (std::size_t k = 0; k < 3; ++k) {
        const Point3& p = all[static_cast<std::size_t>(i)][k];
        block.x[k][i] = p.x;
        block.y[k][i] = p.y;
        block.z[k][i] = p.z;
      }
    }
    RowTriangles made;
    make_row_triangles(block, n, size, kDepthError, made);
    Checked checked(size, made);
    for (int i = 0; i < n; ++i) {
      if ((made.needs_more >> i & 1) != 0) {
        ++more;
      } else {
        checked.check(all[static_cast<std::size_t>(i)], i);
      }
    }
  }
  return more;
}

TEST(RowTriangles, WhatIsSaidOfEachHolds) {
  for (const PictureSize size :
       {PictureSize{64, 64}, PictureSize{1023, 700}, PictureSize{7, 3000}}) {
    for (const double extent : {0.4, 3.0, 40.0}) {
      const int more = needing_more(size, extent, 0.0, 2000);
      if (extent < size.width) {
        EXPECT_LT(more, 40) << extent;  // of 9000
      }
    }
    needing_more(size, 3.0, 0.5, 2000);  // corners on centres and between them
    needing_more(size, 1e5, 0.0, 500);   // far from the picture
  }
}

TEST(RowTriangles, WhatIsNoTriangleOrFarAwayNeedsMore) {
  constexpr PictureSize kSize{100, 100};
  const std::array<Triangle, 4> hard{
      Triangle{{{0.1, 0.1, 0}, {0.5, 0.5, 0}, {0.9, 0.9, 0}}},        // in line
      Triangle{{{0.1, 0.1, 0}, {0.1, 0.1, 1}, {0.9, 0.7, 0}}},        // two coincident corners
      Triangle{{{-5.0, 0.1, 0}, {0.1, 0.2, 1}, {0.9, 0.7, 0}}},       // left of the picture
      Triangle{{{0.1, 0.1, 0}, {0.1, 1e100, 1}, {0.9, -1e100, 0}}}};  // as far as can be
  TriangleBlock block{};
  for (std::size_t i = 0; i < hard.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      block.x[k][i] = hard[i][k].x;
      block.y[k][i] = hard[i][k].y;
      block.z[k][i] = hard[i][k].z;
    }
  }
  RowTriangles made;
  make_row_triangles(block, static_cast<int>(hard.size()), kSize, kDepthError, made);
  EXPECT_EQ(made.needs_more & 0xFU, 0xFU);
}

}  // namespace
}  // namespace displayfile
