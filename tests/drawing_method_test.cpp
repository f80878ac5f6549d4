// Which method and which precision draw a picture: the application's settings, unless the drawing's
// options replace them.

#include <gtest/gtest.h>

#include <cmath>

#include "clip/base/error.h"
#include "displayfile/graphics_system.h"
#include "displayfile/segments/sorted_display_file.h"
#include "interp/draw/draw.h"
#include "interp/draw/drawing_choice.h"
#include "interp/draw/picture_plan.h"
#include "interp/draw/renderer.h"

namespace displayfile {
namespace {

TEST(DrawingMethod, IsThatOfTheOptionsOrElseOfTheApplication) {
  GraphicsSystem g;
  g.set_line_style({LineStyle::Kind::none});
  g.open_segment(1);
  g.polygon_abs_3({{0, 0, 0.25}, {0.5, 0, 0.25}, {0.5, 0.5, 0.25}});
  g.polygon_abs_3({{0.25, 0, 0}, {0.75, 0, 0}, {0.75, 0.5, 0}});  // behind it
  g.close_segment();
  EXPECT_EQ(drawing_method(g, {}, PictureKind::vector), HiddenMethod::map);
  g.set_hidden_surfaces({.removal = false});
  EXPECT_EQ(drawing_method(g, {}, PictureKind::vector), HiddenMethod::none);
  g.set_hidden_surfaces({.removal = true});
  EXPECT_EQ(drawing_method(g, {}, PictureKind::vector), HiddenMethod::map);
  EXPECT_EQ(drawing_method(g, {}, PictureKind::raster), HiddenMethod::z_buffer);
  EXPECT_EQ(drawing_method(g, {.surfaces = {.method = HiddenMethod::bsp}}, PictureKind::raster),
            HiddenMethod::bsp);
  g.set_hidden_surfaces({.z_buffer = true});
  EXPECT_EQ(drawing_method(g, {}, PictureKind::vector), HiddenMethod::z_buffer);
  EXPECT_EQ(picture_kind("a.svg"), PictureKind::vector);
  EXPECT_EQ(picture_kind("a.png"), PictureKind::raster);
  EXPECT_THROW(picture_kind("a.gif"), Error);
}

/// The scope applies to sorts: pixels and vectors by the chosen method show the same surfaces.
TEST(DrawingMethod, ThatIsPickedLooksAtAllSegmentsTogether) {
  GraphicsSystem g;
  g.set_hidden_surfaces({.removal = true});
  g.set_line_style({LineStyle::Kind::none});
  for (const int segment : {1, 2}) {
    g.open_segment(segment);
    const double z = segment == 1 ? 0.5 : 0.0;
    g.set_fill_style({FillStyle::Kind::solid, {z, 0, 0}});
    g.polygon_abs_3({{-0.5, -0.5, z}, {0.5, -0.5, z}, {0.5, 0.5, z}});
    g.close_segment();
  }
  const std::string all = draw_as(g, "svg", {});
  EXPECT_EQ(draw_as(g, "svg", {.surfaces = {.scope = HiddenScope::segment}}), all);
  g.set_hidden_surfaces({.scope = HiddenScope::segment});
  EXPECT_EQ(draw_as(g, "svg", {}), all);
  EXPECT_NE(draw_as(g, "svg", {.surfaces = {.method = HiddenMethod::map}}), all);
}

/// By default pictures are exact; dumps are the scene as entered.
TEST(DrawingMethod, IsPickedWhereNothingIsSet) {
  const auto draw_two = [](GraphicsSystem& g, double nearer, double farther) {
    g.set_line_style({LineStyle::Kind::none});
    g.open_segment(1);
    g.set_fill_style({FillStyle::Kind::solid, {1, 0, 0}});
    g.polygon_abs_3({{-0.5, -0.5, nearer}, {0.5, -0.5, nearer}, {0, 0.5, nearer}});
    g.set_fill_style({FillStyle::Kind::solid, {0, 0, 1}});
    g.polygon_abs_3({{-0.5, 0.5, farther}, {0.5, 0.5, farther}, {0, -0.5, farther}});
    g.close_segment();
  };
  const DrawOptions small{.width = 9, .height = 9, .samples = 1};
  const auto middle = [&](const GraphicsSystem& g) { return draw(g, small).pixels[4 * 9 + 4]; };
  const std::uint32_t red = pixel_of(Colour(1, 0, 0)), blue = pixel_of(Colour(0, 0, 1));
  GraphicsSystem deep, flat, off, method;
  draw_two(deep, 0.5, 0.0);
  EXPECT_EQ(middle(deep), red);
  EXPECT_EQ(draw_as(deep, "svg"),
            draw_as(deep, "svg", {.surfaces = {.method = HiddenMethod::map}}));
  EXPECT_EQ(deep.display_file().segment(1).sorted(), nullptr);
  EXPECT_EQ(
      draw(deep,
           {.width = 9, .height = 9, .surfaces = {.method = HiddenMethod::none}, .samples = 1})
          .pixels[4 * 9 + 4],
      blue);
  draw_two(flat, 0.25, 0.25);
  EXPECT_EQ(middle(flat), blue);
  EXPECT_EQ(drawing_method(flat, {}, PictureKind::vector), HiddenMethod::none);
  off.set_hidden_surfaces({.removal = false});
  draw_two(off, 0.5, 0.0);
  EXPECT_EQ(middle(off), blue);
  method.set_hidden_surfaces({.method = HiddenMethod::bsp});  // for when removal is on
  draw_two(method, 0.5, 0.0);
  EXPECT_EQ(middle(method), blue);
}

/// Segments sorted when they were closed stay so, whatever is set at the end.
TEST(DrawingMethod, SaysWhyNothingIsRemoved) {
  GraphicsSystem g;
  const auto reason = [&] { return drawing_choice(g, {}, PictureKind::raster).reason; };
  EXPECT_EQ(reason(), "all points have one depth: the order of entry holds");
  g.set_hidden_surfaces({.removal = false});
  EXPECT_EQ(reason(), "hidden-line removal is off");
  for (const HiddenMethod method : {HiddenMethod::automatic, HiddenMethod::bsp}) {
    g.set_hidden_surfaces({.removal = true});
    g.set_hidden_surfaces({.method = method});
    g.open_segment(method == HiddenMethod::bsp ? 2 : 1);
    g.polygon_abs_3({{0, 0, 0.25}, {0.5, 0, 0.25}, {0.5, 0.5, 0.25}});
    g.close_segment();
    g.set_hidden_surfaces({.removal = false});
    EXPECT_EQ(reason(), method == HiddenMethod::bsp
                            ? "hidden-line removal is off now; segments stay as they were sorted "
                              "when they were closed"
                            : "hidden-line removal is off");
  }
  const DrawOptions none{.surfaces = {.method = HiddenMethod::none}};
  EXPECT_EQ(drawing_choice(g, none, PictureKind::raster).reason, "as set");
}

/// The program's precision applies to the sorts and the z-buffer; the options' takes precedence.
TEST(DrawingMethod, PrecisionInForce) {
  GraphicsSystem g;
  EXPECT_TRUE(resolve_surfaces(g, {}).precision.exact);
  g.set_hidden_surfaces({.precision = Precision{.exact = false, .roundoff = 0.25}});
  EXPECT_EQ(resolve_surfaces(g, {}).precision.roundoff, 0.25);
  HiddenSurfaceOptions options;
  options.precision = Precision{};
  EXPECT_TRUE(resolve_surfaces(g, options).precision.exact);
  for (double wrong : {-0.5, 1.0, std::nan("")}) {
    EXPECT_THROW(g.set_hidden_surfaces({.precision = Precision{.exact = false, .roundoff = wrong}}),
                 Error);
  }
  EXPECT_EQ(g.hidden_surfaces().precision.roundoff, 0.25);
}

/// Once, of a call's options and the application's settings.
TEST(PicturePlan, HasTheSettingsThatOptionsLeaveOpen) {
  GraphicsSystem g;
  g.set_background({.colour = {0.25, 0.5, 0.75}});
  g.set_hidden_surfaces({.hidden_lines = HiddenLines::dashed});
  g.set_hidden_surfaces({.removal = true});
  g.set_hidden_surfaces({.method = HiddenMethod::bsp});
  g.set_hidden_surfaces({.scope = HiddenScope::all});
  const PicturePlan plan = resolve(g, {});
  EXPECT_EQ(plan.kind(), PictureKind::raster);
  EXPECT_TRUE(plan.is_on_first_device());
  EXPECT_EQ(plan.options.background->colour, Colour(0.25, 0.5, 0.75));
  EXPECT_EQ(plan.method, HiddenMethod::bsp);
  EXPECT_EQ(plan.surfaces.hidden_lines, HiddenLines::dashed);
  EXPECT_EQ(plan.surfaces.scope, HiddenScope::all);
  const DrawOptions settled = plan.without_system();
  EXPECT_EQ(settled.surfaces.method, HiddenMethod::bsp);
  EXPECT_EQ(settled.surfaces.hidden_lines, HiddenLines::dashed);
  EXPECT_EQ(settled.surfaces.scope, std::nullopt);

  const Destination file("a.svg");
  const PicturePlan other =
      resolve(g,
              {.surfaces = {.method = HiddenMethod::automatic, .hidden_lines = HiddenLines::none},
               .background = Background{.colour = {1, 1, 1}}},
              &file);
  EXPECT_EQ(other.kind(), PictureKind::vector);
  EXPECT_EQ(other.surfaces.method, HiddenMethod::automatic);
  EXPECT_NE(other.method, HiddenMethod::automatic);
  EXPECT_EQ(other.surfaces.hidden_lines, HiddenLines::none);
  EXPECT_EQ(other.options.background->colour, Colour(1, 1, 1));
}

/// A segment stays as it was sorted when it was closed, except for what the options set.
TEST(DrawingMethod, OfTheApplicationWithAnotherPrecisionSortsAgain) {
  GraphicsSystem g;
  g.set_hidden_surfaces({.removal = true, .method = HiddenMethod::bsp});
  g.open_segment(1);
  g.polygon_abs_3({{-0.5, -0.5, 0.5}, {0.5, -0.5, 0.5}, {0.5, 0.5, 0.5}});
  g.close_segment();
  SortedDisplayFile kept;
  const auto precision_by = [&](const HiddenSurfaceOptions& options) {
    return kept.update(g, HiddenMethod::bsp, options).segment(1).sorted()->plan.precision;
  };
  EXPECT_TRUE(precision_by({}).exact);
  EXPECT_EQ(precision_by({.precision = Precision{.exact = false, .roundoff = 1e-3}}).roundoff,
            1e-3);
  EXPECT_FALSE(precision_by({.precision = Precision{.exact = false, .roundoff = 1e-3}}).exact);
  EXPECT_TRUE(precision_by({}).exact);
}

/// The options first, then the application's settings.
TEST(SurfacePlan, IsTheOptionsAndWhereTheyLeaveItOpenTheApplications) {
  GraphicsSystem g;
  g.set_hidden_surfaces({.z_buffer = true, .scope = HiddenScope::segment});
  g.set_hidden_surfaces({.lines = line_selection("all,intersection")});
  const SurfacePlan set = resolve_surfaces(g, {});
  EXPECT_EQ(set.method, HiddenMethod::z_buffer);
  EXPECT_EQ(set.scope, HiddenScope::segment);
  EXPECT_TRUE(set.intersections);
  const SurfacePlan by_call =
      resolve_surfaces(g, {.method = HiddenMethod::bsp, .scope = HiddenScope::all});
  EXPECT_EQ(by_call.method, HiddenMethod::bsp);
  EXPECT_EQ(by_call.scope, HiddenScope::all);
  EXPECT_FALSE(resolve_surfaces(GraphicsSystem(), {}).intersections);
}

/// One type holds the options of both: options that only the other takes are refused, and change
/// nothing.
TEST(SurfacePlan, RefusesOptionsOfTheOther) {
  GraphicsSystem g;
  const HiddenSurfaceOptions applications[]{{.removal = true},
                                            {.z_buffer = false},
                                            {.lines = line_selection("outline")},
                                            {.touching = touching("off")}};
  for (const HiddenSurfaceOptions& options : applications) {
    EXPECT_THROW(resolve_surfaces(g, options), Error);
    EXPECT_THROW(draw(g, {.surfaces = options}), Error);
    EXPECT_THROW(draw_as(g, "svg", {.surfaces = options}), Error);
  }
  WorkBudget budget;
  const HiddenSurfaceOptions calls[]{{.removal = true, .root = RootChoice::last},
                                     {.removal = true, .threads = 2},
                                     {.removal = true, .most_pieces = 7},
                                     {.removal = true, .progress = [](std::size_t, std::size_t) {}},
                                     {.removal = true, .budget = &budget}};
  for (const HiddenSurfaceOptions& options : calls) {
    EXPECT_THROW(g.set_hidden_surfaces(options), Error);
    EXPECT_FALSE(g.hidden_surfaces().removal);
  }
}

/// In another view a method of the application acts on each segment, any other on all together.
TEST(PicturePlan, OfAnotherViewHasAScope) {
  GraphicsSystem g;
  g.set_hidden_surfaces({.removal = true, .method = HiddenMethod::bsp});
  EXPECT_EQ(resolve_in_view(&g, {}).surfaces.scope, HiddenScope::segment);
  const DrawOptions by_map{.surfaces = {.method = HiddenMethod::map}};
  EXPECT_EQ(resolve_in_view(&g, by_map).surfaces.scope, HiddenScope::all);
  EXPECT_EQ(resolve_in_view(nullptr, {}).surfaces.scope, HiddenScope::all);
}

/// Pens draw lines, or hatch visible surfaces; pixels have shadows of their own.
TEST(PicturePlan, OfPensAndOfShadows) {
  const Destination vectors("a.svg");
  DrawOptions options{.pens = Pens{}};
  EXPECT_EQ(resolve_in_view(nullptr, options, &vectors).method, HiddenMethod::franklin);
  options.pens->hatching.emplace();
  EXPECT_EQ(resolve_in_view(nullptr, options, &vectors).method, HiddenMethod::map);
  const GraphicsSystem g;
  EXPECT_TRUE(resolve(g, {}, &vectors).surfaces.shadows);
  EXPECT_FALSE(resolve(g, {}).surfaces.shadows);
}

TEST(PicturePlan, RefusesWhatCannotBe) {
  const Destination vectors("a.svg"), pixels("a.png"), unknown("a.gif");
  EXPECT_NO_THROW(resolve(DrawOptions{}, &vectors));
  EXPECT_THROW(resolve(DrawOptions{}, &unknown), Error);
  EXPECT_THROW(resolve(DrawOptions{.rows = PictureRows{0, 2}}, &vectors), Error);
  EXPECT_NO_THROW(resolve(DrawOptions{.rows = PictureRows{0, 2}}));
  EXPECT_THROW(resolve(DrawOptions{.width = 0}), Error);
  EXPECT_THROW(resolve(DrawOptions{.surfaces = {.threads = 0}}), Error);
  EXPECT_THROW(resolve(DrawOptions{.device = "plotter"}), Error);
  EXPECT_THROW(resolve(DrawOptions{.format = "gif"}), Error);
  EXPECT_THROW(resolve(DrawOptions{.pens = Pens{}}, &pixels), Error);
}

/// A picture that stays is not lost to a call that is refused.
TEST(PicturePlan, LeavesTheRenderersPictureWhereItRefuses) {
  GraphicsSystem g;
  Renderer renderer;
  renderer.draw(g, {.width = 3, .height = 2, .samples = 1});
  EXPECT_THROW(renderer.draw(g, {.width = 0}), Error);
  EXPECT_EQ(renderer.take_picture().width, 3);
}

}  // namespace
}  // namespace displayfile
