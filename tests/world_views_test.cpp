// Ray casting in object space as its users call it: pictures of retained scenes, and picking.

#include "interp/draw/world_views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "clip/base/error.h"
#include "clip/view/view_volume.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/views/turntable.h"
#include "interp/device/raster_request.h"
#include "interp/draw/draw.h"
#include "interp/raster/software.h"
#include "interp/truth/entered_truth.h"
#include "interp/truth/truth.h"
#include "interp/truth/world_truth.h"
#include "programs/scenes/generated_scenes.h"
#include "tests/gallery.h"
#include "tests/retained_truth.h"

namespace displayfile {
namespace {

using test::has_image_transformations;
using test::Retained;

constexpr int kWidth = 80, kHeight = 64;

DrawOptions options_of(HiddenMethod method) {
  DrawOptions options{.samples = 1};
  options.width = kWidth;
  options.height = kHeight;
  options.surfaces.method = method;
  options.with_ids = options.with_depth = true;
  return options;
}

/// Painted as by the z-buffer, hidden lines too.
void expect_right_painting(const Picture& picture, const DisplayFile& file,
                           HiddenLines hidden_lines = HiddenLines::none) {
  RasterRequest request;
  request.width = kWidth;
  request.height = kHeight;
  request.surfaces.method = HiddenMethod::z_buffer;
  request.ids = request.depth = true;
  request.surfaces.hidden_lines = hidden_lines;
  const Picture by_z_buffer = draw_with_software(file, request);
  EXPECT_EQ(picture.pixels, by_z_buffer.pixels);
  EXPECT_EQ(picture.depth, by_z_buffer.depth);
}

/// Seen as the truth is, and painted so.
void expect_right(const Picture& picture, const DisplayFile& file) {
  EXPECT_EQ(picture.ids, truth(file, kWidth, kHeight, false).ids);
  expect_right_painting(picture, file);
}

/// The same, except where the rounding of viewing decides: everywhere the picture is that of the
/// truth from the scene as entered. Returns the number of pixels where it decides.
std::size_t expect_right_unrounded(const Picture& picture, const Retained& retained) {
  const GraphicsSystem& system = retained.system;
  const DisplayFile& file = system.display_file();
  const EnteredTruth entered =
      entered_truth(retained.scene, file, kWidth, kHeight, false, std::nullopt);
  EXPECT_EQ(picture.ids, entered.picture.ids);
  const std::size_t other = different_pixels(picture, truth(file, kWidth, kHeight, false));
  if (other == 0) expect_right_painting(picture, file, system.hidden_surfaces().hidden_lines);
  return other;
}

/// Lines, light, shadows, smooth shading, clipping, several views in one picture. The terrain has
/// faces in the plane of the sea, which viewing, though it rounds, does not separate.
TEST(WorldViews, DrawTheGallery) {
  int drawn = 0;
  test::for_each_in_gallery([&](const std::string&, const Retained& retained) {
    const DisplayFile& file = retained.system.display_file();
    const DrawOptions options = options_of(HiddenMethod::world_ray_cast);
    if (has_image_transformations(file)) {
      EXPECT_THROW(draw(retained.system, options), Error);
      return;
    }
    const std::size_t other = expect_right_unrounded(draw(retained.system, options), retained);
    EXPECT_EQ(other, 0u);
    ++drawn;
  });
  EXPECT_GE(drawn, 10);
}

TEST(WorldViews, DrawAllViewsFromOneTreeOnSeveralThreads) {
  Retained retained;
  enter(generated_scene("city").make(300, 2), retained.system);
  const DisplayFile& file = retained.system.display_file();
  const Turntable turntable(retained.scene, file, {});
  const WorldViews trees(retained.scene, file);
  for (const double degrees : {0.0, 40.0, 130.0, 255.0}) {
    SCOPED_TRACE(degrees);
    const auto [view, lights] = turntable.at(degrees);
    const ViewedWorld world = trees.view(view, lights);
    DrawOptions options = options_of(HiddenMethod::world_ray_cast);
    const Picture picture = draw(world, options);
    expect_right(picture, world.display_file);
    EXPECT_GT(std::ranges::count_if(picture.ids, [](int id) { return id >= 0; }), 500);
    options.surfaces.threads = 3;
    EXPECT_EQ(draw(world, options).ids, picture.ids);
    options.samples = 2;
    EXPECT_EQ(draw(world, options).ids, picture.ids);
  }
}

/// Polygons of a mesh share their vertices, and rays go through common edges of neighbours.
TEST(WorldViews, DrawAMesh) {
  constexpr int kSide = 24;
  Mesh mesh;
  mesh.objects = {{"waves", 0, std::size_t{2} * kSide * kSide}};
  mesh.first_corner = {0};
  for (int i = 0; i <= kSide; ++i) {
    for (int j = 0; j <= kSide; ++j) {
      // Sheared, so that no edge runs through pixel centres, where rounding would decide.
      mesh.vertices.emplace_back(i / 8.0 + 0.0131 * j, j / 8.0 - 0.0173 * i,
                                 0.125 * ((i * i + 3 * j) % 5));
    }
  }
  for (std::uint32_t i = 0; i < kSide; ++i) {
    for (std::uint32_t j = 0; j < kSide; ++j) {
      const std::uint32_t a = i * (kSide + 1) + j, b = a + kSide + 1;
      for (const std::uint32_t corner : {a, b, b + 1}) mesh.corners.push_back(corner);
      mesh.first_corner.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
      for (const std::uint32_t corner : {a, b + 1, a + 1}) mesh.corners.push_back(corner);
      mesh.first_corner.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    }
  }
  Retained retained;
  retained.system.set_window(-0.5, 3.5, -0.5, 3.5);
  retained.system.set_perspective({1.0, -2.0, 6.0});
  retained.system.set_light({1.0, 2.0, 3.0});
  enter_mesh(mesh, retained.system, 1);
  const DisplayFile& file = retained.system.display_file();
  ASSERT_EQ(file.polygons(), std::size_t{2} * kSide * kSide);
  const Picture picture = draw(retained.system, options_of(HiddenMethod::world_ray_cast));
  expect_right(picture, file);
  EXPECT_GT(std::ranges::count_if(picture.ids, [](int id) { return id >= 0; }), 800);
}

/// Linear over depths that agree in all views: a parallel projection along z.
void enter_segment(GraphicsSystem& g, int name, const Rectangle& viewport, double z) {
  g.set_viewport(viewport.x_min, viewport.x_max, viewport.y_min, viewport.y_max);
  g.open_segment(name);
  g.polygon_abs_3({{-0.9, -0.9, z}, {0.9, -0.8, z}, {0.0, 0.9, -z}});
  g.close_segment();
}

TEST(WorldViews, OfSeveralViewsThatOverlapTheNearestIsSeen) {
  Retained retained;
  enter_segment(retained.system, 1, {0.0, 0.7, 0.0, 0.7}, 0.5);
  enter_segment(retained.system, 2, {0.2, 1.0, 0.2, 1.0}, 0.1);
  enter_segment(retained.system, 3, {0.1, 0.9, 0.3, 0.8}, 0.5);
  const Picture picture = draw(retained.system, options_of(HiddenMethod::world_ray_cast));
  expect_right(picture, retained.system.display_file());
  for (const int id : {0, 1, 2}) EXPECT_GT(std::ranges::count(picture.ids, id), 20) << id;
}

TEST(WorldViews, SettingTheMethodRetains) {
  GraphicsSystem g;
  g.set_hidden_surfaces({.removal = true});
  g.set_hidden_surfaces({.method = HiddenMethod::world_ray_cast});
  test::enter_two_segments(g);
  ASSERT_NE(g.retained(), nullptr);
  EXPECT_EQ(g.retained()->segments().size(), 2u);
  DrawOptions options = options_of(HiddenMethod::world_ray_cast);
  options.surfaces.method.reset();
  expect_right(draw(g, options), g.display_file());

  GraphicsSystem copy = g;  // has its own
  copy.delete_segment(4);
  copy.set_viewport(0.0, 0.5, 0.0, 1.0);
  EXPECT_EQ(g.retained()->segments().size(), 2u);
  expect_right(draw(copy, options), copy.display_file());
  expect_right(draw(g, options), g.display_file());
  g.set_visibility(4, false);
  expect_right(draw(g, options), g.display_file());
  g.retain(nullptr);
  EXPECT_THROW(draw(g, options), Error);
}

TEST(WorldViews, RefuseWhatTheyCannotDraw) {
  GraphicsSystem g;
  test::enter_two_segments(g);
  EXPECT_THROW(draw(g, options_of(HiddenMethod::world_ray_cast)), Error);
  EXPECT_THROW(g.set_hidden_surfaces({.method = HiddenMethod::world_ray_cast}), Error);
  EXPECT_EQ(g.hidden_surfaces().method, HiddenMethod::automatic);
  EXPECT_EQ(g.retained(), nullptr);

  Retained retained;
  test::enter_two_segments(retained.system);
  DrawOptions options = options_of(HiddenMethod::world_ray_cast);
  EXPECT_NO_THROW(draw(retained.system, options));
  options.surfaces.precision = Precision{.exact = false, .roundoff = 1e-6};
  EXPECT_THROW(draw(retained.system, options), Error);
  options.surfaces.precision.reset();
  retained.system.set_hidden_surfaces({.precision = Precision{.exact = false, .roundoff = 1e-6}});
  EXPECT_THROW(draw(retained.system, options), Error);
  retained.system.set_hidden_surfaces({.precision = Precision{}});
  retained.system.set_image_translation(2, 0.1, 0.0);
  EXPECT_THROW(draw(retained.system, options), Error);
}

// ---- Picking ---------------------------------------------------------------------------

/// At every pixel's centre the item buffer's identifier; the returned place maps back to the
/// centre.
TEST(Picking, TellsWhatIsSeenAndWhere) {
  Retained retained;
  test::enter_two_segments(retained.system);
  const DisplayFile& file = retained.system.display_file();
  const View& view = retained.system.view();
  const WorldViews world(retained.scene, file);
  const ViewVolume volume(view);
  const Picture right = truth(file, kWidth, kHeight, true);
  int hits = 0;
  for (int row = 0; row < kHeight; ++row) {
    for (int column = 0; column < kWidth; ++column) {
      // 1/160 is not a double: the points are those of pixels up to rounding.
      const double x = (column + 0.5) / kWidth, y = (row + 0.5) / kHeight;
      const auto k = static_cast<std::size_t>((kHeight - 1 - row) * kWidth + column);
      const auto pick = world.pick(view, x, y);
      ASSERT_EQ(pick ? pick->id : -1, right.ids[k]) << column << "," << row;
      if (!pick) continue;
      ++hits;
      EXPECT_EQ(pick->segment, pick->id >= 70 ? 2 : 4);
      const HomogeneousPoint p = volume.transform(*pick->world);
      EXPECT_NEAR(p.x / p.w, x, 1e-14);
      EXPECT_NEAR(p.y / p.w, y, 1e-14);
      EXPECT_NEAR(p.z / p.w, right.depth[k], 1e-14);
      EXPECT_NEAR(pick->depth, right.depth[k], 1e-14);
      EXPECT_EQ(pick->kind, Pick::Kind::polygon);
    }
  }
  EXPECT_GT(hits, 500);
}

/// The smaller part of a bow tie, which the window leaves, turns its light face to the viewer.
TEST(Picking, ThroughBackFacesByWhatClippingLeaves) {
  Retained retained;
  GraphicsSystem& g = retained.system;
  g.set_back_face_removal(true);
  g.set_window(-1, -0.2, -0.4, 0.4);
  g.open_segment(1);
  g.polygon_abs_3({{-0.5, 0.5, 0.0}, {-0.5, -0.5, 0.0}, {3.0, 4.0, 0.0}, {3.0, -4.0, 0.0}});
  g.close_segment();
  const WorldViews world(retained.scene, g.display_file());
  EXPECT_TRUE(world.pick(g.view(), 0.75, 0.5));
  EXPECT_FALSE(world.pick(g.view(), 0.5, 0.5));  // left of it
  View whole = g.view();
  whole.set_window({-5, 5, -5, 5});
  EXPECT_FALSE(world.pick(whole, 0.455, 0.5));  // the same point: the larger part decides
}

/// A vertex off the plane, within the tolerance, does not move in the picture.
TEST(Picking, VerticesOffThePlaneAreSeenWhereTheyAre) {
  Retained retained;
  const GraphicsSystem& g = retained.system;
  test::draw_vertex_off_its_plane(retained.system);
  const WorldViews world(retained.scene, g.display_file());
  for (const double aside : {-0.01, 0.01}) {  // of the vertex, which is seen 8e-7 lower
    EXPECT_EQ(world.pick(g.view(), 0.5 + aside, 0.3).has_value(), aside > 0.0) << aside;
  }
}

/// Common edges and corners belong to one polygon alone, and of coplanar ones the later is visible.
TEST(Picking, DecidesExactly) {
  Retained retained;
  GraphicsSystem& g = retained.system;
  g.open_segment(8);
  g.polygon_abs_3({{-0.5, -0.5, 0.0}, {0.0, -0.5, 0.0}, {0.0, 0.5, 0.0}, {-0.5, 0.5, 0.0}});
  g.polygon_abs_3({{0.0, -0.5, 0.0}, {0.5, -0.5, 0.0}, {0.5, 0.5, 0.0}, {0.0, 0.5, 0.0}});
  g.close_segment();
  g.open_segment(9);
  g.polygon_abs_3({{0.25, -0.5, 0.0}, {0.5, -0.5, 0.0}, {0.5, 0.0, 0.0}, {0.25, 0.0, 0.0}});
  g.close_segment();
  const WorldViews world(retained.scene, g.display_file());
  const auto at = [&](double x, double y) { return world.pick(g.view(), x, y); };
  const double half = 0.5, below = std::nextafter(half, 0.0), above = std::nextafter(half, 1.0);
  EXPECT_EQ(at(below, 0.6)->id, 0);
  EXPECT_EQ(at(half, 0.6)->id, 1);
  EXPECT_EQ(at(0.625, above)->id, 1);
  EXPECT_EQ(at(0.625, half)->id, 2);
  EXPECT_EQ(at(0.625, half)->segment, 9);
  EXPECT_EQ(at(0.625, half)->world, Point3(0.25, 0.0, 0.0));
  EXPECT_FALSE(at(0.75, 0.6));  // a right edge is not covered
  EXPECT_TRUE(at(std::nextafter(0.75, 0.0), 0.6));
  EXPECT_FALSE(at(-0.1, 0.5));
  EXPECT_FALSE(at(0.5, 1e300));
  EXPECT_THROW(at(std::nan(""), 0.5), Error);
}

}  // namespace
}  // namespace displayfile
