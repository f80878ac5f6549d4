// The measures of wrong pixels and depth error, and the picture that marks them.

#include "interp/files/picture_compare.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>
#include <vector>

#include "clip/base/error.h"

namespace displayfile {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t kRed = 0xFF0000FF, kWhite = 0xFFFFFFFF;

NpyArray ids(std::vector<std::int32_t> values) {
  return {static_cast<int>(values.size()), 1, std::move(values)};
}
NpyArray depths(std::vector<double> values) {
  return {static_cast<int>(values.size()), 1, std::move(values)};
}

TEST(Measures, WrongPixelsByKind) {
  const PictureDifference d = compare(ids({-1, 3, 4, 5, -1, -1}), ids({-1, 3, 5, -1, 7, 8}));
  EXPECT_EQ(d.wrong_pixels, 4);
  EXPECT_EQ(d.polygon_and_polygon, 1);
  EXPECT_EQ(d.background_and_polygon, 3);
  EXPECT_EQ(d.background_in_first, 2);
  EXPECT_EQ(d.finite_in_both + d.finite_in_one, 0);
}

TEST(Measures, DepthErrorWhereBothAreFinite) {
  const PictureDifference d = compare(depths({0.5, 0.25, -kInfinity, 1.0, -kInfinity}),
                                      depths({0.5, 0.75, -kInfinity, -kInfinity, 0.0}));
  EXPECT_EQ(d.largest_error, 0.5);
  EXPECT_EQ(d.mean_error, 0.25);
  EXPECT_EQ(d.finite_in_both, 2);
  EXPECT_EQ(d.finite_in_one, 2);
  EXPECT_EQ(d.wrong_pixels, 3);
  EXPECT_EQ(d.largest, kInfinity);
  const PictureDifference none = compare(depths({-kInfinity}), depths({-kInfinity}));
  EXPECT_FALSE(none.differs());
  EXPECT_EQ(none.mean_error, 0.0);
}

TEST(Measures, MarksAreRedAndTheRestIsLightGrey) {
  const Picture marks = marked(ids({-1, 3, 4, 5}), ids({-1, 3, 5, -1}));
  ASSERT_EQ(marks.pixels.size(), 4u);
  EXPECT_EQ(marks.width, 4);
  EXPECT_EQ(marks.height, 1);
  EXPECT_EQ(marks.pixels[0], kWhite);
  EXPECT_EQ(marks.pixels[2], kRed);
  EXPECT_EQ(marks.pixels[3], kRed);
  const std::uint32_t tone = marks.pixels[1] & 0xff;
  EXPECT_GE(tone, 192u);
  EXPECT_LT(tone, 255u);
  EXPECT_EQ(marks.pixels[1], 0xFF000000u | tone << 16 | tone << 8 | tone);
  const Picture same = marked(ids({0, 1}), ids({0, 1}));
  EXPECT_NE(same.pixels[0], same.pixels[1]);  // neighbours are distinguished

  EXPECT_EQ(marked(depths({1.0, -kInfinity}), depths({0.5, -kInfinity})).pixels,
            (std::vector<std::uint32_t>{kRed, kWhite}));
  const Picture white{2, 1, {kWhite, kWhite}, {}, {}}, other{2, 1, {kWhite, kRed}, {}, {}};
  const Picture of_pictures = marked(white, other);
  EXPECT_EQ(of_pictures.pixels[1], kRed);
  EXPECT_GE(of_pictures.pixels[0] & 0xff, 192u);
}

TEST(Measures, PicturesOfDifferentSizesCannotBeMarked) {
  EXPECT_THROW(marked(ids({1}), ids({1, 2})), Error);
  EXPECT_THROW(marked(Picture{1, 1, {kRed}, {}, {}}, Picture{1, 2, {kRed, kRed}, {}, {}}), Error);
}

}  // namespace
}  // namespace displayfile
