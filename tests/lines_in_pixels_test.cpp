// Lines in pixels (interp/scan/lines.md): over the surfaces of every method they are the visible
// pieces that the truth of lines has (interp/truth/true_lines.h), painted here by a painter that
// shares no code with the one under test.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "displayfile/segments/hidden_surface_check.h"
#include "interp/device/raster_request.h"
#include "interp/draw/draw.h"
#include "interp/raster/software.h"
#include "interp/visibility/image_space.h"
#include "programs/scenes/generated_scenes.h"
#include "programs/scenes/hard_cases.h"
#include "programs/scenes/random_scenes.h"
#include "tests/gallery.h"
#include "tests/line_truth.h"
#include "tests/outlined.h"
#include "tests/slower.h"

namespace displayfile {
namespace {

using test::outlined;

const Colour kLine{1.0, 0.0, 1.0};
using Pieces = std::vector<LinePiece>;

/// One drawn line of a picture, in pixels.
struct WholeLineInPixels {
  Point2 from, to;
  double length() const { return std::hypot(to.x - from.x, to.y - from.y); }
};

struct Size {
  int width, height;
};

/// Which pixels lines have, top row first.
class SlowPainter {
 public:
  SlowPainter(const LineItems& items, const Size& size, double width)
      : items_(items),
        size_(size),
        width_(width),
        painted_(static_cast<std::size_t>(size.width * size.height), false) {}
  const std::vector<bool>& painted() const { return painted_; }

  /// Tests every pixel for the line.
  void draw(const LinePiece& piece) {
    const Point2 size(size_.width, size_.height);
    const WholeLineInPixels line{Point2(items_.from(piece.line)) * size,
                                 Point2(items_.to(piece.line)) * size};
    const bool steep = std::abs(line.to.y - line.from.y) > std::abs(line.to.x - line.from.x);
    for (int row = 0; row < size_.height; ++row) {
      for (int column = 0; column < size_.width; ++column) {
        const bool there = steep ? is_there({{line.from.y, line.from.x}, {line.to.y, line.to.x}},
                                            row, column, size_.height, size_.width, piece)
                                 : is_there(line, column, row, size_.width, size_.height, piece);
        if (!there) continue;
        const int at = (size_.height - 1 - row) * size_.width + column;
        painted_[static_cast<std::size_t>(at)] = true;
      }
    }
  }

 private:
  static double cell(double v, int limit) { return v == limit ? limit - 1.0 : std::floor(v); }

  /// For a line that is not steep.
  bool is_there(const WholeLineInPixels& line, int column, int row, int columns, int rows,
                const LinePiece& piece) const {
    if (width_ > 1.5) return is_in_wide({column + 0.5, row + 0.5}, line, piece);
    const bool turned = line.to.x < line.from.x;
    const Point2 low = turned ? line.to : line.from, high = turned ? line.from : line.to;
    if (column < cell(low.x, columns) || column > cell(high.x, columns)) return false;
    const double x = std::clamp(column + 0.5, low.x, high.x);
    const double t = high.x > low.x ? (x - low.x) / (high.x - low.x) : 0.0;
    const double y = low.y + t * (high.y - low.y);
    const double place = turned ? 1.0 - t : t;
    if (cell(y, rows) != row) return false;
    return place >= piece.from && place <= piece.to;
  }

  /// For a line that is not steep, with caps.
  bool is_in_wide(const Point2& centre, const WholeLineInPixels& line,
                  const LinePiece& piece) const {
    const double half = 0.5 * width_, length = line.length();
    const Point2 along = line.to - line.from, offset = centre - line.from;
    if (length == 0.0) return std::abs(offset.x) < half && std::abs(offset.y) < half;
    const double place = (offset.x * along.x + offset.y * along.y) / (length * length);
    const double above = offset.y - offset.x * along.y / along.x;
    const double upright = half * length / std::abs(along.x);
    if (above < -upright || above >= upright) return false;
    const Point2 to_end = centre - line.to;
    if (place < 0.0 && !(std::hypot(offset.x, offset.y) < half)) return false;
    if (place > 1.0 && !(std::hypot(to_end.x, to_end.y) < half)) return false;
    const double nearest = std::clamp(place, 0.0, 1.0);
    return nearest >= piece.from && nearest <= piece.to;
  }

  const LineItems& items_;
  Size size_;
  double width_;
  std::vector<bool> painted_;
};

/// The methods that find surfaces; world-ray-cast, which needs a retained scene, is tested apart.
std::vector<HiddenMethod> surface_methods() {
  std::vector<HiddenMethod> all{HiddenMethod::automatic, HiddenMethod::bsp,
                                HiddenMethod::depth_sort, HiddenMethod::plain_z_buffer,
                                HiddenMethod::plain_z_buffer_16};
  for (const ImageSpaceEntry& entry : image_space_methods()) all.push_back(entry.method);
  return all;
}

Picture drawn(const DisplayFile& file, HiddenMethod method, const Size& size, int threads,
              const Precision& precision = {}) {
  RasterRequest request;
  request.width = size.width;
  request.height = size.height;
  request.surfaces = {.method = method, .precision = precision, .threads = threads};
  request.crumbs = true;  // all that is seen
  if (!is_object_space(method)) return draw_with_software(file, request);
  DisplayFile sorted = file;
  sorted.set_sorted(
      hidden_surface_check(file.visible_segments(), {.method = method, .precision = precision}));
  request.sorted = precision.exact;
  return draw_with_software(sorted, request);
}

/// Describes the differences from the method's fills with these pieces over them; empty if there
/// are none.
std::string wrong_pixels(const DisplayFile& fills, const LineStyle& style, const Size& size,
                         const Pieces& pieces, const Precision& precision = {}) {
  const DisplayFile lines = outlined(fills, style);
  const DisplayFile bare = outlined(fills, {LineStyle::Kind::none});
  const LineItems items(lines);
  SlowPainter painter(items, size, style.width);
  for (const LinePiece& piece : pieces) painter.draw(piece);
  std::ostringstream wrong;
  for (const HiddenMethod method : surface_methods()) {
    Picture right;
    for (const int threads : {1, 2}) {
      // With a roundoff, fills may depend on where bands begin.
      if (threads == 1 || !precision.exact) right = drawn(bare, method, size, threads, precision);
      for (std::size_t i = 0; i < right.pixels.size(); ++i) {
        if (painter.painted()[i]) right.pixels[i] = pixel_of(style.colour);
      }
      const Picture picture = drawn(lines, method, size, threads, precision);
      long long pixels = 0;
      for (std::size_t i = 0; i < right.pixels.size(); ++i) {
        pixels += picture.pixels[i] != right.pixels[i];
      }
      if (pixels == 0) continue;
      wrong << name_of(method) << " on " << threads << " threads: " << pixels << " pixels\n";
    }
  }
  return wrong.str();
}

Pieces true_pieces(const DisplayFile& fills) {
  const LineItems items(outlined(fills, LineStyle{}));
  return visible_pieces(true_lines(items, items.drawn_lines()));
}

std::string wrong_pixels(const DisplayFile& fills, double width = 1.0,
                         const Size& size = {61, 47}) {
  return wrong_pixels(fills, {LineStyle::Kind::solid, kLine, width}, size, true_pieces(fills));
}

TEST(LinesInPixels, AreTheTruePiecesOverEveryMethodsSurfacesInHardCases) {
  for (const HardCase& hard : hard_cases()) {
    for (const double severity : {hard.severities.front(), hard.severities.back()}) {
      SCOPED_TRACE(std::string(hard.name) + " " + std::to_string(severity));
      const std::size_t n = std::min<std::size_t>(hard.size, 8);
      EXPECT_EQ(wrong_pixels(entered(hard.make(n, severity, 1)).display_file()), "");
    }
  }
}

TEST(LinesInPixels, AreTheTruePiecesInGeneratedScenes) {
  for (const GeneratedScene& scene : generated_scenes()) {
    SCOPED_TRACE(scene.name);
    EXPECT_EQ(wrong_pixels(entered(scene.make(30, 3)).display_file()), "");
  }
}

TEST(LinesInPixels, AreTheTruePiecesInRandomDegenerateScenes) {
  for (std::uint64_t seed = 0; seed < 100 / test::kSlower; ++seed) {
    SCOPED_TRACE(seed);
    const DisplayFile file = entered(random_degenerate_scene(seed)).display_file();
    EXPECT_EQ(wrong_pixels(file, seed % 2 == 0 ? 1.0 : 3.5), "");
  }
}

TEST(LinesInPixels, AreCutSquareIfTheyAreWide) {
  EXPECT_EQ(wrong_pixels(entered(generated_scene("cycles").make(12, 3)).display_file(), 5.0), "");
  EXPECT_EQ(wrong_pixels(entered(generated_scene("planes").make(12, 3)).display_file(), 7.0), "");
}

TEST(LinesInPixels, HaveTheRoundoffThatSurfacesHave) {
  const Precision roundoff{.exact = false, .roundoff = 0.1};
  const DisplayFile fills = entered(generated_scene("planes").make(20, 3)).display_file();
  const DisplayFile lines = outlined(fills, LineStyle{});
  const ViewedScene scene(lines);
  Pieces pieces;
  for (const VisiblePiece& piece :
       visible_lines(scene.primitives(), drawn_lines(scene.primitives()),
                     {.method = HiddenMethod::roberts, .precision = roundoff})
           .pieces) {
    pieces.push_back({{piece.item, piece.corner}, piece.from, piece.to});
  }
  EXPECT_NE(pieces, true_pieces(fills));
  EXPECT_EQ(wrong_pixels(fills, {LineStyle::Kind::solid, kLine}, {61, 47}, pieces, roundoff), "");
}

/// A line is the same whichever polygons hide parts of it: dashes lie where they lie on the whole.
TEST(LinesInPixels, DashesRunOnWhereALineIsHidden) {
  const auto make = [](bool with_fill, LineStyle::Kind kind) {
    DisplayFile file;
    Segment& segment = file.create(1);
    segment.set_style(LineStyle{LineStyle::Kind::none});
    segment.set_style(FillStyle{FillStyle::Kind::solid, {0.5, 0.5, 0.5}});
    const std::vector<std::uint8_t> none(4, 0);
    if (with_fill) {
      segment.enter_polygon(
          std::vector<Point3>{{0.23, 0, 0.9}, {0.37, 0, 0.9}, {0.41, 1, 0.9}, {0.2, 1, 0.9}}, none);
      segment.enter_polygon(
          std::vector<Point3>{{0.6, 0, 0.9}, {0.68, 0, 0.9}, {0.66, 1, 0.9}, {0.61, 1, 0.9}}, none);
    }
    segment.set_style(LineStyle{kind, kLine, 1.0, 5.0, 3.0});
    segment.enter_line({0.02, 0.1, 0.5}, {0.5, 0.3, 0.5});
    segment.enter_line({0.5, 0.3, 0.5}, {0.95, 0.2, 0.5});
    segment.set_style(FillStyle{FillStyle::Kind::hollow});
    segment.enter_polygon(std::vector<Point3>{{0.1, 0.5, 0.4}, {0.9, 0.55, 0.4}, {0.5, 0.9, 0.4}},
                          std::vector<std::uint8_t>(3, 1));
    return file;
  };
  const auto is_line = [](const Picture& picture) {
    std::vector<bool> there;
    for (const std::uint32_t pixel : picture.pixels) there.push_back(pixel == pixel_of(kLine));
    return there;
  };
  const Size size{120, 90};
  for (const HiddenMethod method : surface_methods()) {
    SCOPED_TRACE(name_of(method));
    const auto solid = is_line(drawn(make(true, LineStyle::Kind::solid), method, size, 1));
    const auto whole = is_line(drawn(make(false, LineStyle::Kind::dashed), method, size, 1));
    auto both = whole;
    for (std::size_t i = 0; i < both.size(); ++i) both[i] = solid[i] && whole[i];
    EXPECT_NE(both, whole);
    EXPECT_EQ(is_line(drawn(make(true, LineStyle::Kind::dashed), method, size, 2)), both);
  }
}

/// A side in line style none does not count as the line that others draw.
TEST(LinesInPixels, OfPolygonsThatShareASideTheOneThatDrawsItCounts) {
  DisplayFile file;
  Segment& segment = file.create(1);
  segment.set_style(FillStyle{FillStyle::Kind::solid, {0.5, 0.5, 0.5}});
  segment.set_style(LineStyle{LineStyle::Kind::none});
  segment.enter_polygon(std::vector<Point3>{{0.1, 0.1, 0}, {0.5, 0.1, 0}, {0.5, 0.9, 0}},
                        std::vector<std::uint8_t>(3, 1));
  segment.set_style(LineStyle{LineStyle::Kind::solid, kLine});
  segment.enter_polygon(std::vector<Point3>{{0.5, 0.9, 0}, {0.5, 0.1, 0}, {0.9, 0.1, 0}},
                        std::vector<std::uint8_t>{0, 1, 0});
  for (const HiddenMethod method : surface_methods()) {
    const Picture picture = drawn(file, method, {10, 10}, 1);
    EXPECT_EQ(std::ranges::count(picture.pixels, pixel_of(kLine)), 9) << name_of(method);
  }
}

/// Each with its own lines over it, and the later segment over both.
TEST(LinesInPixels, LieOverTheFillsOfTheirOwnSegmentWhereEachIsSortedByItself) {
  const auto make = [](bool first, bool second) {
    GraphicsSystem g;
    g.set_hidden_surfaces({.removal = true});
    g.set_back_face_removal(false);
    g.set_hidden_surfaces({.method = HiddenMethod::bsp});
    g.set_line_style({LineStyle::Kind::solid, kLine, 3.0});
    const auto add = [&](int name, double x) {
      g.open_segment(name);
      g.set_fill_style({FillStyle::Kind::solid, {0.2 * name, 0.5, 0.5}});
      g.polygon_abs_3({{x, -0.5, 0.1}, {x + 0.8, -0.5, 0.1}, {x + 0.8, 0.5, 0.1}});
      g.polygon_abs_3({{x, 0.2, -0.5}, {x + 0.8, 0.2, 0.7}, {x + 0.2, -0.4, 0.3}});
      g.close_segment();
    };
    if (first) add(1, -0.7);
    if (second) add(2, -0.2);
    return g;
  };
  DrawOptions options{.samples = 1};
  options.width = options.height = 80;
  const Picture both = draw(make(true, true), options);
  const Picture below = draw(make(true, false), options);
  const Picture above = draw(make(false, true), options);
  for (std::size_t i = 0; i < both.pixels.size(); ++i) {
    const bool is_above = above.pixels[i] != pixel_of(Background{});
    EXPECT_EQ(both.pixels[i], is_above ? above.pixels[i] : below.pixels[i]) << i;
  }
}

/// Pictures that are drawn strip by strip, and again by the same renderer, on any threads.
TEST(LinesInPixels, AreTheSameInStrips) {
  const DisplayFile file = outlined(entered(generated_scene("soup").make(60, 3)).display_file(),
                                    {LineStyle::Kind::dashed, kLine, 2.5});
  RasterRequest request;
  request.width = 900;
  request.height = 2500;
  request.crumbs = true;
  SoftwareRenderer renderer;
  for (const HiddenMethod method : {HiddenMethod::z_buffer, HiddenMethod::bsp}) {
    const Picture whole = drawn(file, method, {request.width, request.height}, 1);
    DisplayFile sorted = file;
    if (is_object_space(method)) {
      sorted.set_sorted(hidden_surface_check(file.visible_segments(), {.method = method}));
    }
    request.surfaces.method = method;
    request.sorted = is_object_space(method);
    for (const int threads : {1, 2, 2}) {
      request.surfaces.threads = threads;
      std::vector<std::uint32_t> pixels;
      int strips = 0;
      renderer.draw(sorted, request, [&](const Picture& rows) {
        pixels.insert(pixels.end(), rows.pixels.begin(), rows.pixels.end());
        ++strips;
      });
      EXPECT_GT(strips, 1);
      EXPECT_EQ(pixels, whole.pixels);
    }
  }
}

/// With any method of surfaces, the lines over them are the same, in whole pictures as applications
/// draw them.
TEST(LinesInPixels, AreTheSameByEveryExactMethodOverTheGallery) {
  test::for_each_in_gallery([](const std::string& program, const test::Retained& retained) {
    DrawOptions options{.samples = 1};
    options.width = 130;
    options.height = 90;
    options.surfaces.scope = HiddenScope::all;
    options.surfaces.method = HiddenMethod::z_buffer;
    const Picture right = draw(retained.system, options);
    for (const HiddenMethod method :
         {HiddenMethod::bsp, HiddenMethod::depth_sort, HiddenMethod::scan_line,
          HiddenMethod::scan_line_z, HiddenMethod::ray_cast, HiddenMethod::world_ray_cast,
          HiddenMethod::warnock}) {
      // Its fills may differ elsewhere, where only the rounding of viewing decides.
      if (method == HiddenMethod::world_ray_cast && program != "gears") continue;
      // Minutes under sanitizers: signs of the faces that a section cuts, in long exact numbers.
      const bool long_signs = method == HiddenMethod::depth_sort && program == "section-view";
      if (long_signs && test::kSlower > 1) continue;
      options.surfaces.method = method;
      EXPECT_EQ(draw(retained.system, options).pixels, right.pixels) << name_of(method);
    }
  });
}

}  // namespace
}  // namespace displayfile
