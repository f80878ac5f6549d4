// The one header that an application includes, in the source tree: nothing else of Display File is
// included here. tests/package_test tests it as installed.

#include "displayfile/displayfile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// Not part of that header: trees of a retained scene.
#include "displayfile/segments/retained_scene.h"
#include "displayfile/views/retained_views.h"
#include "interp/draw/world_views.h"

namespace {

TEST(Application, DrawsAndCatches) {
  displayfile::GraphicsSystem g;
  g.set_perspective({3, 2, 6});
  g.set_fill_style({displayfile::FillStyle::Kind::solid, {0.9, 0.8, 0.6}});
  g.open_segment(1);
  g.polygon_abs_3({{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0, 0.5, 0}});
  try {
    g.open_segment(2);
    FAIL();
  } catch (const displayfile::Error& error) {
    EXPECT_NE(std::string(error.what()), "");
  }
  g.close_segment();
  displayfile::DrawOptions options{.samples = 1};
  options.width = options.height = 16;
  options.surfaces.method = displayfile::HiddenMethod::z_buffer;
  const displayfile::Picture picture = displayfile::draw(g, options);
  EXPECT_EQ(picture.pixels.size(), 256u);
  EXPECT_NE(picture.pixels[8 * 16 + 8], 0xFFFFFFFFu);
}

TEST(Application, RecordsReplaysAndDumps) {
  std::ostringstream program;
  displayfile::Recorder recorder(program);
  displayfile::GraphicsSystem g, again;
  g.set_recorder(&recorder);
  g.open_segment(7);
  g.line_abs_3(0.5, 0.25, 0);
  g.close_segment();
  displayfile::replay(program.str(), "recorded", again);
  EXPECT_EQ(displayfile::dump(again.display_file()), displayfile::dump(g.display_file()));
}

TEST(Application, EntersMeshes) {
  displayfile::Mesh mesh;
  mesh.objects = {{"triangle", 0, 1}};
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.corners = {0, 1, 2};
  mesh.first_corner = {0, 3};
  displayfile::GraphicsSystem g;
  displayfile::enter_mesh(mesh, g, 1);
  EXPECT_EQ(g.counts().polygons, 1);
}

TEST(Application, AnimatesAndPicks) {
  displayfile::GraphicsSystem g;
  displayfile::Renderer renderer;
  const displayfile::DrawOptions options{.width = 40, .height = 40, .samples = 1, .with_ids = true};
  for (int frame = 0; frame < 3; ++frame) {
    if (frame > 0) g.delete_segment(2);
    g.open_segment(2);
    g.create_transformation_3();
    g.rotate_z_3(45.0 * frame);
    g.save_transformation_3();
    g.translate_3(0.5, 0, 0);
    g.set_pick_id(7);
    g.polygon_abs_3({{0, -0.1, 0}, {0.4, -0.1, 0}, {0.4, 0.1, 0}, {0, 0.1, 0}});
    g.restore_transformation_3();
    g.close_segment();
    const displayfile::Picture& picture = renderer.draw(g, options);
    ASSERT_EQ(picture.ids.size(), 1600u);
    EXPECT_EQ(picture.ids[20 * 40 + 34], frame == 0 ? 7 : -1);
    EXPECT_EQ(picture.ids[6 * 40 + 20], frame == 2 ? 7 : -1);
    const std::optional<displayfile::Pick> pick = renderer.pick(g, 20, 6, options);
    EXPECT_EQ(pick.has_value(), frame == 2);
  }
  g.set_image_centre(2, 0.5, 0.5);
  g.set_image_rotation(2, -90);
  EXPECT_EQ(renderer.pick(g, 34, 20, options)->id, 7);
  EXPECT_EQ(renderer.pick(g, 36, 16, options, 4)->kind, displayfile::Pick::Kind::edge);
}

TEST(Application, ViewsARetainedScene) {
  displayfile::GraphicsSystem g;
  g.retain();
  g.open_segment(1);
  g.polygon_abs_3({{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0, 0.5, 0}});
  g.close_segment();
  displayfile::Renderer renderer;
  const displayfile::InView in = displayfile::in_view(g, g.view());
  const std::optional<displayfile::Pick> pick = renderer.seen_at(in, 0.5, 0.5);
  ASSERT_TRUE(pick);
  EXPECT_EQ(pick->segment, 1);
  EXPECT_TRUE(pick->world);
  using displayfile::HiddenMethod;
  for (const auto method : {HiddenMethod::z_buffer, HiddenMethod::bsp, HiddenMethod::map,
                            HiddenMethod::world_ray_cast}) {
    const displayfile::DrawOptions options{
        .width = 9, .height = 9, .surfaces = {.method = method}, .samples = 1};
    EXPECT_EQ(renderer.draw(in, options).pixels, displayfile::draw(g, options).pixels);
  }
}

/// A camera: the target is in the middle, up is up, and the fitted box fills the picture.
TEST(Application, LooksAtAPointAndFitsABox) {
  using displayfile::Point3;
  const Point3 low(10, 20, 30), high(14, 22, 31), middle = 0.5 * (low + high);
  const displayfile::View view = displayfile::look_at({1, 2, 90}, middle, {0, 1, 0}, 30.0);
  displayfile::GraphicsSystem g;
  g.set_view(view);
  EXPECT_EQ(g.view(), view);
  const std::optional<Point3> at = g.to_device(middle);
  ASSERT_TRUE(at);
  EXPECT_NEAR(at->x, 0.5, 1e-12);
  EXPECT_NEAR(at->y, 0.5, 1e-12);
  EXPECT_GT(g.to_device(middle + Point3(0, 1, 0))->y, 0.5);
  EXPECT_GT(g.to_device(middle + Point3(1, 0, 0))->x, 0.5);
  const double distance = glm::length(view.plane_normal);
  EXPECT_NEAR(view.window.y_max, distance * std::tan(std::acos(-1.0) / 12.0), 1e-9);

  for (const double aspect : {1.0, 2.0}) {
    displayfile::GraphicsSystem fitted;
    fitted.set_aspect_ratio(aspect);
    fitted.set_view(displayfile::fit(view, low, high, aspect));
    EXPECT_FALSE(fitted.counts().stretched_window);
    double left = 1.0, right = 0.0, bottom = 1.0, top = 0.0;
    for (int k = 0; k < 8; ++k) {
      const Point3 corner((k & 1) != 0 ? high.x : low.x, (k & 2) != 0 ? high.y : low.y,
                          (k & 4) != 0 ? high.z : low.z);
      const Point3 seen = fitted.to_device(corner).value();
      left = std::min(left, seen.x);
      right = std::max(right, seen.x);
      bottom = std::min(bottom, seen.y);
      top = std::max(top, seen.y);
      EXPECT_TRUE(seen.z >= 0.0 && seen.z <= 1.0) << seen.z;
    }
    EXPECT_NEAR(std::max(right - left, top - bottom), 0.9, 1e-9);
    EXPECT_NEAR(left + right, 1.0, 1e-9);
    EXPECT_NEAR(bottom + top, 1.0, 1e-9);
  }

  displayfile::View parallel = view;
  parallel.set_parallel(view.plane_normal);
  const std::vector<Point3> points{low, high};
  EXPECT_EQ(displayfile::fit(parallel, points).projection, displayfile::View::Projection::parallel);
}

TEST(Application, FitsWhatASystemRetains) {
  displayfile::GraphicsSystem g;
  const displayfile::View view = displayfile::look_at({0, 0, 50}, {0, 0, 0});
  EXPECT_THROW(displayfile::fit(view, g), displayfile::Error);
  g.retain();
  for (int name = 1; name <= 2; ++name) {
    g.open_segment(name);
    displayfile::box_3(g, {-1.0 * name, -1, -1}, {1.0 * name, 1, 1});
    g.close_segment();
  }
  g.set_visibility(2, false);
  EXPECT_EQ(displayfile::fit(view, g), displayfile::fit(view, {-1, -1, -1}, {1, 1, 1}));
}

TEST(Application, ACameraThatCannotBeIsAnError) {
  using displayfile::look_at;
  using displayfile::Point3;
  const auto refused = [](auto&& make) {
    try {
      make();
    } catch (const displayfile::Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refused([] {
              look_at({1, 2, 3}, {1, 2, 3});
            }),
            "the eye is at the target: expected another point");
  EXPECT_EQ(refused([] {
              look_at({0, 5, 0}, {0, 1, 0});
            }),
            "view up is along the line of sight: expected another direction");
  EXPECT_EQ(refused([] {
              look_at({0, 0, 5}, {0, 0, 0}, {0, 0, 0});
            }),
            "view up is zero: expected a direction");
  EXPECT_NE(refused([] { look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 180.0); }), "");
  EXPECT_NE(refused([] { look_at({0, 0, NAN}, {0, 0, 0}); }), "");
  const displayfile::View view = look_at({0, 0, 5}, {0, 0, 0});
  EXPECT_NE(refused([&] { displayfile::fit(view, std::vector<Point3>{}); }), "");
  EXPECT_NE(refused([&] { displayfile::fit(view, {-1, -1, 4}, {1, 1, 6}); }), "");  // behind it
  EXPECT_NE(refused([&] { displayfile::fit(view, {-1, -1, 0}, {1, 1, 1}, -1.0); }), "");

  displayfile::GraphicsSystem g;
  const displayfile::View before = g.view();
  displayfile::View wrong = view;
  wrong.window = {1, 0, 0, 1};
  EXPECT_NE(refused([&] { g.set_view(wrong); }), "");
  EXPECT_EQ(g.view(), before);
  EXPECT_FALSE(g.explicit_settings().contains_view());
}

/// One switch: all settings of a call are made, or none; those without a value stay.
TEST(Application, SetsHowHiddenSurfacesAreFound) {
  using displayfile::HiddenMethod;
  displayfile::GraphicsSystem g;
  g.set_hidden_surfaces({.removal = true, .method = HiddenMethod::bsp});
  g.set_hidden_surfaces({.hidden_lines = displayfile::HiddenLines::dashed});
  EXPECT_TRUE(g.hidden_surfaces().removal);
  EXPECT_TRUE(g.looks().attributes.back_face_removal);
  EXPECT_EQ(g.hidden_surfaces().method, HiddenMethod::bsp);
  EXPECT_EQ(g.hidden_surfaces().hidden_lines, displayfile::HiddenLines::dashed);
  EXPECT_THROW(g.set_hidden_surfaces({.removal = false,
                                      .method = HiddenMethod::map,
                                      .precision = displayfile::Precision{false, 2.0}}),
               displayfile::Error);
  EXPECT_TRUE(g.hidden_surfaces().removal);
  EXPECT_EQ(g.hidden_surfaces().method, HiddenMethod::bsp);

  std::ostringstream program;
  displayfile::Recorder recorder(program);
  g.set_recorder(&recorder);
  g.set_hidden_surfaces({.z_buffer = false, .method = HiddenMethod::map});
  EXPECT_EQ(program.str(), "set-hidden-method map\nset-z-buffer off\n");
}

/// An application's own device receives the pieces.
TEST(Application, DrawsOnADeviceOfItsOwn) {
  class Counter : public displayfile::OutputDevice {
   public:
    void fill(const displayfile::DrawnPolygon& polygon) override {
      ++fills;
      vertices += polygon.vertices.size();
    }
    void edges(const displayfile::DrawnPolygon& polygon) override {
      sides += static_cast<std::size_t>(
          std::ranges::count(polygon.sides, displayfile::DrawnPolygon::kDrawnSide));
    }
    void line(const displayfile::DrawnLine&) override { ++lines; }
    std::size_t fills = 0, vertices = 0, sides = 0, lines = 0;
  };
  displayfile::GraphicsSystem g;
  g.open_segment(1);
  g.polygon_abs_3({{-0.8, -0.8, 0}, {0.8, -0.8, 0}, {0.8, 0.8, 0}, {-0.8, 0.8, 0}});
  g.polygon_abs_3({{-0.4, -0.4, 0.5}, {0.4, -0.4, 0.5}, {0, 0.4, 0.5}});
  g.close_segment();
  Counter in_order, visible;
  displayfile::draw(g, in_order, {.surfaces = {.method = displayfile::HiddenMethod::none}});
  EXPECT_EQ(in_order.fills, 2u);
  EXPECT_EQ(in_order.vertices, 7u);
  EXPECT_EQ(in_order.sides, 7u);
  const displayfile::DrawOptions map{.surfaces = {.method = displayfile::HiddenMethod::map}};
  displayfile::draw(g, visible, map);
  const displayfile::DrawnPieces pieces = displayfile::drawn_pieces(g, map);
  using Kind = displayfile::DrawnPieces::Kind;
  const auto solid = static_cast<std::size_t>(std::ranges::count(pieces.kinds, Kind::solid));
  EXPECT_EQ(visible.fills, solid);
  EXPECT_GT(solid, 1u);
}

/// A system moves with all that it has; a copy has its own.
TEST(Application, SystemsAreCopiedAndMoved) {
  displayfile::GraphicsSystem g;
  g.open_segment(1);
  g.polygon_abs_3({{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}});
  g.close_segment();
  const std::string dumped = displayfile::dump(g.display_file());
  displayfile::GraphicsSystem copy = g;
  copy.delete_segment(1);
  EXPECT_EQ(displayfile::dump(g.display_file()), dumped);
  displayfile::GraphicsSystem moved = std::move(g);
  EXPECT_EQ(displayfile::dump(moved.display_file()), dumped);
  g = copy;
  EXPECT_NE(displayfile::dump(g.display_file()), dumped);
  const displayfile::DisplayFile& of_copy = copy.display_file();
  copy = moved;
  EXPECT_EQ(displayfile::dump(of_copy), dumped);
}

/// Every way to draw reports an invalid option, in a file and in memory the same.
TEST(Application, BadOptionsAreErrors) {
  using displayfile::DrawOptions;
  displayfile::GraphicsSystem g;
  const auto said = [](auto&& draw) -> std::string {
    try {
      draw();
    } catch (const displayfile::Error& error) {
      return error.what();
    }
    return "nothing";
  };
  const std::pair<DrawOptions, const char*> cases[] = {
      {DrawOptions{.surfaces = {.threads = -1}}, "-1 threads: expected 1 or more"},
      {DrawOptions{.surfaces = {.threads = 0}}, "0 threads: expected 1 or more"},
      {DrawOptions{.format = ".gif"}, "unknown picture format '.gif': expected one of "},
      {DrawOptions{.format = "pgn"}, "unknown picture format 'pgn': did you mean '.png'"},
      {DrawOptions{.device = "x"}, "unknown device 'x': expected "},
      {DrawOptions{.samples = 0}, "0 samples along a pixel's side: expected 1 to 16"},
      {DrawOptions{.width = 70000}, "picture size 70000x512: expected 1x1 to 65535x"},
      {DrawOptions{.width = 10000, .height = 9, .samples = 16},
       "picture size 10000x9 with 16 x 16 samples a pixel: expected 1x1 to 4095x4095 "}};
  for (const auto& wrong_and_why : cases) {
    const DrawOptions& wrong = wrong_and_why.first;
    const char* const what = wrong_and_why.second;
    EXPECT_TRUE(said([&] { draw(g, wrong); }).starts_with(what)) << said([&] { draw(g, wrong); });
    EXPECT_TRUE(said([&] { draw(g, "/dev/null/x.png", wrong); }).starts_with(what)) << what;
    EXPECT_TRUE(said([&] { displayfile::Renderer().draw(g, wrong); }).starts_with(what)) << what;
    EXPECT_TRUE(said([&] { displayfile::Renderer().pick(g, 1, 1, wrong); }).starts_with(what));
  }
  EXPECT_EQ(said([&] { draw(g, {.width = 4095, .height = 1, .samples = 16}); }), "nothing");
  EXPECT_EQ(said([&] { draw(g, {.width = 9, .height = 9, .format = ".PNG"}); }), "nothing");
  EXPECT_EQ(said([&] { draw(g, {.width = 9, .height = 9, .format = "svg"}); }), "nothing");
}

/// A link that is drawn already turns about its joint, a point of the model.
TEST(Application, TurnsAnImageAboutAPointOfTheModel) {
  displayfile::GraphicsSystem g;
  g.set_perspective({0, 0, 5});
  g.rotate_y_3(30);
  const displayfile::Point3 joint(0.5, 0.25, 0.5);
  g.open_segment(1);
  g.set_pick_id(3);
  g.polygon_abs_3({joint - displayfile::Point3(0.2, 0.2, 0), joint + displayfile::Point3(0.2, 0, 0),
                   joint + displayfile::Point3(0, 0.2, 0)});
  g.close_segment();
  const std::optional<displayfile::Point3> at = g.to_device(joint);
  ASSERT_TRUE(at);
  g.set_image_centre(1, at->x, at->y);
  displayfile::Renderer renderer;
  const displayfile::DrawOptions options{.width = 200, .height = 100, .samples = 1};
  const displayfile::Point2 pixel = displayfile::pixel_at(*at, options.width, options.height);
  for (int turn = 0; turn < 360; turn += 45) {
    g.set_image_rotation(1, turn);
    const auto pick = renderer.pick(g, pixel.x, pixel.y, options);
    ASSERT_TRUE(pick) << turn;
    EXPECT_EQ(pick->id, 3);
  }
}

/// A refused picture leaves the previous one unchanged, or discards all of it.
TEST(Renderer, ARefusedPictureIsWholeOrNone) {
  displayfile::GraphicsSystem g;
  g.open_segment(1);
  g.polygon_abs_3({{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}});
  g.close_segment();
  displayfile::Renderer renderer;
  const displayfile::Picture& picture =
      renderer.draw(g, {.width = 32, .height = 32, .samples = 1, .with_ids = true});
  const displayfile::Picture before = picture;
  for (const displayfile::DrawOptions& wrong :
       {displayfile::DrawOptions{.width = 0}, displayfile::DrawOptions{.samples = 99},
        displayfile::DrawOptions{.device = "x"}}) {
    EXPECT_THROW(renderer.draw(g, wrong), displayfile::Error);
    EXPECT_EQ(picture.width, 32);
    EXPECT_EQ(picture.pixels, before.pixels);
    EXPECT_EQ(picture.ids, before.ids);
  }
}

}  // namespace
