// Options that set how hidden surfaces are found: each way to draw a retained scene, or a finished
// display file, obeys them or refuses them.

#include <gtest/gtest.h>

#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "displayfile/segments/hidden_surface_check.h"
#include "displayfile/segments/sorted_display_file.h"
#include "displayfile/views/retained_views.h"
#include "interp/draw/draw.h"
#include "interp/draw/turntable_renderer.h"
#include "interp/draw/world_views.h"
#include "interp/opengl/osmesa.h"
#include "interp/visibility/image_space.h"
#include "tests/error_of.h"
#include "tests/from_eyes.h"
#include "tests/replayed.h"
#include "tests/retained_truth.h"

namespace displayfile {
namespace {

using test::FromEyes;

using test::error_of;
using test::Retained;

class RefusedOptions : public testing::Test {
 protected:
  RefusedOptions() { test::enter_two_segments(retained_.system); }

  const DisplayFile& file() const { return retained_.system.display_file(); }
  static DrawOptions options(std::optional<HiddenMethod> method = std::nullopt) {
    DrawOptions options{.width = 40, .height = 30, .samples = 1};
    options.surfaces.method = method;
    return options;
  }
  /// The message of drawing into a file of that format, or in memory if it is empty; nothing if it
  /// is drawn.
  template <class Drawn>
  static std::string refusal(const Drawn& drawn, DrawOptions options, const std::string& format) {
    if (format.empty()) return error_of([&] { draw(drawn, options); });
    options.format = format;
    std::ostringstream bytes;
    std::string error = error_of([&] { draw(drawn, bytes, options); });
    EXPECT_EQ(error.empty(), !bytes.str().empty()) << error;
    return error;
  }

  Retained retained_;
};

constexpr const char* kFormats[] = {"", "ppm", "svg"};

TEST_F(RefusedOptions, ADisplayFileThatIsReadyHasTheOrderThatItHas) {
  for (const HiddenScope scope : {HiddenScope::all, HiddenScope::segment}) {
    RetainedViews views(retained_.scene, file(), {.scope = scope});
    const DisplayFile view = views.view(retained_.system.view());
    for (const std::string format : kFormats) {
      SCOPED_TRACE(format);
      for (const HiddenMethodEntry& entry : hidden_methods()) {
        if (is_colour_rule(entry.method)) continue;
        const bool as_it_is =
            entry.method == HiddenMethod::bsp || entry.method == HiddenMethod::automatic;
        EXPECT_EQ(refusal(view, options(entry.method), format).empty(), as_it_is) << entry.name;
      }
      EXPECT_EQ(refusal(view, options(HiddenMethod::map), format),
                "hidden-surface method 'map' for a display file that is drawn in the order that it "
                "has, of hidden-surface method 'bsp': expected bsp, or no hidden-surface method");
      EXPECT_EQ(refusal(view, options(HiddenMethod::colour_rule), format), "");
      EXPECT_EQ(refusal(view, options(colour_rule_by(HiddenMethod::bsp)), format), "");
      EXPECT_NE(refusal(view, options(colour_rule_by(HiddenMethod::map)), format), "");
      DrawOptions with = options();
      with.surfaces.precision = Precision{};
      with.surfaces.scope = scope;
      with.surfaces.hidden_lines = HiddenLines::none;
      EXPECT_EQ(refusal(view, with, format), "");
      DrawOptions other = options();
      other.surfaces.precision = Precision{false, 0.25};
      EXPECT_EQ(refusal(view, other, format),
                "precision 'roundoff=0.25' for a display file that is drawn in the order that it "
                "has, of precision 'exact': expected exact, or no precision");
      other = options();
      other.surfaces.scope = scope == HiddenScope::all ? HiddenScope::segment : HiddenScope::all;
      EXPECT_TRUE(refusal(view, other, format).starts_with("scope '")) << format;
      other = options();
      other.surfaces.hidden_lines = HiddenLines::dashed;
      EXPECT_TRUE(refusal(view, other, format).starts_with("hidden lines 'dashed' for ")) << format;
    }
  }
  RetainedViews dashed(retained_.scene, file(), {.hidden_lines = HiddenLines::dashed});
  DrawOptions hidden = options();
  hidden.surfaces.hidden_lines = HiddenLines::dashed;
  EXPECT_EQ(refusal(dashed.view(retained_.system.view()), hidden, "svg"), "");
  hidden.surfaces.hidden_lines = HiddenLines::none;
  EXPECT_NE(refusal(dashed.view(retained_.system.view()), hidden, "svg"), "");
}

/// With one segment, both scopes are the same.
TEST_F(RefusedOptions, TheScopeOfOneVisibleSegmentIsEither) {
  retained_.system.set_visibility(2, false);
  for (const HiddenScope made : {HiddenScope::all, HiddenScope::segment}) {
    RetainedViews views(retained_.scene, file(), {.scope = made});
    const DisplayFile view = views.view(retained_.system.view());
    for (const HiddenScope scope : {HiddenScope::all, HiddenScope::segment}) {
      DrawOptions with = options();
      with.surfaces.scope = scope;
      for (const std::string format : kFormats) EXPECT_EQ(refusal(view, with, format), "");
    }
  }
}

/// In order of entry, as the heedless painter draws it; with an empty display file any method is
/// accepted.
TEST_F(RefusedOptions, ADisplayFileInOrderOfEntry) {
  for (const std::string format : kFormats) {
    EXPECT_EQ(refusal(file(), options(HiddenMethod::none), format), "");
    EXPECT_EQ(refusal(file(), options(HiddenMethod::back_face), format), "");
    EXPECT_EQ(refusal(file(), options(HiddenMethod::colour_rule), format), "");
    EXPECT_EQ(refusal(file(), options(HiddenMethod::map), format),
              "hidden-surface method 'map' for a display file that is drawn in the order that it "
              "has, of hidden-surface method 'none': expected none, or no hidden-surface method");
    EXPECT_EQ(refusal(DisplayFile(), options(HiddenMethod::map), format), "");
  }
  SortedDisplayFile sorted;
  sorted.update(retained_.system, HiddenMethod::map, {.method = HiddenMethod::map});
  EXPECT_EQ(refusal(sorted.display_file(), options(HiddenMethod::map), "svg"), "");
}

TEST_F(RefusedOptions, RaysDrawWhatRaysFind) {
  const WorldViews views(retained_.scene, file());
  const ViewedWorld world = views.view(retained_.system.view());
  for (const HiddenMethod method : {HiddenMethod::automatic, HiddenMethod::world_ray_cast}) {
    for (const std::string format : kFormats) {
      EXPECT_EQ(refusal(world, options(method), format), "");
    }
  }
  for (const HiddenMethod method : {HiddenMethod::map, HiddenMethod::z_buffer}) {
    EXPECT_EQ(refusal(world, options(method), "svg"), "");  // all of them are the map there
    for (const std::string format : {"", "ppm"}) {
      EXPECT_EQ(refusal(world, options(method), format),
                "hidden-surface method '" + std::string(name_of(method)) +
                    "' for a view into which rays are cast: expected world-ray-cast, auto, or no "
                    "method");
    }
  }
  for (const HiddenMethod method :
       {HiddenMethod::bsp, HiddenMethod::none, HiddenMethod::franklin}) {
    for (const std::string format : kFormats) {
      EXPECT_NE(refusal(world, options(method), format), "") << name_of(method);
    }
  }
  for (const std::string format : kFormats) {
    DrawOptions each = options();
    each.surfaces.scope = HiddenScope::segment;
    EXPECT_TRUE(refusal(world, each, format).starts_with("scope 'segment' for a view")) << format;
    each.surfaces.scope = HiddenScope::all;
    EXPECT_EQ(refusal(world, each, format), "");
  }
  if (osmesa_available()) {  // which finds visible surfaces by its own depths
    DrawOptions other = options(HiddenMethod::z_buffer);
    other.device = "osmesa";
    EXPECT_EQ(refusal(world, other, "ppm"), "");
  }
  // A system, whose image-space methods do not use a scope, is still drawn by rays.
  DrawOptions of_system = options(HiddenMethod::world_ray_cast);
  of_system.surfaces.scope = HiddenScope::segment;
  EXPECT_EQ(refusal(retained_.system, of_system, "ppm"), "");
}

TEST_F(RefusedOptions, ViewsInImageSpaceAreOfAllSegments) {
  FromEyes renderer(retained_.scene, file());
  const View& view = retained_.system.view();
  DrawOptions each = options(HiddenMethod::z_buffer);
  each.surfaces.scope = HiddenScope::segment;
  const std::string words =
      "scope 'segment' for a view of a retained scene, whose visible segments are drawn together: "
      "expected all, or no scope";
  EXPECT_EQ(error_of([&] { renderer.draw(view, each); }), words);
  std::ostringstream bytes;
  each.format = "svg";
  EXPECT_EQ(error_of([&] { renderer.draw(view, bytes, each); }), words);
  EXPECT_EQ(bytes.str(), "");
  EXPECT_EQ(
      error_of([&] { TurntableRenderer(retained_.system, retained_.scene, file(), {3}, each); }),
      words);
  each.surfaces.method = HiddenMethod::franklin;  // each segment's own polygons hide its lines
  EXPECT_EQ(error_of([&] { renderer.draw(view, each); }), "");
  each.surfaces.method = HiddenMethod::map;
  EXPECT_EQ(error_of([&] { renderer.draw(view, each); }), "");
}

TEST_F(RefusedOptions, ARootIsOfATreeOfBsp) {
  const std::string words =
      "a root of a BSP tree is set, and the hidden-surface method is z-buffer: expected bsp, or no "
      "root";
  DrawOptions rooted = options(HiddenMethod::z_buffer);
  rooted.surfaces.root = RootChoice::last;
  FromEyes renderer(retained_.scene, file());
  EXPECT_EQ(error_of([&] { draw(retained_.system, rooted); }), words);
  EXPECT_EQ(error_of([&] { renderer.draw(retained_.system.view(), rooted); }), words);
  EXPECT_EQ(
      error_of([&] { TurntableRenderer(retained_.system, retained_.scene, file(), {3}, rooted); }),
      words);
  for (const HiddenMethod method : {HiddenMethod::bsp, colour_rule_by(HiddenMethod::bsp)}) {
    rooted.surfaces.method = method;
    EXPECT_EQ(error_of([&] { draw(retained_.system, rooted); }), "");
    EXPECT_EQ(error_of([&] { renderer.draw(retained_.system.view(), rooted); }), "");
  }
  rooted.surfaces.method.reset();  // the application's
  retained_.system.set_hidden_surfaces({.removal = true, .method = HiddenMethod::bsp});
  EXPECT_EQ(error_of([&] { draw(retained_.system, rooted); }), "");
}

/// A caller that shares a picture out refuses it before anything is drawn.
TEST_F(RefusedOptions, WhatDrawingRefusesIsRefusedBefore) {
  const std::string plate =
      "set-back-face-removal off\nopen-segment 1\n"
      "polygon-abs-3 -0.5 -0.5 0  0.5 -0.5 0  0.5 0.5 0  -0.5 0.5 0\n";
  const std::string behind =
      plate + "move-abs-3 -0.9 0.1 -1\nline-abs-3 0.9 0.3 -1\nclose-segment\n";
  const std::string before = plate + "move-abs-3 -0.9 0.1 1\nline-abs-3 0.9 0.3 1\nclose-segment\n";
  const std::string in_order = "set-hidden-line-removal on\nset-hidden-method bsp\n" + behind;
  int refused = 0;
  for (const std::string& program :
       {behind, before, in_order, in_order + "set-hidden-line-removal off\n",
        "set-hidden-lines dashed\n" + behind, "set-hidden-lines dashed\n" + in_order}) {
    const GraphicsSystem system = test::replayed(program);
    for (const std::optional<HiddenMethod> method :
         {std::optional<HiddenMethod>(), std::optional(HiddenMethod::none),
          std::optional(HiddenMethod::back_face), std::optional(HiddenMethod::bsp),
          std::optional(HiddenMethod::map), std::optional(HiddenMethod::z_buffer),
          std::optional(HiddenMethod::franklin)}) {
      for (const std::optional<HiddenLines> lines :
           {std::optional<HiddenLines>(), std::optional(HiddenLines::none),
            std::optional(HiddenLines::dashed)}) {
        DrawOptions with = options(method);
        with.surfaces.hidden_lines = lines;
        const std::string error = error_of([&] { draw(system, with); });
        EXPECT_EQ(error_of([&] { require_drawable(system, with); }), error)
            << program << (method ? name_of(*method) : "");
        refused += error.empty() ? 0 : 1;
      }
    }
  }
  EXPECT_GT(refused, 5);
}

/// The warnings of options without effect, into a file of that format or in memory.
std::vector<std::string> without_effect(const GraphicsSystem& system, DrawOptions options,
                                        const std::string& format) {
  std::vector<std::string> texts;
  options.warn = [&](const DrawWarning& warning) {
    if (warning.kind == DrawWarning::Kind::no_effect) texts.push_back(warning.text);
  };
  if (format.empty()) {
    draw(system, options);
  } else {
    draw_as(system, format, options);
  }
  return texts;
}

/// A ROUNDOFF and a scope have an effect, or are refused, or warned of, by every method.
TEST_F(RefusedOptions, WhatHasNoEffectIsRefusedOrWarnedOf) {
  GraphicsSystem system;
  test::enter_two_segments(system);
  const auto warned = [&](HiddenMethod method, std::optional<Precision> precision,
                          std::optional<HiddenScope> scope, const std::string& format) {
    DrawOptions with = options(method);
    with.surfaces.precision = precision;
    with.surfaces.scope = scope;
    return without_effect(system, with, format);
  };
  using Texts = std::vector<std::string>;
  const Precision rounded{false, 0.25};
  for (const std::string format : kFormats) {
    SCOPED_TRACE(format);
    for (const HiddenMethodEntry& entry : hidden_methods()) {
      const HiddenMethod method = entry.method;
      if (needs_surface(method) || method == HiddenMethod::world_ray_cast) continue;
      SCOPED_TRACE(name_of(method));
      const std::string name(name_of(method));
      const bool enters = method == HiddenMethod::none || method == HiddenMethod::back_face;
      const std::string why = "hidden-surface method '" + name + "' draws in order of entry";
      EXPECT_EQ(warned(method, Precision{}, std::nullopt, format), Texts{});
      if (is_plain_z_buffer(method) && format != "svg") {
        DrawOptions with = options(method);
        with.surfaces.precision = rounded;
        EXPECT_EQ(refusal(system, with, format), "hidden-surface method '" + name +
                                                     "' rounds depths as it stores them, without "
                                                     "a ROUNDOFF: expected precision exact");
      } else {
        EXPECT_EQ(warned(method, rounded, std::nullopt, format),
                  enters ? Texts{"precision roundoff=0.25 has no effect: " + why} : Texts{});
      }
      EXPECT_EQ(warned(method, std::nullopt, HiddenScope::all, format),
                enters ? Texts{"scope all has no effect: " + why} : Texts{});
      const Texts by_segment = enters ? Texts{"scope segment has no effect: " + why}
                               : is_object_space(method)
                                   ? Texts{}
                                   : Texts{"scope segment has no effect: hidden-surface method '" +
                                           name + "' takes all segments together"};
      EXPECT_EQ(warned(method, std::nullopt, HiddenScope::segment, format), by_segment);
    }
  }
  system.set_visibility(2, false);  // with one segment, both scopes are the same
  EXPECT_EQ(warned(HiddenMethod::z_buffer, std::nullopt, HiddenScope::segment, ""), Texts{});
}

/// A ROUNDOFF is for the lines over a map alone.
TEST_F(RefusedOptions, AMapWithoutLinesHasNoRoundoff) {
  for (const bool has_lines : {true, false}) {
    GraphicsSystem system;
    if (!has_lines) system.set_line_style({LineStyle::Kind::none});
    system.open_segment(1);
    system.polygon_abs_3({{-0.5, -0.5, 0.2}, {0.6, -0.4, -0.3}, {0.1, 0.7, 0.1}});
    system.close_segment();
    DrawOptions with = options(HiddenMethod::map);
    with.surfaces.precision = Precision{false, 0.25};
    const std::vector<std::string> none;
    EXPECT_EQ(without_effect(system, with, "svg"),
              has_lines ? none
                        : std::vector<std::string>{"precision roundoff=0.25 has no effect: the map "
                                                   "is exact, and there are no lines"});
  }
}

/// Segments that close-segment sorted are sorted again by a ROUNDOFF, whatever is set since.
TEST_F(RefusedOptions, AnOrderThatIsThereRounds) {
  GraphicsSystem system;
  system.set_hidden_surfaces({.removal = true, .method = HiddenMethod::bsp});
  test::enter_two_segments(system);
  system.set_hidden_surfaces({.removal = false});
  DrawOptions with = options();
  with.surfaces.precision = Precision{false, 0.25};
  EXPECT_EQ(without_effect(system, with, "svg"), std::vector<std::string>{});
}

TEST_F(RefusedOptions, ADevicesOwnZBufferHasNoRoundoff) {
  if (!osmesa_available()) GTEST_SKIP() << "OSMesa is not in this build";
  GraphicsSystem system;
  test::enter_two_segments(system);
  DrawOptions with = options();
  with.device = "osmesa";
  with.surfaces.precision = Precision{false, 0.25};
  EXPECT_EQ(without_effect(system, with, ""),
            std::vector<std::string>{"precision roundoff=0.25 has no effect: the device finds "
                                     "surfaces by a z-buffer of its own"});
  with.surfaces.method = HiddenMethod::bsp;
  EXPECT_EQ(without_effect(system, with, ""), std::vector<std::string>{});
}

/// A turntable obeys its options in each view: of a tree, of rays, in image space.
TEST_F(RefusedOptions, ATurntableDrawsWhatItWasMadeFor) {
  for (const std::optional<HiddenMethod> method :
       {std::optional<HiddenMethod>(), std::optional(HiddenMethod::bsp),
        std::optional(HiddenMethod::colour_rule), std::optional(HiddenMethod::world_ray_cast),
        std::optional(HiddenMethod::z_buffer), std::optional(HiddenMethod::franklin)}) {
    for (const HiddenLines hidden : {HiddenLines::none, HiddenLines::dashed}) {
      DrawOptions with = options(method);
      with.surfaces.hidden_lines = hidden;
      with.surfaces.precision = Precision{};
      with.surfaces.scope = HiddenScope::all;
      if (method != HiddenMethod::colour_rule || hidden == HiddenLines::none) {
        TurntableRenderer views(retained_.system, retained_.scene, file(), {3}, with);
        EXPECT_EQ(error_of([&] { views.draw(1); }), "");
      }
    }
  }
}

}  // namespace
}  // namespace displayfile
