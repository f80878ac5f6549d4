// Vector output: what an SVG file holds, and that SVG and PDF, drawn by somebody else, show the
// picture that the z-buffer shows.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <random>
#include <sstream>
#include <string>

#include "clip/error.h"
#include "displayfile/graphics_system.h"
#include "interp/drawing_order.h"
#include "interp/interpreter.h"
#include "interp/pdf_device.h"
#include "interp/png_file.h"
#include "interp/scan_convert.h"
#include "interp/software.h"
#include "interp/svg_device.h"
#include "interp/visible_order.h"

namespace displayfile {
namespace {

namespace fs = std::filesystem;

const Colour kRed{1, 0, 0}, kGreen{0, 1, 0}, kBlue{0, 0, 1}, kBlack{0, 0, 0};

FillStyle solid(const Colour& colour) { return {FillStyle::Kind::solid, colour}; }
LineStyle line(const Colour& colour, double width = 1.0) {
  return {LineStyle::Kind::solid, colour, width};
}
const LineStyle kNoLine{LineStyle::Kind::none};

/// World x and y are device x and y, and z is depth: nearer is larger.
GraphicsSystem unit_square() {
  GraphicsSystem g;
  g.set_window(0, 1, 0, 1);
  g.set_view_depth(-1, 0);
  g.set_line_style(kNoLine);
  return g;
}

std::string content(const fs::path& path) {
  std::ostringstream all;
  all << std::ifstream(path, std::ios::binary).rdbuf();
  return all.str();
}

template <class Call>
std::string error_of(Call&& call) {
  try {
    call();
  } catch (const Error& e) {
    return e.what();
  }
  return {};
}

std::size_t count(const std::string& text, std::string_view part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

/// A folder of its own for each test, gone afterwards.
class VectorFile : public testing::Test {
 protected:
  VectorFile() {
    folder_ = fs::path(testing::TempDir()) /
              ("vector_file_" + std::to_string(::getpid()) + "_" +
               testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_);
  }
  ~VectorFile() override { fs::remove_all(folder_); }
  fs::path file(const std::string& name) const { return folder_ / name; }
  bool empty_folder() const { return fs::is_empty(folder_); }

  std::string svg(const GraphicsSystem& g, int width, int height, bool z_buffer) const {
    write_svg(g.display_file(), width, height, z_buffer, file("a.svg"));
    return content(file("a.svg"));
  }

 private:
  fs::path folder_;
};

std::string body(const std::string& svg) { return svg.substr(svg.find("<rect")); }

// ---- What an SVG file holds ------------------------------------------------------------

TEST_F(VectorFile, SvgOfASmallScene) {
  GraphicsSystem g = unit_square();
  g.open_segment(3);
  g.set_fill_style(solid({1.0, 0.5, 0.0}));
  g.set_line_style(line(kBlack, 1.5));
  g.polygon_abs_2({{0.1, 0.1}, {0.5, 0.1}, {0.5, 0.5}, {0.1, 0.5}});  // with its edges
  g.set_line_style(kNoLine);
  g.polygon_abs_2({{0.1, 0.6}, {0.5, 0.6}, {1.0 / 3.0, 0.9}});  // without: seams are closed
  g.close_segment();
  g.open_segment(1);
  g.set_line_style({LineStyle::Kind::dashed, kBlue, 2.0, 6.0, 4.0});
  g.move_abs_2(0.0, 0.25);
  g.line_abs_2(1.0, 0.25);
  g.line_abs_2(1.0, 1.0);  // continues the line: one path
  g.move_abs_2(0.5, 0.5);
  g.line_abs_2(0.5, 0.5);  // a dot
  g.close_segment();
  EXPECT_EQ(svg(g, 200, 100, false),
            R"(<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" version="1.1" width="200" height="100" viewBox="0 0 200 100">
<style>
.background{fill:#ffffff}
.segment{fill:none;fill-rule:evenodd;stroke-width:0.75;stroke-linejoin:round}
.f1{fill:#ff8000}
.f2{fill:#ff8000;stroke:#ff8000}
.l1{stroke:#000000;stroke-width:1.5}
.l2{stroke:#0000ff;stroke-width:2;stroke-dasharray:6 4}
</style>
<rect class="background" width="200" height="100"/>
<g id="segment-3" class="segment">
<path class="f1 l1" d="M20,50 20,90 100,90 100,50Z"/>
<path class="f2" d="M66.667,10 20,40 100,40Z"/>
</g>
<g id="segment-1" class="segment">
<path class="l2" d="M0,75 200,75 200,0"/>
<path class="l2" stroke-linecap="square" d="M100,50 100,50"/>
</g>
</svg>
)");
}

TEST_F(VectorFile, NothingAndInvisibleSegmentsMakeAnEmptyPicture) {
  GraphicsSystem g = unit_square();
  g.open_segment(1);
  g.polygon_abs_2({{0, 0}, {1, 0}, {1, 1}});
  g.close_segment();
  g.set_visibility(1, false);
  for (const bool z_buffer : {false, true}) {
    EXPECT_EQ(body(svg(g, 10, 10, z_buffer)),
              "<rect class=\"background\" width=\"10\" height=\"10\"/>\n</svg>\n");
  }
}

TEST(SvgDevice, AGroupOpenedAgainHasAnIdOfItsOwn) {
  SvgDevice device(10, 10);
  for (const int name : {1, 12, 1, 1}) {
    device.begin_segment(name);
    device.end_segment();
  }
  std::ostringstream out;
  device.finish(out);
  for (const char* id : {"\"segment-1\"", "\"segment-12\"", "\"segment-1-2\"", "\"segment-1-3\""}) {
    EXPECT_EQ(count(out.str(), id), 1u) << id;
  }
}

/// Draws one polygon on an SVG device of 100 x 100.
std::string svg_of(const std::vector<Point3>& vertices, const std::vector<std::int32_t>& sides,
                   const LineStyle& style = line(kBlack)) {
  SvgDevice device(100, 100);
  const FillStyle fill = solid(kRed);
  const DrawnPolygon polygon{vertices, sides, fill, style, 0};
  device.begin_segment(1);
  device.fill(polygon);
  device.edges(polygon);
  device.end_segment();
  std::ostringstream out;
  device.finish(out);
  return body(out.str());
}

const std::vector<Point3> kSquare{{.2, .2, 0}, {.8, .2, 0}, {.8, .8, 0}, {.2, .8, 0}};

TEST(SvgDevice, OnlyVisibleSidesAreDrawn) {
  // The sides that end at the second and the fourth vertex.
  const std::string svg = svg_of(kSquare, {op::move, op::line, op::move, op::line});
  EXPECT_EQ(count(svg, "class=\"l1\" d=\"M20,80 80,80M80,20 20,20\""), 1u) << svg;
  // A run goes on over the polygon's first vertex.
  const std::string three = svg_of(kSquare, {op::line, op::line, op::move, op::line});
  EXPECT_EQ(count(three, "class=\"l1\" d=\"M80,20 20,20 20,80 80,80\""), 1u) << three;
  EXPECT_EQ(count(svg_of(kSquare, {op::move, op::move, op::move, op::move}), "<path"), 1u);
}

TEST(SvgDevice, SeamsAreClosedWhereEdgesDoNotCoverThem) {
  const std::vector<std::int32_t> all(4, op::line);
  SvgDevice device(10, 10);
  const auto style_of_fill = [&](const LineStyle& style, const std::vector<std::int32_t>& sides) {
    SvgDevice one(100, 100);
    const FillStyle fill = solid(kRed);
    one.fill({kSquare, sides, fill, style, 0});
    std::ostringstream out;
    one.finish(out);
    return count(out.str(), ".f1{fill:#ff0000;stroke:#ff0000}");
  };
  EXPECT_EQ(style_of_fill(line(kBlack), all), 0u);
  EXPECT_EQ(style_of_fill(line(kBlack), {op::line, op::move, op::line, op::line}), 1u);
  EXPECT_EQ(style_of_fill(line(kBlack, 0.1), all), 1u);
  EXPECT_EQ(style_of_fill({LineStyle::Kind::dashed}, all), 1u);
  EXPECT_EQ(style_of_fill(kNoLine, all), 1u);
}

TEST(SvgDevice, EdgeOnAndNotFinitePolygonsAreLeftOut) {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<std::int32_t> none(3, op::move);
  EXPECT_EQ(count(svg_of({{.1, .1, 0}, {.5, .5, 1}, {.9, .9, 0}}, none), "<path"), 0u);
  EXPECT_EQ(count(svg_of({{.1, .1, 0}, {infinity, .5, 1}, {.9, .9, 0}}, none), "<path"), 0u);
  EXPECT_EQ(count(svg_of({{.1, .1, 0}, {.5, std::nan(""), 1}, {.9, .1, 0}},
                         std::vector<std::int32_t>(3, op::line)),
                  "nan"),
            0u);
}

TEST_F(VectorFile, FarCoordinatesAreCutOffOutsideOfThePicture) {
  GraphicsSystem g = unit_square();
  g.open_segment(1);
  g.set_line_style(line(kBlack));
  g.polygon_abs_2({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  g.move_abs_2(0, 0);
  g.line_abs_2(1, 1);
  g.close_segment();
  g.set_image_scale(1, 1e90, 1e90);
  for (const bool z_buffer : {false, true}) {
    const std::string text = body(svg(g, 100, 100, z_buffer));
    EXPECT_GE(count(text, "class=\"l1\""), 1u);
    EXPECT_EQ(count(text, "class=\"f1\""), 1u);
    std::istringstream numbers(text);
    for (char c; numbers.get(c);) {
      if (c < '0' || c > '9') continue;
      numbers.unget();
      double v = 0.0;
      numbers >> v;
      ASSERT_LE(v, 32767.0) << text;
    }
  }
}

TEST_F(VectorFile, BadSizesAndPathsAreErrorsAndLeaveNothing) {
  GraphicsSystem g = unit_square();
  const DisplayFile& d = g.display_file();
  for (const auto& size : {std::pair{0, 0}, {0, 5}, {5, -1}, {70000, 5}, {5, 1000000}}) {
    const int w = size.first, h = size.second;
    EXPECT_FALSE(error_of([&] { write_svg(d, w, h, true, file("a.svg")); }).empty());
    EXPECT_FALSE(error_of([&] { write_pdf(d, w, h, false, file("a.pdf")); }).empty());
  }
  const fs::path nowhere = file("no-such-folder") / "a";
  EXPECT_NE(error_of([&] { write_svg(d, 9, 9, false, nowhere); }).find(nowhere), std::string::npos);
  EXPECT_NE(error_of([&] { write_pdf(d, 9, 9, false, nowhere); }).find(nowhere), std::string::npos);
  EXPECT_TRUE(empty_folder());
}

TEST_F(VectorFile, FullDiskIsAnError) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  GraphicsSystem g = unit_square();
  EXPECT_NE(error_of([&] { write_svg(g.display_file(), 9, 9, false, "/dev/full"); }), "");
  EXPECT_NE(error_of([&] { write_pdf(g.display_file(), 9, 9, false, "/dev/full"); }), "");
}

TEST_F(VectorFile, PdfBytesDependOnTheDrawingAlone) {
  GraphicsSystem g = unit_square();
  g.open_segment(1);
  g.polygon_abs_2({{0, 0}, {1, 0}, {1, 1}});
  g.close_segment();
  write_pdf(g.display_file(), 300, 200, false, file("a.pdf"));
  const std::string pdf = content(file("a.pdf"));
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  EXPECT_EQ(count(pdf, "/CreationDate (20000101"), 1u);
  EXPECT_EQ(count(pdf, "/MediaBox [ 0 0 300 200 ]"), 1u);
  write_pdf(g.display_file(), 300, 200, false, file("b.pdf"));
  EXPECT_EQ(content(file("b.pdf")), pdf);
}

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
                  std::span<const PixelBlock> within) override {
    EXPECT_TRUE(open_);
    ++fills;
    mended += within.empty() ? 0 : 1;
    const int id =
        static_cast<int>(std::lround(colour.r * 255.0) * 65536 +
                         std::lround(colour.g * 255.0) * 256 + std::lround(colour.b * 255.0));
    std::vector<std::uint8_t> allowed(ids.size(), within.empty() ? 1 : 0);
    for (const PixelBlock& b : within) {
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
  void paint_lines(const Path& path, const LineStyle&) override {
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

/// The colour by which Canvas knows a polygon.
FillStyle numbered(int id) {
  return solid({(id / 65536) / 255.0, (id / 256 % 256) / 255.0, (id % 256) / 255.0});
}

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
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < canvas.ids.size(); ++i) wrong += picture.ids[i] != canvas.ids[i];
  return wrong;
}

void enter(GraphicsSystem& g, int id, const std::vector<Point3>& vertices) {
  g.set_fill_style(numbered(id));
  g.set_pick_id(id);
  g.polygon_abs_3(vertices);
}

void enter_random(GraphicsSystem& g, unsigned seed, int n, double size, std::size_t sides) {
  std::mt19937 random(seed);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };
  g.open_segment(1);
  for (int id = 0; id < n; ++id) {
    if (id == n / 2) {
      g.close_segment();
      g.open_segment(2);
    }
    // On a random plane, so that more than three sides are flat too.
    const Point3 middle{uniform(0, 1), uniform(0, 1), uniform(0.2, 0.8)};  // braces: in this order
    const double slope_x = uniform(-1, 1), slope_y = uniform(-1, 1);
    std::vector<Point3> vertices;
    for (std::size_t k = 0; k < sides; ++k) {
      const double dx = uniform(-size, size), dy = uniform(-size, size);
      vertices.push_back(middle + Point3(dx, dy, 0.2 * (slope_x * dx + slope_y * dy)));
    }
    enter(g, id, vertices);
  }
  g.close_segment();
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
      GraphicsSystem g = unit_square();
      enter_random(g, seed, s.polygons, s.size, s.sides);
      const Canvas canvas = drawn(g, s.width, s.height);
      EXPECT_EQ(wrong_pixels(g, canvas, s.width, s.height), 0u)
          << s.polygons << " polygons, seed " << seed;
    }
  }
}

TEST(VisibleOrder, OfEquallyNearPolygonsTheLaterIsSeen) {
  GraphicsSystem g = unit_square();
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
  GraphicsSystem g = unit_square();
  g.open_segment(1);
  const auto on_plane = [](double x, double y) { return Point3(x, y, .125 + x / 2 + y / 4); };
  enter(g, 1, {on_plane(0, 0), on_plane(1, 0), on_plane(1, 1), on_plane(0, 1)});
  enter(g, 2, {on_plane(.25, .125), on_plane(.875, .25), on_plane(.5, .75)});
  g.close_segment();
  const Canvas canvas = drawn(g, 100, 100);
  EXPECT_EQ(wrong_pixels(g, canvas, 100, 100), 0u);
  EXPECT_EQ(canvas.fills, 2);
}

/// Three bars, each over the next.
GraphicsSystem cyclic_overlap() {
  GraphicsSystem g = unit_square();
  g.open_segment(1);
  const auto bar = [&](int id, double angle) {
    std::vector<Point3> vertices;
    for (const auto& [x, y, z] :
         {std::tuple{-.45, -.25, .2}, {.45, -.25, .8}, {.45, -.1, .8}, {-.45, -.1, .2}}) {
      const double c = std::cos(angle), s = std::sin(angle);
      vertices.emplace_back(.5 + c * x - s * y, .5 + s * x + c * y, z);
    }
    enter(g, id, vertices);
  };
  for (const int k : {0, 1, 2})
    bar(k == 0 ? 0xff0000 : k == 1 ? 0x00ff00 : 0x0000ff, k * 2.0943951);
  g.close_segment();
  return g;
}

TEST(VisibleOrder, CyclicOverlapMendsOne) {
  const GraphicsSystem g = cyclic_overlap();
  const Canvas canvas = drawn(g, 200, 200);
  EXPECT_EQ(wrong_pixels(g, canvas, 200, 200), 0u);
  EXPECT_EQ(canvas.mended, 1);
  EXPECT_EQ(canvas.fills, 4);
}

/// Faces turned both ways: nothing is left out before the order is sought.
void enter_cube(GraphicsSystem& g) {
  g.open_segment(1);
  const double c1 = std::cos(.6), s1 = std::sin(.6), c2 = std::cos(.7), s2 = std::sin(.7);
  const auto corner = [&](int i) {
    const double x = (i & 1) ? .25 : -.25, y = (i & 2) ? .25 : -.25, z = (i & 4) ? .25 : -.25;
    const double x1 = c1 * x + s1 * z, z1 = c1 * z - s1 * x;
    return Point3(.5 + x1, .5 + c2 * y - s2 * z1, .5 + c2 * z1 + s2 * y);
  };
  const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  int id = 0;
  for (const auto& face : faces) {
    enter(g, ++id * 40, {corner(face[0]), corner(face[1]), corner(face[2]), corner(face[3])});
  }
  g.close_segment();
}

TEST(VisibleOrder, OfACubeThreeFacesAreDrawnAndNineEdges) {
  GraphicsSystem g = unit_square();
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
  GraphicsSystem g = unit_square();
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
  GraphicsSystem g = unit_square();
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
  GraphicsSystem g = unit_square();
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
  GraphicsSystem g = unit_square();
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
  GraphicsSystem g = unit_square();
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

// ---- Drawn by somebody else ------------------------------------------------------------

bool have(const std::string& tool) {
  return std::system(("command -v " + tool + " > /dev/null 2>&1").c_str()) == 0;
}

Picture rasterised(const fs::path& file) {
  const std::string command =
      file.extension() == ".svg"
          ? fmt::format("rsvg-convert '{0}' -o '{0}.png'", file.string())
          : fmt::format("pdftoppm -r 72 -png -singlefile '{0}' '{0}'", file.string());
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  return read_png(file.string() + ".png");
}

/// Runs with each format for which there is a program that draws it.
class Rasterised : public VectorFile, public testing::WithParamInterface<const char*> {
 protected:
  void SetUp() override {
    const std::string tool = svg_format() ? "rsvg-convert" : "pdftoppm";
    if (!have(tool)) GTEST_SKIP() << tool << " is not installed";
  }
  bool svg_format() const { return std::string(GetParam()) == "svg"; }
  Picture draw(const GraphicsSystem& g, int width, int height, bool z_buffer) const {
    const fs::path path = file(std::string("a.") + GetParam());
    (svg_format() ? write_svg : write_pdf)(g.display_file(), width, height, z_buffer, path);
    const Picture picture = rasterised(path);
    EXPECT_EQ(picture.width, width);
    EXPECT_EQ(picture.height, height);
    return picture;
  }
};
INSTANTIATE_TEST_SUITE_P(Vector, Rasterised, testing::Values("svg", "pdf"),
                         [](const auto& format) { return std::string(format.param); });

std::uint32_t at(const Picture& picture, double x, double y) {
  const auto column = static_cast<std::size_t>(x * picture.width);
  const auto row = static_cast<std::size_t>((1.0 - y) * picture.height);
  return picture.pixels[row * static_cast<std::size_t>(picture.width) + column];
}

int channel_difference(std::uint32_t a, std::uint32_t b) {
  int largest = 0;
  for (unsigned shift = 0; shift < 24; shift += 8) {
    largest = std::max(largest, std::abs(static_cast<int>((a >> shift) & 255) -
                                         static_cast<int>((b >> shift) & 255)));
  }
  return largest;
}

/// Compares where the z-buffer's picture has one colour two pixels around: neither antialiasing
/// nor the lines that close seams reach there. Returns how many pixels were compared. What is
/// thinner than a pixel may run there unseen by the z-buffer; a scene that has it allows some.
int expect_the_z_buffers_colours(const GraphicsSystem& g, const Picture& picture, int allowed = 0) {
  RasterRequest request;
  request.width = picture.width;
  request.height = picture.height;
  request.method = HiddenMethod::z_buffer;
  const Picture expected = draw_with_software(g.display_file(), request);
  int compared = 0, wrong = 0;
  for (int y = 2; y < picture.height - 2; ++y) {
    for (int x = 2; x < picture.width - 2; ++x) {
      const auto pixel = [&](int dx, int dy) {
        return expected.pixels[static_cast<std::size_t>((y + dy) * picture.width + x + dx)];
      };
      bool flat = true;
      for (int dy = -2; dy <= 2; ++dy) {
        for (int dx = -2; dx <= 2; ++dx) flat = flat && pixel(dx, dy) == pixel(0, 0);
      }
      if (!flat) continue;
      ++compared;
      const auto here = picture.pixels[static_cast<std::size_t>(y * picture.width + x)];
      wrong += channel_difference(here, pixel(0, 0)) > 1 ? 1 : 0;
    }
  }
  EXPECT_LE(wrong, allowed);
  return compared;
}

TEST_P(Rasterised, ColoursAndPlacesAreRight) {
  GraphicsSystem g = unit_square();
  g.open_segment(1);
  g.set_fill_style(solid({1.0, 0.5, 0.0}));
  g.polygon_abs_2({{0, 0}, {.5, 0}, {.5, .5}, {0, .5}});
  g.set_fill_style(solid(kBlue));
  g.polygon_abs_2({{.6, .6},
                   {.9, .6},
                   {.9, .9},
                   {.6, .9},
                   {.6, .6},
                   {.7, .7},
                   {.7, .8},
                   {.8, .8},
                   {.8, .7},
                   {.7, .7}});  // a hole, even-odd
  g.set_line_style(line(kRed, 4.0));
  g.move_abs_2(0, .55);
  g.line_abs_2(1, .55);
  g.close_segment();
  const Picture p = draw(g, 200, 100, false);
  EXPECT_EQ(at(p, .25, .25), 0xff0080ffu);
  EXPECT_EQ(at(p, .01, .01), 0xff0080ffu);
  EXPECT_EQ(at(p, .65, .75), 0xffff0000u);
  EXPECT_EQ(at(p, .75, .75), 0xffffffffu);
  EXPECT_EQ(at(p, .5, .545), 0xff0000ffu);
  EXPECT_EQ(at(p, .5, .6), 0xffffffffu);
}

TEST_P(Rasterised, InterpenetratingTriangles) {
  GraphicsSystem g = unit_square();
  g.open_segment(1);
  enter(g, 0xff0000, {{.1, .1, .2}, {.9, .1, .8}, {.5, .9, .5}});  // z grows with x
  enter(g, 0x0000ff, {{.1, .1, .8}, {.9, .1, .2}, {.5, .9, .5}});  // z falls with x
  g.close_segment();
  const Picture p = draw(g, 200, 200, true);
  EXPECT_EQ(at(p, .55, .3), 0xff0000ffu);  // red in memory order
  EXPECT_EQ(at(p, .45, .3), 0xffff0000u);
  EXPECT_GT(expect_the_z_buffers_colours(g, p), 30'000);
}

TEST_P(Rasterised, CyclicOverlap) {
  const GraphicsSystem g = cyclic_overlap();
  EXPECT_GT(expect_the_z_buffers_colours(g, draw(g, 200, 200, true)), 20'000);
}

TEST_P(Rasterised, Cube) {
  GraphicsSystem g = unit_square();
  enter_cube(g);
  EXPECT_GT(expect_the_z_buffers_colours(g, draw(g, 200, 200, true)), 30'000);
}

TEST_P(Rasterised, ManyInterpenetratingPolygons) {
  GraphicsSystem g = unit_square();
  enter_random(g, 11, 30, 0.6, 4);
  EXPECT_GT(expect_the_z_buffers_colours(g, draw(g, 300, 300, true), 40), 50'000);
}

TEST_P(Rasterised, NoSeamsBetweenNeighbours) {
  // Black triangles around a point: of 30 edges in all directions none may show the white
  // background. Without the lines that close the seams, a quarter of it would shine through.
  GraphicsSystem g = unit_square();
  g.open_segment(1);
  g.set_fill_style(solid(kBlack));
  constexpr int kTriangles = 30;
  const auto rim = [](int k) {
    const double angle = 0.1 + 2.0 * 3.14159265358979 * k / kTriangles;
    return Point3(.503 + .45 * std::cos(angle), .501 + .45 * std::sin(angle), .5);
  };
  for (int k = 0; k < kTriangles; ++k) {
    g.polygon_abs_3({{.503, .501, .5}, rim(k), rim(k + 1)});
  }
  g.close_segment();
  for (const bool z_buffer : {false, true}) {
    const Picture p = draw(g, 200, 200, z_buffer);
    int lightest = 0;
    for (int y = 0; y < p.height; ++y) {
      for (int x = 0; x < p.width; ++x) {
        const double dx = (x + .5) / 200 - .503, dy = 1.0 - (y + .5) / 200 - .501;
        if (std::hypot(dx, dy) > .43) continue;
        const auto pixel = p.pixels[static_cast<std::size_t>(y * p.width + x)];
        lightest = std::max(lightest, static_cast<int>(pixel & 255));
      }
    }
    EXPECT_LE(lightest, 10);
  }
}

TEST_P(Rasterised, FarCoordinates) {
  GraphicsSystem g = unit_square();
  g.open_segment(1);
  g.set_fill_style(solid(kGreen));
  g.polygon_abs_2({{0, 0}, {1, 0}, {1, 1}});  // its long side runs through the picture's corners
  g.close_segment();
  g.set_image_scale(1, 1e12, 1e12);
  for (const bool z_buffer : {false, true}) {
    const Picture p = draw(g, 100, 100, z_buffer);
    EXPECT_EQ(at(p, .7, .3), 0xff00ff00u);
    EXPECT_EQ(at(p, .3, .7), 0xffffffffu);
  }
}

}  // namespace
}  // namespace displayfile
