// The order in which a vector device is to draw: every pixel centre shows what the z-buffer shows,
// and lines are cut where fills hide them.

#include "interp/vector/sampled/visible_order.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "interp/raster/software.h"
#include "interp/scan/scan_convert.h"
#include "interp/vector/sampled/drawing_order.h"
#include "interp/vector/vector_device.h"
#include "tests/truth_scenes.h"
#include "tests/unit_square.h"
#include "tests/vector_scenes.h"

namespace displayfile {
namespace {

using namespace test;

// ---- The order -------------------------------------------------------------------------

std::string steps(const std::vector<Overlap>& overlaps, const std::vector<double>& farthest) {
  std::string text;
  const std::vector<std::uint8_t> drawn(farthest.size(), 1);
  for (const DrawStep& step : drawing_order(overlaps, farthest, drawn)) {
    text += fmt::format("{}{} ", step.polygon, step.mend ? "!" : "");
  }
  return text;
}

TEST(DrawingOrder, FarthestFirstWhereItIsFree) {
  EXPECT_EQ(steps({}, {0.5, 0.1, 0.9, 0.1}), "1 3 0 2 ");
  EXPECT_EQ(steps({}, {}), "");
}

TEST(DrawingOrder, HiddenBeforeSeen) {
  EXPECT_EQ(steps({{2, 1}, {0, 1}}, {0.5, 0.1, 0.9, 0.1}), "3 0 2 1 ");
  EXPECT_EQ(steps({{3, 2}, {2, 1}, {1, 0}}, {0, 1, 2, 3}), "3 2 1 0 ");
}

TEST(DrawingOrder, OneOfACycleIsMendedBeforeWhatHidesIt) {
  // 0, 1 and 2 in a cycle; 3 is behind it and 4 in front.
  EXPECT_EQ(steps({{0, 1}, {1, 2}, {2, 0}, {3, 0}, {2, 4}}, {0, 0, 0, 9, -9}), "3 0 1 2 0! 4 ");
}

TEST(DrawingOrder, LongChainsAndLargeCyclesNeedNoDeepStack) {
  constexpr std::uint32_t kLong = 100'000;
  std::vector<Overlap> chain;
  for (std::uint32_t i = 0; i + 1 < kLong; ++i) chain.push_back({i + 1, i});
  const std::vector<double> farthest(kLong, 0.0);
  const std::vector<std::uint8_t> drawn(kLong, 1);
  const auto order = drawing_order(chain, farthest, drawn);
  ASSERT_EQ(order.size(), kLong);
  EXPECT_EQ(order.front().polygon, kLong - 1);
  chain.push_back({0, kLong - 1});
  EXPECT_EQ(drawing_order(chain, farthest, drawn).size(), kLong + 1);
}

/// A vector device that keeps, at every pixel centre, which polygon was drawn last, and counts.
class Canvas : public VectorDevice {
 public:
  Canvas(int width, int height)
      : VectorDevice(width, height),
        width_(width),
        height_(height),
        ids(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), -1) {}

 private:
  void open_group(int) override {
    EXPECT_FALSE(open_);
    open_ = true;
  }
  void close_group() override { open_ = false; }
  void paint_fill(const Path& path, const Colour& colour, bool,
                  std::span<const PixelBox> within) override {
    EXPECT_TRUE(open_);
    ++fills;
    mended += within.empty() ? 0 : 1;
    const int id =
        static_cast<int>(std::lround(colour.r * 255.0) * 65536 +
                         std::lround(colour.g * 255.0) * 256 + std::lround(colour.b * 255.0));
    std::vector<std::uint8_t> allowed(ids.size(), within.empty() ? 1 : 0);
    for (const PixelBox& b : within) {
      for (int row = b.first_row; row < b.end_row; ++row) {
        for (int i = b.first_column; i < b.end_column; ++i) allowed[index(i, row)] = 1;
      }
    }
    for (int row = 0; row < height_; ++row) {
      std::vector<double> crossings = crossings_of(path, row);
      for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
        const int first = std::max(0, static_cast<int>(std::ceil(crossings[k] - 0.5)));
        const int end = std::min(width_, static_cast<int>(std::ceil(crossings[k + 1] - 0.5)));
        for (int i = first; i < end; ++i) {
          if (allowed[index(i, row)] != 0) ids[index(i, row)] = id;
        }
      }
    }
  }
  void paint_figure(const Figure&) override {}
  void paint_text(const ViewedText&, const Point2&, double) override {}
  void paint_lines(const Path& path, const LineStyle&, LineKinds) override {
    EXPECT_TRUE(open_);
    for (std::size_t i = 0; i < path.runs.size(); ++i) {
      const auto run = path.run(i);
      for (std::size_t k = 1; k < run.size(); ++k) lines.push_back({run[k - 1], run[k]});
      if (path.runs[i].closed) lines.push_back({run.back(), run.front()});
      closed += path.runs[i].closed ? 1 : 0;
    }
  }

  std::vector<double> crossings_of(const Path& path, int row) const {
    const double y = height_ - (row + 0.5);
    std::vector<double> crossings;
    Point2 a = path.points.back();
    for (const Point2& b : path.points) {
      if ((a.y <= y) != (b.y <= y))
        crossings.push_back(a.x + (y - a.y) * (b.x - a.x) / (b.y - a.y));
      a = b;
    }
    std::ranges::sort(crossings);
    return crossings;
  }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(height_ - 1 - row) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(column);
  }

  int width_, height_;
  bool open_ = false;

 public:
  std::vector<std::int32_t> ids;
  int fills = 0, mended = 0, closed = 0;
  std::vector<std::array<Point2, 2>> lines;
};

Canvas drawn(const GraphicsSystem& g, int width, int height) {
  Canvas canvas(width, height);
  draw_in_visible_order(g.display_file(), width, height, canvas);
  return canvas;
}

/// How many pixels differ from the z-buffer's.
std::size_t wrong_pixels(const GraphicsSystem& g, const Canvas& canvas, int width, int height) {
  RasterRequest request;
  request.width = width;
  request.height = height;
  request.method = HiddenMethod::z_buffer;
  request.ids = true;
  const Picture picture = draw_with_software(g.display_file(), request);
  return different(picture.ids, canvas.ids);
}

TEST(VisibleOrder, EveryPixelCentreShowsWhatTheZBufferShows) {
  struct Scene {
    int polygons;
    double size;
    std::size_t sides;
    int width, height;
  };
  for (const Scene& s :
       {Scene{50, 0.5, 3, 100, 100}, Scene{300, 0.3, 3, 200, 130}, Scene{2000, 0.02, 3, 150, 150},
        Scene{60, 0.5, 7, 100, 100}, Scene{500, 0.6, 4, 64, 64}, Scene{3, 0.9, 3, 1, 1}}) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
      GraphicsSystem g = unit_square_without_lines();
      enter_random(g, seed, s.polygons, s.size, s.sides);
      const Canvas canvas = drawn(g, s.width, s.height);
      EXPECT_EQ(wrong_pixels(g, canvas, s.width, s.height), 0u)
          << s.polygons << " polygons, seed " << seed;
    }
  }
}

TEST(VisibleOrder, OfEquallyNearPolygonsTheLaterIsSeen) {
  GraphicsSystem g = unit_square_without_lines();
  g.open_segment(1);
  for (const int id : {1, 2, 3}) enter(g, id, {{0, 0, .5}, {1, 0, .5}, {1, 1, .5}, {0, 1, .5}});
  enter(g, 4, {{0, 0, .5}, {.5, 0, .5}, {.5, 1, .5}, {0, 1, .5}});
  g.close_segment();
  const Canvas canvas = drawn(g, 10, 10);
  EXPECT_EQ(wrong_pixels(g, canvas, 10, 10), 0u);
  EXPECT_EQ(canvas.ids[0], 4);
  EXPECT_EQ(canvas.ids[9], 3);
  EXPECT_EQ(canvas.fills, 2);  // nothing is seen of the others
}

TEST(VisibleOrder, APolygonOnAnothersPlaneIsDrawnOverItWhole) {
  GraphicsSystem g = unit_square_without_lines();
  g.open_segment(1);
  const auto on_plane = [](double x, double y) { return Point3(x, y, .125 + x / 2 + y / 4); };
  enter(g, 1, {on_plane(0, 0), on_plane(1, 0), on_plane(1, 1), on_plane(0, 1)});
  enter(g, 2, {on_plane(.25, .125), on_plane(.875, .25), on_plane(.5, .75)});
  g.close_segment();
  const Canvas canvas = drawn(g, 100, 100);
  EXPECT_EQ(wrong_pixels(g, canvas, 100, 100), 0u);
  EXPECT_EQ(canvas.fills, 2);
}

TEST(VisibleOrder, CyclicOverlapMendsOne) {
  const GraphicsSystem g = cyclic_overlap();
  const Canvas canvas = drawn(g, 200, 200);
  EXPECT_EQ(wrong_pixels(g, canvas, 200, 200), 0u);
  EXPECT_EQ(canvas.mended, 1);
  EXPECT_EQ(canvas.fills, 4);
}

TEST(VisibleOrder, OfACubeThreeFacesAreDrawnAndNineEdges) {
  GraphicsSystem g = unit_square_without_lines();
  g.set_line_style(line(kBlack));
  enter_cube(g);
  const Canvas canvas = drawn(g, 200, 200);
  EXPECT_EQ(wrong_pixels(g, canvas, 200, 200), 0u);
  EXPECT_EQ(canvas.fills, 3);
  EXPECT_EQ(canvas.mended, 0);
  EXPECT_EQ(canvas.closed, 3);  // the seen faces' outlines, whole
  double drawn_length = 0.0, outlines = 0.0;
  for (const auto& [a, b] : canvas.lines) {
    drawn_length += std::hypot(b.x - a.x, b.y - a.y);
  }
  // The hidden faces' share of it: only their edges on the outline, which are seen.
  for (const auto& [a, b] : canvas.lines) {
    for (const Point2& p : {a, b}) {
      const int i = static_cast<int>(p.x), j = static_cast<int>(p.y);
      bool near_background = false, near_face = false;
      for (int y = std::max(0, j - 2); y <= std::min(199, j + 2); ++y) {
        for (int x = std::max(0, i - 2); x <= std::min(199, i + 2); ++x) {
          near_background =
              near_background || canvas.ids[static_cast<std::size_t>(y * 200 + x)] < 0;
          near_face = near_face || canvas.ids[static_cast<std::size_t>(y * 200 + x)] >= 0;
        }
      }
      EXPECT_TRUE(near_face);
      outlines += near_background ? 1.0 : 0.0;
    }
  }
  EXPECT_GT(outlines, 6.0);
  EXPECT_GT(drawn_length, 9 * 40.0);
}

TEST(VisibleOrder, PicturesLargerThanABandAreTheSame) {
  // Wider than high: the z-buffer is found in several bands, and polygons, cycles and lines cross
  // their borders.
  GraphicsSystem g = unit_square_without_lines();
  enter_random(g, 3, 15, 0.5, 3);
  g.open_segment(9);
  g.set_line_style(line(kBlack));
  g.move_abs_3(0.1, 0, 0.5);
  g.line_abs_3(0.9, 1, 0.5);
  g.close_segment();
  const int width = 20'000, height = 450;
  const Canvas canvas = drawn(g, width, height);
  EXPECT_EQ(wrong_pixels(g, canvas, width, height), 0u);
  EXPECT_GT(canvas.mended, 0);
  // The line's parts follow each other, and each end lies where a fill and the line meet.
  ASSERT_GT(canvas.lines.size(), 1u);
  for (std::size_t i = 1; i < canvas.lines.size(); ++i) {
    EXPECT_LT(canvas.lines[i - 1][1].x, canvas.lines[i][0].x);
  }
}

// ---- Lines and the z-buffer ------------------------------------------------------------

TEST(VisibleOrder, ALineIsCutWhereAFillHidesIt) {
  GraphicsSystem g = unit_square_without_lines();
  g.open_segment(1);
  enter(g, 1, {{.3, .2, .6}, {.7, .2, .6}, {.7, .8, .6}, {.3, .8, .6}});
  g.set_line_style(line(kBlack));
  const auto parts = [&](int name, const Point3& from, const Point3& to) {
    g.close_segment();
    g.open_segment(name);
    g.move_abs_3(from.x, from.y, from.z);
    g.line_abs_3(to.x, to.y, to.z);
    std::string text;
    g.close_segment();
    for (const auto& [a, b] : drawn(g, 100, 100).lines) {
      text += fmt::format("{}-{} ", std::lround(a.x * 10.0), std::lround(b.x * 10.0));
    }
    g.delete_segment(name);
    g.open_segment(name);
    return text;  // in tenths of a pixel
  };
  EXPECT_EQ(parts(2, {.1, .45, .2}, {.9, .45, .2}), "100-300 700-900 ");  // behind
  EXPECT_EQ(parts(3, {.1, .45, .9}, {.9, .45, .9}), "100-900 ");          // in front
  EXPECT_EQ(parts(4, {.1, .45, .6}, {.9, .45, .6}), "100-900 ");          // on it: the line wins
  EXPECT_EQ(parts(5, {.1, .45, .2}, {.9, .45, 1.}), "100-300 500-900 ");  // through it
  EXPECT_EQ(parts(6, {.35, .45, .2}, {.65, .45, .2}), "");
}

TEST(VisibleOrder, DashesLieWhereTheyWouldIfAllWereSeen) {
  GraphicsSystem g = unit_square_without_lines();
  g.open_segment(1);
  enter(g, 1, {{.33, .2, .6}, {.72, .2, .6}, {.72, .8, .6}, {.33, .8, .6}});
  g.set_line_style({LineStyle::Kind::dashed, kBlack, 1.0, 10.0, 5.0});
  g.move_abs_3(0, .45, .2);
  g.line_abs_3(1, .45, .2);
  g.close_segment();
  std::string text;
  for (const auto& [a, b] : drawn(g, 100, 100).lines) {
    text += fmt::format("{}-{} ", std::lround(a.x), std::lround(b.x));
  }
  EXPECT_EQ(text, "0-10 15-25 30-33 75-85 90-100 ");
}

TEST(VisibleOrder, AMeshFinerThanThePixelsHidesLines) {
  GraphicsSystem g = unit_square_without_lines();
  g.open_segment(1);
  constexpr int kSide = 150;  // on 40 pixels: triangles of a quarter of a pixel
  const auto point = [](int i, int j) {
    const double x = static_cast<double>(i) / kSide, y = static_cast<double>(j) / kSide;
    return Point3(.2 + .6 * x, .2 + .6 * y, .6 + .1 * std::sin(3 * x) * std::cos(2 * y));
  };
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      enter(g, 1, {point(i, j), point(i + 1, j), point(i + 1, j + 1)});
      enter(g, 1, {point(i, j), point(i + 1, j + 1), point(i, j + 1)});
    }
  }
  g.set_line_style(line(kBlack));
  g.move_abs_3(.25, .3, .2);
  g.line_abs_3(.75, .71, .2);
  g.close_segment();
  EXPECT_EQ(drawn(g, 40, 40).lines.size(), 0u);
}

TEST(VisibleOrder, EdgesOfAFineMeshAreNotHiddenByItself) {
  GraphicsSystem g = unit_square_without_lines();
  g.set_line_style(line(kBlack, 0.1));
  g.open_segment(1);
  constexpr int kSide = 40;
  double length = 0.0;
  const auto point = [](int i, int j) {  // a dome
    const double x = 2.0 * i / kSide - 1.0, y = 2.0 * j / kSide - 1.0;
    return Point3(.5 + .4 * x, .5 + .4 * y, .9 - .2 * (x * x + y * y));
  };
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      const std::vector<Point3> triangle{point(i, j), point(i + 1, j), point(i, j + 1)};
      enter(g, 1, triangle);
      for (std::size_t k = 0; k < 3; ++k) {
        const Point3 d = 80.0 * (triangle[k] - triangle[(k + 1) % 3]);
        length += std::hypot(d.x, d.y);
      }
      enter(g, 1, {point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)});
    }
  }
  g.close_segment();
  double seen = 0.0;
  for (const auto& [a, b] : drawn(g, 80, 80).lines) seen += std::hypot(b.x - a.x, b.y - a.y);
  EXPECT_GT(seen, 1.99 * length);  // both triangles of each square
}

}  // namespace
}  // namespace displayfile
