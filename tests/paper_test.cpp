// Sheets of paper, and how a picture lies on them.

#include "interp/device/picture.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/error_of.h"

namespace displayfile {
namespace {

using namespace test;

TEST(Paper, HasNames) {
  EXPECT_EQ(paper_of("A4"), (Paper{210, 297}));
  EXPECT_EQ(paper_of("a3"), (Paper{297, 420}));
  EXPECT_EQ(paper_of("Letter"), (Paper{215.9, 279.4}));
  EXPECT_EQ(paper_of("a4-landscape").turned, Paper::Turned::landscape);
  EXPECT_EQ(paper_of("A4-portrait").turned, Paper::Turned::portrait);
  EXPECT_EQ(paper_of("100x50.5"), (Paper{100, 50.5, 10, Paper::Turned::landscape}));
  EXPECT_EQ(paper_of("50x100"), (Paper{50, 100, 10, Paper::Turned::portrait}));
  EXPECT_EQ(paper_of("50x100-landscape").turned, Paper::Turned::landscape);
}

TEST(Paper, UnknownOnesAreErrors) {
  expect_error([] { paper_of("A9"); }, "unknown paper 'A9'");
  expect_error([] { paper_of("lettr"); }, "did you mean 'letter'?");
  for (const char* const word :
       {"", "x", "10", "10x", "x10", "10x10x10", "10mmx10mm", "A4-upright"}) {
    expect_error([&] { paper_of(word); }, "unknown paper");
  }
  for (const char* const word : {"0x10", "10x-5", "nanx10", "10x1e9", "infx10"}) {
    expect_error([&] { paper_of(word); }, "paper of");
  }
}

TEST(PaperFit, IsTheLargestInTheMiddle) {
  PaperFit fit = fit_on_paper(paper_of("A4"), 400, 400);
  EXPECT_EQ(fit.width, 210);
  EXPECT_EQ(fit.height, 297);
  EXPECT_EQ(fit.pixel, 190.0 / 400);
  EXPECT_EQ(fit.left, 10);
  EXPECT_EQ(fit.top, (297 - 190) / 2.0);
  fit = fit_on_paper(paper_of("A4"), 800, 400);  // wider than high: the sheet too
  EXPECT_EQ(fit.width, 297);
  EXPECT_EQ(fit.height, 210);
  EXPECT_EQ(fit.pixel, 277.0 / 800);
  fit = fit_on_paper(paper_of("A4-portrait"), 800, 400);
  EXPECT_EQ(fit.width, 210);
  Paper paper = paper_of("100x50");
  paper.margin = 0.0;
  fit = fit_on_paper(paper, 10, 10);
  EXPECT_EQ(fit.width, 100);
  EXPECT_EQ(fit.pixel, 5.0);
  EXPECT_EQ(fit.left, 25.0);
}

TEST(PaperFit, NeedsRoomBetweenTheMargins) {
  Paper paper;
  for (const double margin : {-1.0, 105.0, 104.9, 1e9, std::numeric_limits<double>::quiet_NaN()}) {
    paper.margin = margin;
    expect_error([&] { fit_on_paper(paper, 100, 100); }, "margins of");
  }
  paper = {0.0, 100.0};
  expect_error([&] { fit_on_paper(paper, 100, 100); }, "paper of 0x100 mm");
}

TEST(Pens, RefuseWhatIsOutOfRange) {
  const auto with = [](double spacing, double angle, double width) {
    Hatching hatching;
    hatching.spacing = spacing;
    hatching.angle = angle;
    hatching.width = width;
    return Pens{hatching};
  };
  EXPECT_NO_THROW(require_pens({}));
  EXPECT_NO_THROW(require_pens(with(0.05, -720.0, 0.1)));
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const double spacing : {0.0, -1.0, 0.049, 1e5, kNan}) {
    expect_error([&] { require_pens(with(spacing, 0.0, 0.3)); }, "hatching");
  }
  expect_error([&] { require_pens(with(1.0, kNan, 0.3)); }, "angle");
  for (const double width : {0.0, -1.0, kNan}) {
    expect_error([&] { require_pens(with(1.0, 0.0, width)); }, "pen of");
  }
}

}  // namespace
}  // namespace displayfile
