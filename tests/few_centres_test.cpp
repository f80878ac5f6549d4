// Small triangles against the few pixel centres around them: a triangle reported to cover none
// covers none by the exact scan conversion, and few are undecided.

#include "hidden/exact/few_centres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "interp/scan/pixel_box.h"
#include "interp/scan/scan_convert.h"

namespace displayfile {
namespace {

struct Counts {
  int none = 0, found = 0, small = 0;
};

/// Triangles of about a pixel, their corners anywhere or on centres and between them.
Counts counts_of(const PictureSize& size, double step, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(2.0, 12.0), near(-1.2, 1.2);
  const auto on_grid = [&](double pixels) {
    return step > 0.0 ? std::round(pixels / step) * step : pixels;
  };
  ScanConverter converter;
  Counts counts;
  for (int k = 0; k < 20000; ++k) {
    const double x = place(random), y = place(random);
    std::array<Point3, 3> t;
    for (Point3& p : t) {
      p = Point3(on_grid(x + near(random)) / size.width, on_grid(y + near(random)) / size.height,
                 0);
    }
    const PixelBox box = extents_of(t, size);
    const int columns = box.end_column - box.first_column, rows = box.end_row - box.first_row;
    if (columns * rows < 1 || columns * rows > 6) continue;
    ++counts.small;
    bool covers = false;
    converter.scan_convert(t, {size, 0, size.height}, [&](int, int, int) { covers = true; });
    const bool none =
        covers_none_of_few(t[0], t[1], t[2], size, box.first_column, columns, box.first_row, rows);
    EXPECT_FALSE(none && covers) << "triangle " << k;
    counts.none += covers ? 0 : 1;
    counts.found += none ? 1 : 0;
  }
  return counts;
}

TEST(FewCentres, WhatCoversNoneIsFoundAndNothingElse) {
  for (const PictureSize size :
       {PictureSize{16, 16}, PictureSize{1023, 700}, PictureSize{65535, 3}}) {
    const Counts anywhere = counts_of(size, 0.0, 1);
    EXPECT_GT(anywhere.small, size.height > 16 ? 10000 : 1000);
    EXPECT_EQ(anywhere.found, anywhere.none);  // none lies on a side
    const Counts on_centres = counts_of(size, 0.5, 2);
    EXPECT_LE(on_centres.found, on_centres.none);
  }
}

}  // namespace
}  // namespace displayfile
