// The colour rule (interp/raster/colour_rule.md): its names, its pictures, and where they differ
// from exact hidden lines.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/files.h"
#include "displayfile/segments/hidden_surface_check.h"
#include "displayfile/segments/sorted_display_file.h"
#include "hidden/exact/support_plane.h"
#include "interp/device/raster_request.h"
#include "interp/draw/draw.h"
#include "interp/raster/software.h"
#include "interp/scan/pixel_depth.h"
#include "programs/scenes/generated_scenes.h"
#include "tests/error_of.h"
#include "tests/outlined.h"
#include "tests/temporary_folder.h"
#include "tests/without_keys.h"

namespace displayfile {
namespace {

using enum HiddenMethod;
using test::error_of;

TEST(ColourRule, IsNamedWithTheMethodOfItsSurfaces) {
  EXPECT_EQ(hidden_method("colour-rule"), colour_rule);
  EXPECT_EQ(hidden_method("colour-rule=auto"), colour_rule);
  for (const auto& entry : hidden_methods()) {
    if (shows_lines_only(entry.method)) continue;
    const HiddenMethod rule = hidden_method("colour-rule=" + std::string(entry.name));
    EXPECT_TRUE(is_colour_rule(rule));
    EXPECT_EQ(surfaces_of(rule), entry.method);
    EXPECT_EQ(hidden_method(name_of(rule)), rule);
  }
  EXPECT_EQ(name_of(colour_rule_by(bsp)), "colour-rule=bsp");
  EXPECT_EQ(surfaces_of(bsp), bsp);
}

TEST(ColourRule, NeedsAMethodOfSurfaces) {
  const auto error = [](const char* name) { return error_of([&] { hidden_method(name); }); };
  for (const char* lines : {"colour-rule=franklin", "colour-rule=colour-rule"}) {
    EXPECT_NE(error(lines).find("finds no surfaces: expected one of auto, none"), std::string::npos)
        << error(lines);
    EXPECT_EQ(error(lines).find("franklin,"), std::string::npos);
  }
  EXPECT_NE(error("colour-rule=bps").find("did you mean 'bsp'?"), std::string::npos);
  EXPECT_NE(error("colour-rule=").find("unknown"), std::string::npos);
}

void enter_cube(GraphicsSystem& g) {
  const auto at = [](double x, double y, double z) { return 0.6 * Point3(x, y, z); };
  g.set_perspective({1.5, 1.2, 5.0});
  g.set_fill_style({FillStyle::Kind::solid, {0.2, 0.6, 0.9}});
  g.set_line_style({LineStyle::Kind::solid, {1, 0, 0}});
  g.set_light({0.3, 0.4, 1.0});
  g.open_segment(1);
  g.polygon_abs_3({at(-1, -1, 1), at(1, -1, 1), at(1, 1, 1), at(-1, 1, 1)});
  g.polygon_abs_3({at(1, -1, -1), at(-1, -1, -1), at(-1, 1, -1), at(1, 1, -1)});
  g.polygon_abs_3({at(1, -1, 1), at(1, -1, -1), at(1, 1, -1), at(1, 1, 1)});
  g.polygon_abs_3({at(-1, -1, -1), at(-1, -1, 1), at(-1, 1, 1), at(-1, 1, -1)});
  g.polygon_abs_3({at(-1, 1, 1), at(1, 1, 1), at(1, 1, -1), at(-1, 1, -1)});
  g.polygon_abs_3({at(-1, -1, -1), at(1, -1, -1), at(1, -1, 1), at(-1, -1, 1)});
  g.close_segment();
}

const std::vector<HiddenMethod> kMethods{automatic, bsp,     depth_sort, z_buffer,
                                         scan_line, warnock, ray_cast,   world_ray_cast};

TEST(ColourRule, ShowsLinesOnTheBackgroundAndHasTheFillsItemBuffer) {
  for (const HiddenMethod surfaces : kMethods) {
    SCOPED_TRACE(name_of(colour_rule_by(surfaces)));
    GraphicsSystem g;
    g.set_hidden_surfaces({.method = colour_rule_by(surfaces)});
    g.set_hidden_surfaces({.removal = true});
    enter_cube(g);
    for (const Background& background :
         {Background{}, Background{Background::Kind::solid, {0.1, 0.2, 0.3}},
          Background{Background::Kind::none}}) {
      g.set_background(background);
      DrawOptions options{.samples = 1};
      options.width = options.height = 90;
      options.with_ids = options.with_depth = true;
      const Picture rule = draw(g, options);
      std::set<std::uint32_t> colours(rule.pixels.begin(), rule.pixels.end());
      EXPECT_EQ(colours, (std::set<std::uint32_t>{pixel_of(background), pixel_of({1, 0, 0})}));
      options.surfaces.method = surfaces;
      const Picture filled = draw(g, options);
      EXPECT_EQ(rule.ids, filled.ids);
      EXPECT_EQ(rule.depth, filled.depth);
      for (std::size_t i = 0; i < rule.pixels.size(); ++i) {  // a cube's lines differ nowhere
        EXPECT_EQ(rule.pixels[i] == pixel_of({1, 0, 0}), filled.pixels[i] == pixel_of({1, 0, 0}));
      }
    }
  }
}

TEST(ColourRule, IsTheSameOnAnyThreads) {
  GraphicsSystem g;
  enter(generated_scene("soup").make(40, 3), g);
  for (const HiddenMethod surfaces : {z_buffer, bsp, none}) {
    DrawOptions options{.samples = 1};
    options.surfaces.method = colour_rule_by(surfaces);
    const Picture one = draw(g, options);
    options.surfaces.threads = 3;
    EXPECT_EQ(draw(g, options).pixels, one.pixels);
  }
}

TEST(ColourRule, IsRecordedAndReplayed) {
  std::ostringstream recording;
  Recorder recorder(recording);
  GraphicsSystem g, again;
  g.set_recorder(&recorder);
  g.set_hidden_surfaces({.method = colour_rule_by(scan_line_z)});
  replay(recording.str(), "recording", again);
  EXPECT_EQ(again.hidden_surfaces().method, colour_rule_by(scan_line_z));
}

TEST(ColourRule, SortsWhenASegmentIsClosed) {
  GraphicsSystem g;
  g.set_hidden_surfaces({.method = colour_rule_by(bsp)});
  g.set_hidden_surfaces({.removal = true});
  enter_cube(g);
  const auto sorted = g.display_file().segment(1).sorted();
  ASSERT_NE(sorted, nullptr);
  EXPECT_EQ(sorted->plan.method, bsp);
  SortedDisplayFile kept;  // which leaves it as it is
  EXPECT_EQ(kept.update(g, colour_rule_by(bsp)).segment(1).sorted(), sorted);
}

using ColourRuleFiles = test::TemporaryFolder;

TEST_F(ColourRuleFiles, InVectorsFillsHaveTheBackgroundsColour) {
  const auto svg = [&](const DrawOptions& options) {
    GraphicsSystem g;
    enter_cube(g);
    draw(g, file("cube.svg"), options);
    return test::content(file("cube.svg"));
  };
  for (const HiddenMethod surfaces : {automatic, bsp, depth_sort, z_buffer}) {
    DrawOptions options{.samples = 1};
    options.surfaces.method = colour_rule_by(surfaces);
    options.background = Background{Background::Kind::solid, {0, 0, 1}};
    const std::string text = svg(options);
    EXPECT_NE(text.find(".f1"), std::string::npos);
    EXPECT_EQ(text.find(".f2"), std::string::npos) << text;
    EXPECT_NE(test::without_keys(text).find(".f1{fill:#0000ff}"), std::string::npos) << text;
    options.background = Background{Background::Kind::none};
    EXPECT_NE(error_of([&] { svg(options); }).find("there is no background"), std::string::npos);
  }
}

TEST(ColourRule, IsDumpedWithFillsInTheBackgroundsColour) {
  GraphicsSystem g;
  enter_cube(g);
  const auto fills_of = [](const std::string& text) {
    std::vector<std::string> fills;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      const std::size_t at = line.find("fill ");
      if (at != std::string::npos) fills.push_back(line.substr(at));
    }
    return fills;
  };
  using Words = std::vector<std::string>;
  ASSERT_EQ(fills_of(dump(g.display_file())).size(), 3u);  // one a face, by its light
  EXPECT_EQ(fills_of(dump(g.display_file(), Colour{1, 1, 1})), Words{"fill solid 1 1 1"});
}

TEST(ColourRule, IsNotDrawnByOpenGl) {
  GraphicsSystem g;
  enter_cube(g);
  DrawOptions options{.samples = 1};
  options.surfaces.method = colour_rule;
  options.device = "osmesa";
  EXPECT_NE(error_of([&] { draw(g, options); }).find("expected the software device"),
            std::string::npos);
}

// ---- Where it differs --------------------------------------------------------------------

const Colour kLine{1.0, 0.0, 1.0};

/// The lines and fills of a picture, in pixels, to find out why a pixel of a line is another's.
class Reasons {
 public:
  Reasons(const ViewedScene& scene, int width, int height) : scene_(scene), size_(width, height) {
    for (ViewedScene::Fill fill = 1; fill < scene.end(); ++fill) {
      depths_.emplace_back(scene.plane(fill), width, height);
    }
  }

  /// Where the order of drawing decides, the outline of any polygon is a reason, since one which
  /// does not overlap the line's own polygon need not be drawn before; so are outlines of pieces.
  void take_order(const SortedScene& sorted) {
    in_order_ = true;
    for (const auto& part : sorted.parts) {
      for (const SortedPiece& piece : part->pieces.pieces) {
        if (piece.first == SortedPiece::kWhole) continue;
        const std::span points = std::span(part->pieces.points).subspan(piece.first, piece.sides);
        for (std::size_t side = 0; side < points.size(); ++side) {
          sides_of_pieces_.push_back(side_of(points, side));
        }
      }
    }
  }

  /// True if some line close to the pixel's centre has within a pixel of it the outline of a
  /// nearer polygon, or passes a polygon no farther off in depth than these change in a pixel; or
  /// its own is narrower than a pixel there.
  bool explain(const Point2& centre) const {
    const auto is_close = [&](const Side& side) { return side.nearest(centre).distance <= 1.0; };
    if (std::ranges::any_of(sides_of_pieces_, is_close)) return true;
    for (ViewedScene::Item item = 0; item < scene_.items(); ++item) {
      const PointRow points = scene_.points(item);
      const bool is_line = scene_.kind(item) == Primitives::Kind::line;
      for (std::size_t side = is_line ? 1 : 0; side < points.size(); ++side) {
        const Side line = side_of(points, side);
        if (line.nearest(centre).distance <= 1.0 && explain(centre, item, line)) return true;
      }
    }
    return false;
  }

 private:
  struct Place {
    double distance, depth;
  };
  struct Side {
    Point3 from, to;  // x and y in pixels
    bool operator==(const Side& o) const {
      return (from == o.from && to == o.to) || (from == o.to && to == o.from);
    }
    Place nearest(const Point2& p) const {
      const Point2 along = Point2(to - from);
      const double square = along.x * along.x + along.y * along.y;
      const Point2 way = p - Point2(from);
      const double t =
          square > 0.0 ? std::clamp((way.x * along.x + way.y * along.y) / square, 0.0, 1.0) : 0.0;
      const Point3 at = from + t * (to - from);
      return {std::hypot(p.x - at.x, p.y - at.y), at.z};
    }
  };
  Side side_of(const PointRow& points, std::size_t side) const {
    const auto pixel = [&](const Point3& p) { return Point3(p.x * size_.x, p.y * size_.y, p.z); };
    return {pixel(points[(side + points.size() - 1) % points.size()]), pixel(points[side])};
  }
  static double slope(const PixelDepth& depth) {
    return std::abs(depth.dz_dx) + std::abs(depth.dz_dy);
  }

  bool explain(const Point2& centre, ViewedScene::Item item, const Side& line) const {
    const double depth = line.nearest(centre).depth;
    double own_slope = 0.0;
    for (ViewedScene::Fill fill = 1; fill < scene_.end(); ++fill) {
      if (scene_.item_of(fill) == item) own_slope = slope(depths_[fill - 1]);
    }
    for (ViewedScene::Fill fill = 1; fill < scene_.end(); ++fill) {
      const PointRow points = scene_.vertices(fill);
      bool shares = scene_.item_of(fill) == item, is_close = false, has_inside = false;
      for (std::size_t side = 0; side < points.size(); ++side) {
        shares = shares || side_of(points, side) == line;
      }
      for (std::size_t side = 0; side < points.size(); ++side) {
        const Side other = side_of(points, side);
        if (other == line) continue;
        if ((other.from.y > centre.y) != (other.to.y > centre.y)) {
          const double x = other.from.x + (centre.y - other.from.y) / (other.to.y - other.from.y) *
                                              (other.to.x - other.from.x);
          has_inside = has_inside != (x > centre.x);
        }
        const Place place = other.nearest(centre);
        if (place.distance > 1.0) continue;
        is_close = true;
        if (shares || in_order_ || place.depth >= depth - 1e-9) return true;
      }
      if (shares || (!is_close && !has_inside)) continue;
      const PixelDepth& plane = depths_[fill - 1];
      const double apart = std::abs(plane.at_point(centre.x, centre.y) - depth);
      if (apart <= slope(plane) + own_slope + 1e-9) return true;
    }
    return false;
  }

  const ViewedScene& scene_;
  Point2 size_;
  std::vector<PixelDepth> depths_;
  bool in_order_ = false;
  std::vector<Side> sides_of_pieces_;
};

struct Differences {
  int line_pixels = 0, differ = 0, unexplained = 0;
};

std::vector<bool> line_pixels(const DisplayFile& file, HiddenMethod method, int size) {
  RasterRequest request;
  request.width = request.height = size;
  request.surfaces.method = method;
  DisplayFile drawn = file;
  if (is_object_space(method)) {
    drawn.set_sorted(hidden_surface_check(file.visible_segments(), {.method = method}));
    request.sorted = true;
  }
  std::vector<bool> lines;
  for (const std::uint32_t pixel : draw_with_software(drawn, request).pixels) {
    lines.push_back(pixel == pixel_of(kLine));
  }
  return lines;
}

Differences differences(const DisplayFile& entered, HiddenMethod surfaces, int size) {
  const DisplayFile file = test::outlined(entered, {LineStyle::Kind::solid, kLine});
  const std::vector<bool> exact = line_pixels(file, z_buffer, size);
  const std::vector<bool> rule = line_pixels(file, colour_rule_by(surfaces), size);
  const ViewedScene scene(file);
  Reasons reasons(scene, size, size);
  if (is_object_space(surfaces)) {
    reasons.take_order(*hidden_surface_check(file.visible_segments(), {.method = surfaces}));
  }
  Differences found;
  for (int i = 0; i < size * size; ++i) {
    const auto at = static_cast<std::size_t>(i);
    found.line_pixels += exact[at] ? 1 : 0;
    if (exact[at] == rule[at]) continue;
    ++found.differ;
    const Point2 centre(i % size + 0.5, size - 1 - i / size + 0.5);
    found.unexplained += reasons.explain(centre) ? 0 : 1;
  }
  return found;
}

/// A pixel of a line may differ only within one of a nearer polygon's outline, or where depths are
/// as close as a pixel changes them.
TEST(ColourRule, DiffersFromExactLinesOnlyAtNearerOutlinesAndSteepFaces) {
  const auto expect_explained = [](const std::string& name, const DisplayFile& file) {
    for (const HiddenMethod surfaces : {z_buffer, scan_line, bsp, depth_sort}) {
      const Differences found = differences(file, surfaces, 150);
      EXPECT_EQ(found.unexplained, 0) << name << ", " << name_of(surfaces);
      EXPECT_LT(found.differ, found.line_pixels / 5) << name << ", " << name_of(surfaces);
      RecordProperty(name + " " + std::string(name_of(surfaces)),
                     std::to_string(found.differ) + " of " + std::to_string(found.line_pixels));
    }
  };
  for (const char* program :
       {"gears", "house-perspective", "house-parallel", "room-front-clipping", "robot-arm",
        "interpenetrating-planes", "cyclic-overlap", "platonic-solids"}) {
    GraphicsSystem g;
    replay_file(std::string(DISPLAYFILE_SOURCE_DIR "/programs/") + program + ".draw", g);
    expect_explained(program, g.display_file());
  }
  for (const char* scene : {"terrain", "city"}) {
    expect_explained(scene,
                     displayfile::entered(generated_scene(scene).make(300, 2)).display_file());
  }
}

}  // namespace
}  // namespace displayfile
