// The one header that an application includes, in the source tree: nothing else of Display File is
// included here. tests/package_test has it installed.

#include "displayfile/displayfile.h"

#include <gtest/gtest.h>

#include <array>
#include <sstream>

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
  displayfile::DrawOptions options;
  options.width = options.height = 16;
  options.hidden = displayfile::HiddenMethod::z_buffer;
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
  EXPECT_EQ(g.polygons_entered(), 1);
}

TEST(Application, AnimatesAndPicks) {
  displayfile::GraphicsSystem g;
  displayfile::Renderer renderer;
  const displayfile::DrawOptions options{.width = 40, .height = 40, .with_ids = true};
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
  displayfile::RetainedScene scene;
  g.retain(&scene);
  g.open_segment(1);
  g.polygon_abs_3({{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0, 0.5, 0}});
  g.close_segment();
  displayfile::Renderer renderer;
  const displayfile::InView in = displayfile::in_view(g, g.view());
  EXPECT_EQ(renderer.display_file(in).polygons(), 1u);
  const std::optional<displayfile::Pick> pick = renderer.pick(in, 0.5, 0.5);
  ASSERT_TRUE(pick);
  EXPECT_EQ(pick->segment, 1);
  EXPECT_TRUE(pick->world);
  using displayfile::HiddenMethod;
  for (const auto method : {HiddenMethod::z_buffer, HiddenMethod::bsp, HiddenMethod::map,
                            HiddenMethod::world_ray_cast}) {
    const displayfile::DrawOptions options{.width = 9, .height = 9, .hidden = method};
    EXPECT_EQ(renderer.draw(in, options).pixels, displayfile::draw(g, options).pixels);
  }
}

/// Every way to draw says what is wrong with an option, and in a file and in memory the same.
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
      {DrawOptions{.threads = -1}, "-1 threads: expected 1 or more"},
      {DrawOptions{.threads = 0}, "0 threads: expected 1 or more"},
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
  const displayfile::DrawOptions options{.width = 200, .height = 100};
  const displayfile::Point2 pixel = displayfile::pixel_at(*at, options.width, options.height);
  for (int turn = 0; turn < 360; turn += 45) {
    g.set_image_rotation(1, turn);
    const auto pick = renderer.pick(g, pixel.x, pixel.y, options);
    ASSERT_TRUE(pick) << turn;
    EXPECT_EQ(pick->id, 3);
  }
}

/// A picture that was refused leaves the one before as it is, or gives it up whole.
TEST(Renderer, ARefusedPictureIsWholeOrNone) {
  displayfile::GraphicsSystem g;
  g.open_segment(1);
  g.polygon_abs_3({{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}});
  g.close_segment();
  displayfile::Renderer renderer;
  const displayfile::Picture& picture =
      renderer.draw(g, {.width = 32, .height = 32, .with_ids = true});
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
