#include "tests/bench/lines_beside_peers/drawn_length.h"

#include <gtest/gtest.h>

namespace displayfile::bench {
namespace {

constexpr double kTolerance = 1e-6;

TEST(DrawnLength, WhatLiesBesideAnotherDrawingIsMeasured) {
  const LineDrawing line{{{0.0, 0.5}, {1.0, 0.5}}};
  const LineDrawing middle{{{0.75, 0.5}, {0.25, 0.5}}};
  EXPECT_NEAR(length_beside(line, middle, kTolerance), 0.5, 4 * kTolerance);
  EXPECT_EQ(length_beside(middle, line, kTolerance), 0.0);
  EXPECT_DOUBLE_EQ(length_beside(line, {}, kTolerance), 1.0);
  EXPECT_EQ(length_beside({}, line, kTolerance), 0.0);
}

TEST(DrawnLength, WithinTheToleranceItIsTheSame) {
  const LineDrawing line{{{0.1, 0.1}, {0.7, 0.9}}};
  const auto moved = [&](double far) {
    return LineDrawing{{line[0].p + Point2(0.8, -0.6) * far, line[0].q + Point2(0.8, -0.6) * far}};
  };
  EXPECT_EQ(length_beside(line, moved(0.9 * kTolerance), kTolerance), 0.0);
  EXPECT_DOUBLE_EQ(length_beside(line, moved(1.1 * kTolerance), kTolerance), 1.0);
}

TEST(DrawnLength, ALineThatCrossesIsNotTheSame) {
  const LineDrawing line{{{0.0, 0.5}, {1.0, 0.5}}}, across{{{0.5, 0.0}, {0.5, 1.0}}};
  EXPECT_NEAR(length_beside(line, across, kTolerance), 1.0, 4 * kTolerance);
}

TEST(DrawnLength, LinesOnOneAnotherCountOnce) {
  const LineDrawing drawing{{{0.0, 0.0}, {0.5, 0.0}}, {{0.25, 0.0}, {1.0, 0.0}}, {{1, 0}, {0, 0}}};
  EXPECT_DOUBLE_EQ(total_length(drawing), 2.25);
  EXPECT_NEAR(total_length(drawn_once(drawing, kTolerance)), 1.0, 4 * kTolerance);
}

TEST(DrawnLength, ManySmallSegmentsCoverALongOne) {
  LineDrawing parts;
  for (int k = 0; k < 1000; ++k)
    parts.push_back({{k / 1000.0, k / 1000.0}, {(k + 1) / 1000.0, (k + 1) / 1000.0}});
  const LineDrawing line{{{0.0, 0.0}, {1.0, 1.0}}};
  EXPECT_EQ(length_beside(line, parts, kTolerance), 0.0);
  EXPECT_EQ(length_beside(parts, line, kTolerance), 0.0);
}

}  // namespace
}  // namespace displayfile::bench
