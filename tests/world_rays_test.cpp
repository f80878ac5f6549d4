// Ray casting in object space: the hits of its rays, compared with the truth of each view.

#include "interp/visibility/world_rays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "clip/base/error.h"
#include "clip/view/view_volume.h"
#include "interp/truth/entered_truth.h"
#include "interp/truth/truth.h"
#include "interp/visibility/world_geometry.h"
#include "programs/scenes/generated_scenes.h"
#include "programs/scenes/hard_cases.h"
#include "tests/from_environment.h"
#include "tests/random_views.h"
#include "tests/retained_truth.h"
#include "tests/scenes_that_clip.h"
#include "tests/slower.h"

namespace displayfile {
namespace {

using test::from_environment;
using test::has_image_transformations;
using test::Source;

/// A scene as the application drew it and as it was retained.
struct Retained : test::Retained {
  Retained() = default;
  explicit Retained(const Scene& drawn) { enter(drawn, system); }
  WorldRays rays() const { return {scene, system.display_file()}; }
  /// From the scene as entered.
  std::vector<std::int32_t> truth(const PictureSize& size) const {
    return entered_truth(scene, system.display_file(), size.width, size.height, false, std::nullopt)
        .picture.ids;
  }
};

/// The same scene as the application would have drawn it in another view.
Scene in_view(Scene scene, const View& view) {
  scene.view = view;
  for (Scene::Segment& segment : scene.segments) segment.view.reset();
  return scene;
}
/// The exact truth of the display file that the scene makes in the view.
std::vector<std::int32_t> truth_in(const Scene& scene, const View& view, int size) {
  return truth(entered(in_view(scene, view)).display_file(), size, size, false).ids;
}
/// The exact truth from the scene as entered, of the same.
std::vector<std::int32_t> entered_truth_in(const Scene& scene, const View& view, int size) {
  return Retained(in_view(scene, view)).truth({size, size});
}

TEST(WorldRays, NoWrongPixelFromAnyEye) {
  const int eyes = from_environment("DISPLAYFILE_WORLD_RAYS_EYES", 12);
  const int size = from_environment("DISPLAYFILE_WORLD_RAYS_SIZE", 48);
  for (const GeneratedScene& generated : generated_scenes()) {
    const Scene scene = generated.make(generated.name == "planes" ? 16 : 200, 1);
    const Retained retained(scene);
    const WorldRays rays = retained.rays();
    const test::Ball3 ball = test::ball_around(scene.points);
    Source s(1);
    std::ptrdiff_t hits = 0;
    for (int i = 0; i < eyes; ++i) {
      const View view =
          i % 2 == 0 ? test::any_parallel_view(s, ball) : test::any_perspective_view(s, ball);
      const auto seen = rays.picks(view, {size, size}, 1 + i % 3);
      ASSERT_EQ(seen, truth_in(scene, view, size)) << generated.name << "\n" << test::text_of(view);
      hits += std::ssize(seen) - std::ranges::count(seen, -1);
    }
    EXPECT_GT(hits, eyes * size * size / 50) << generated.name;
  }
}

/// Front and back planes, a viewport that is a part of the picture, and a picture that is no
/// square.
TEST(WorldRays, NoWrongPixelInViewsThatClip) {
  const Scene city = generated_scene("city").make(300, 2);
  const Retained retained(city);
  const WorldRays rays = retained.rays();
  const test::Ball3 ball = test::ball_around(city.points);
  Source s(3);
  for (int i = 0; i < 16; ++i) {
    View view = test::any_view(s, ball);
    view.front_clipping = i % 2 == 0;
    view.back_clipping = i % 3 == 0;
    view.set_depth(-0.1 * ball.radius, 0.3 * ball.radius);
    if (i % 4 == 1) view.set_viewport({0.25, 0.75, 0.125, 1.0});
    Scene scene = city;
    scene.view = view;
    const auto seen = rays.picks(view, {64, 40});
    GraphicsSystem system;
    system.set_viewport(view.viewport.x_min, view.viewport.x_max, view.viewport.y_min,
                        view.viewport.y_max);
    enter(scene, system);
    const auto right = truth(system.display_file(), 64, 40, false).ids;
    std::size_t wrong = 0, first = 0;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      if (seen[k] != right[k] && wrong++ == 0) first = k;
    }
    EXPECT_EQ(wrong, 0u) << "view " << i << ", pixel " << first % 64 << "," << 39 - first / 64
                         << ": " << seen[first] << ", truth " << right[first] << "; "
                         << test::text_of(view);
  }
}

PixelCentre centre_of_index(std::size_t k, const PictureSize& size) {
  const int i = static_cast<int>(k);
  return {i % size.width, size.height - 1 - i / size.width, size};
}

/// Views in which much is edge-on or ties: from a vertex, or along an axis.
View special_view(Source& s, const Scene& scene, const test::Ball3& ball) {
  Point3 axis(0.0);
  axis[s.below(3)] = s.below(2) == 0 ? 1.0 : -1.0;
  if (s.below(2) == 0) {
    const auto any = static_cast<std::size_t>(s.below(static_cast<int>(scene.points.size())));
    return test::perspective_view(scene.points[any], axis, 1.0, ball);
  }
  return test::parallel_view(axis, axis, ball);
}

/// On scenes made to break methods, pictures may differ from the truth of the display file only
/// where the rounding of viewing decides: everywhere they equal the truth from world coordinates.
TEST(WorldRays, DifferOnlyWhereTheRoundingOfViewingDecides) {
  const int eyes = from_environment("DISPLAYFILE_WORLD_RAYS_EYES", 2);
  const int size = from_environment("DISPLAYFILE_WORLD_RAYS_SIZE", 16);
  std::size_t pixels = 0, views = 0, rounding = 0;
  for (const HardCase& family : hard_cases()) {
    std::size_t of_family = 0;
    for (const double severity : family.severities) {
      const Scene scene = family.make(family.size, severity, 1);
      const Retained retained(scene);
      if (has_image_transformations(retained.system.display_file())) continue;  // after viewing
      const WorldRays rays = retained.rays();
      const test::Ball3 ball = test::ball_around(scene.points);
      Source s(1);
      for (int i = 0; i < eyes; ++i) {
        const View view = i % 2 == 0 ? special_view(s, scene, ball) : test::any_view(s, ball);
        const auto seen = rays.picks(view, {size, size});
        ASSERT_EQ(seen, entered_truth_in(scene, view, size))
            << family.name << " " << severity << "\n"
            << test::text_of(view);
        const auto right = truth_in(scene, view, size);
        for (std::size_t k = 0; k < seen.size(); ++k) of_family += seen[k] != right[k] ? 1 : 0;
        ++views;
        pixels += seen.size();
      }
    }
    if (of_family > 0) std::cout << family.name << ": " << of_family << "\n";
    rounding += of_family;
  }
  std::cout << rounding << " of " << pixels << " pixels in " << views
            << " views are as the rounding of viewing decides\n";
  EXPECT_GT(rounding, 0u) << "the check was never put to work";
}

// ---- Polygons that a view may turn over, or that are not quite flat ----------------------------

/// The visible polygons, which must be those of the truth from the scene as entered.
std::vector<std::int32_t> seen_as_in_truth(const Retained& retained, const PictureSize& size) {
  const View& view = retained.system.view();
  auto seen = retained.rays().picks(view, size);
  EXPECT_EQ(seen, retained.truth(size)) << test::text_of(view);
  return seen;
}

/// A bow tie, of whose two parts clipping leaves the smaller one, and perspective makes the smaller
/// one the larger: these turn their light face to the viewer, and the whole bow tie its dark one.
TEST(WorldRays, BackFacesAreThoseOfWhatClippingLeaves) {
  const Polygon bow_tie = {{-0.5, 0.5, 0.0}, {-0.5, -0.5, 0.0}, {3.0, 4.0, 0.0}, {3.0, -4.0, 0.0}};
  const Polygon leaning = {
      {-0.5, 0.5, 2.0}, {-0.5, -0.5, 2.0}, {0.5, 0.8, -6.0}, {0.5, -0.8, -6.0}};
  const auto seen = [](const Polygon& polygon, auto&& set_view) {
    Retained retained;
    GraphicsSystem& g = retained.system;
    g.set_line_style({LineStyle::Kind::none});
    set_view(g);
    g.set_back_face_removal(true);
    g.open_segment(1);
    g.polygon_abs_3(polygon);
    g.close_segment();
    return std::ranges::count(seen_as_in_truth(retained, {32, 32}), 0);
  };
  const auto whole_window = [](GraphicsSystem& g) { g.set_window(-5, 5, -5, 5); };
  EXPECT_EQ(seen(bow_tie, whole_window), 0);
  EXPECT_EQ(seen(bow_tie, [](GraphicsSystem& g) { g.set_window(-1, -0.2, -0.4, 0.4); }), 280);
  EXPECT_EQ(seen(leaning, whole_window), 0);
  const auto near_eye = [](GraphicsSystem& g) { g.set_perspective({0.0, 0.0, 3.0}); };
  EXPECT_EQ(seen(leaning, near_eye), 248);
  const auto front_plane = [&](GraphicsSystem& g) {
    near_eye(g);
    g.set_view_depth(0.0, 10.0);
    g.set_front_plane_clipping(true);
  };
  EXPECT_EQ(seen(leaning, front_plane), 0);
}

TEST(WorldRays, VerticesOffThePlaneAreSeenWhereTheyAre) {
  Retained retained;
  test::draw_vertex_off_its_plane(retained.system);
  EXPECT_EQ(std::ranges::count(seen_as_in_truth(retained, {32, 32}), 0), 210);
}

/// Twisted, and so thin in the picture that in doubles it is edge-on: it covers the middle column.
TEST(WorldRays, PolygonsThatAreEdgeOnForDoublesAloneAreSeen) {
  Retained retained;
  GraphicsSystem& g = retained.system;
  g.open_segment(1);
  g.polygon_abs_3(
      {{-3e-18, -0.5, -0.5}, {1e-18, -0.5, 0.5}, {1e-18, 0.5, 0.5}, {-1e-18, 0.5, -0.5}});
  g.close_segment();
  EXPECT_EQ(std::ranges::count(seen_as_in_truth(retained, {9, 8}), 0), 4);
}

/// A polygon so steep that a vertex off its plane, within the tolerance, is nearer in the plane
/// than all vertices are, and than the polygons in front of these.
TEST(WorldRays, PolygonsMayBeSeenNearerThanTheirVertices) {
  Retained retained;
  GraphicsSystem& g = retained.system;
  constexpr double kHeight = 5e-6;
  g.set_window(-0.2, 1.2, -0.2 * kHeight, 1.2 * kHeight);
  g.open_segment(1);
  g.polygon_abs_3({{0, 0, 0}, {0.6, 0.3 * kHeight, 0.2}, {1, kHeight, 0}, {0, kHeight, -1}});
  g.polygon_abs_3({{-1, -1, 0.25}, {2, -1, 0.25}, {2, 1, 0.25}, {-1, 1, 0.25}});
  g.close_segment();
  ASSERT_EQ(retained.scene.size(), 2u) << "cut into triangles";
  EXPECT_GT(std::ranges::count(seen_as_in_truth(retained, {64, 64}), 0), 5);
  EXPECT_EQ(retained.rays().seen_at(g.view(), {0.56, 0.36})->primitive, 0u);
}

/// Ground with a corner that is raised to above the eye, within the tolerance: there its plane
/// appears beyond infinity, and so is no nearer than the wall behind it.
TEST(WorldRays, WhatIsSeenAboveTheHorizonOfItsPlaneHidesNothing) {
  Retained retained;
  GraphicsSystem& g = retained.system;
  constexpr double kEye = 1e-6;
  g.set_perspective({0.0, kEye, 8.0});
  g.set_window(-4.0, 4.0, -4.0 * kEye, 5.0 * kEye);
  g.open_segment(1);
  g.polygon_abs_3({{-1, 0, -0.5}, {-1, 0, 6}, {1, 0, 6}, {1, 3.0 * kEye, -0.5}});
  g.polygon_abs_3({{-9, -9, -1}, {9, -9, -1}, {9, 9, -1}, {-9, 9, -1}});
  g.close_segment();
  ASSERT_EQ(retained.scene.size(), 2u) << "cut into triangles";
  const auto seen = seen_as_in_truth(retained, {32, 32});
  EXPECT_GT(std::ranges::count(seen, 0), 100);
  EXPECT_EQ(std::ranges::count(seen, -1), 0);
}

/// A polygon in an arbitrary plane, sometimes concave or self-crossing, bent by rounding; and some
/// within the tolerance too.
Polygon turned(Source& s) {
  const Point3 normal = test::any_direction(s);
  const Point3 u = glm::normalize(glm::cross(normal, test::any_direction(s)));
  const Point3 v = glm::cross(normal, u), middle{s.unit(), s.unit(), s.unit()};
  const bool more = s.below(2) == 0;
  Polygon polygon;
  for (int sides = s.between(4, 7); sides > 0; --sides) {
    const double a = s.between(-4, 4) / 4.0, b = s.between(-4, 4) / 4.0;
    const double off = more ? 8e-7 * (s.unit() - 0.5) : 0.0;
    polygon.push_back(middle + a * u + b * v + off * normal);
  }
  return polygon;
}

/// The polygon entered last, with its vertices moved by about as little as a tolerance.
Polygon beside_the_last(Source& s, const Scene& scene) {
  Polygon polygon(scene.points.end() - scene.sides.back(), scene.points.end());
  const Point3 away = std::pow(0.1, s.between(6, 16)) * test::any_direction(s);
  for (Point3& p : polygon) p += away;
  return polygon;
}

/// The same view of a very small part of the scene about a point.
View magnified(const View& view, const Point3& about, double half) {
  const HomogeneousPoint seen = ViewVolume(view).transform(about);
  const Rectangle& window = view.window;
  const double x = window.x_min + (window.x_max - window.x_min) * (seen.x / seen.w);
  const double y = window.y_min + (window.y_max - window.y_min) * (seen.y / seen.w);
  View nearer = view;
  nearer.set_window({x - half, x + half, y - half, y + half});
  return nearer;
}

/// Along a side of a polygon, or nearly: its plane is edge-on, except for a tilt.
View grazing_view(Source& s, const Scene& scene, std::size_t first) {
  const Point3 from = scene.points[first], to = scene.points[first + 1];
  Point3 into = to - from;
  if (glm::length(into) < 0.1) into = {1.0, 0.0, 0.0};
  into += std::pow(0.1, s.between(2, 17)) * test::any_direction(s);
  const test::Ball3 ball = test::ball_around(scene.points);
  return s.below(2) == 0 ? test::parallel_view(into, into, ball)
                         : test::perspective_view(from - 1.5 * into, into, 1.0, ball);
}

/// A view that clips, edge-on to some, or one of so small a part that a tolerance is seen.
View any_difficult_view(Source& s, const Scene& scene) {
  const auto any = static_cast<std::size_t>(s.below(static_cast<int>(scene.points.size()) - 1));
  const int kind = s.below(4);
  if (kind == 0) return special_view(s, scene, test::ball_around(scene.points));
  const View view = s.below(2) == 0 ? test::any_clipping_view(s) : grazing_view(s, scene, any);
  const bool behind = ViewVolume(view).transform(scene.points[any]).w < 0.1;
  if (kind == 1 || behind) return view;
  return magnified(view, scene.points[any], std::pow(0.1, s.between(1, 7)));
}

/// The hits of a picture and of single points, at centres that are doubles, are the truth's.
std::ptrdiff_t hits_as_in_truth(const Retained& retained) {
  constexpr PictureSize kSize{16, 8};
  const auto seen = seen_as_in_truth(retained, kSize);
  const WorldRays rays = retained.rays();
  for (std::size_t k = 0; k < seen.size(); ++k) {
    const PixelCentre centre = centre_of_index(k, kSize);
    const auto at = rays.seen_at(retained.system.view(), {centre.x, centre.y});
    EXPECT_EQ(at ? rays.scene()[at->primitive].pick : -1, seen[k]) << "pixel " << k;
  }
  return std::ssize(seen) - std::ranges::count(seen, -1);
}

/// Scenes of a few polygons by their seeds, until one fails.
void expect_truth_of(Scene (*any_scene)(Source&), int usual) {
  const int scenes = from_environment("DISPLAYFILE_WORLD_RAYS_SCENES", usual / test::kSlower);
  std::ptrdiff_t hits = 0;
  for (int seed = 0; seed < scenes && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Source s(static_cast<std::uint64_t>(seed));
    const Scene scene = any_scene(s);
    Retained retained;
    GraphicsSystem& g = retained.system;
    g.set_back_face_removal(s.below(2) == 0);
    const Rectangle& port = scene.view.viewport;
    g.set_viewport(port.x_min, port.x_max, port.y_min, port.y_max);
    enter(scene, g);
    hits += hits_as_in_truth(retained);
  }
  EXPECT_GT(hits, 5 * scenes);
}

Scene any_polygons(Source& s) {
  Scene scene;
  for (int n = s.between(1, 4); n > 0; --n) {
    constexpr std::array kKinds{test::triangle, test::flat, test::bent, turned, turned};
    scene.add(kKinds[static_cast<std::size_t>(s.below(5))](s));
    if (s.below(4) == 0) scene.add(beside_the_last(s, scene));
  }
  scene.view = any_difficult_view(s, scene);
  return scene;
}
TEST(WorldRays, SeeOfAnyPolygonsWhatTheTruthSays) { expect_truth_of(any_polygons, 2000); }

/// Polygons so steep that the small distances of their vertices from a plane change their depth by
/// as much as their extent in depth, in perspective to beyond infinity; between others that face
/// the viewer. Vertices are on the window's sides up to rounding.
Scene steep_polygons(Source& s) {
  constexpr double kEye = 8.0;
  const bool perspective = s.below(2) == 0;
  const double height = std::pow(0.1, s.between(4, 6));
  Scene scene;
  scene.view = View();
  scene.view.set_window({0.0, 1.0, 0.0, height});
  if (perspective) scene.view.set_perspective({0.0, 0.0, kEye});
  scene.view.front_clipping = s.below(4) == 0;
  scene.view.back_clipping = s.below(4) == 0;
  // The point seen at x, y of the picture with that nearness: linear over the picture of a plane.
  const auto at = [&](double x, double y, double nearness) -> Point3 {
    const double z = perspective ? kEye - 1.0 / std::max(nearness, 0.001) : nearness;
    const double size = perspective ? (kEye - z) / kEye : 1.0;
    return {x * size, y * height * size, z};
  };
  const auto any_nearness = [&] { return perspective ? 0.3 * s.unit() : 2.0 * s.unit() - 1.0; };
  for (int n = s.between(1, 3); n > 0; --n) {
    const double here = any_nearness(), along_x = any_nearness() - here;
    const double along_y = any_nearness() - here;
    Polygon polygon;
    for (int sides = s.between(4, 6); sides > 0; --sides) {
      const double x = s.between(-1, 5) / 4.0, y = s.between(-1, 5) / 4.0;
      const double off = 1e-7 / height * s.between(-4, 4);
      polygon.push_back(at(x, y + off, here + x * along_x + y * along_y));
    }
    scene.add(polygon);
    const double behind = any_nearness();
    scene.add({at(-1, -1, behind), at(2, -1, behind), at(2, 2, behind), at(-1, 2, behind)});
  }
  return scene;
}
TEST(WorldRays, SeeOfSteepPolygonsWhatTheTruthSays) { expect_truth_of(steep_polygons, 1000); }

/// Vertices at pixel centres, and edges along rows and columns of them: of each such edge one side
/// covers the centres.
TEST(WorldRays, EdgesThroughPixelCentresCoverAsTheTruthSays) {
  Source s(11);
  Retained retained;
  GraphicsSystem& g = retained.system;
  g.set_window(-1.0, 1.0, -1.0, 1.0);
  g.set_back_face_removal(false);
  const auto centre = [&] { return -1.0 + (2.0 * std::floor(s.between(0.0, 32.0)) + 1.0) / 32.0; };
  g.open_segment(1);
  for (int i = 0; i < 20; ++i) {
    const double x0 = centre(), x1 = centre(), y0 = centre(), y1 = centre();
    if (x0 == x1 || y0 == y1) continue;
    const double z = s.between(-1.0, 1.0);
    g.polygon_abs_3({{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}});
    g.polygon_abs_3({{x0, y0, -z}, {x1, centre(), z}, {centre(), y1, -z}});
  }
  g.close_segment();
  EXPECT_GT(std::ranges::count(seen_as_in_truth(retained, {32, 32}), -1), 0);
}

/// The matrix's entries are rounded, so that by them the face that is nearest lies outside.
TEST(WorldRays, FacesOnTheFrontPlaneAreSeen) {
  Retained retained;
  GraphicsSystem& g = retained.system;
  g.set_perspective({2.0, 1.0, 3.0});
  g.set_view_depth(-1.0, 1.0);
  g.set_front_plane_clipping(true);
  g.open_segment(1);
  g.polygon_abs_3({{-1, 0.5, 1}, {1, 0.5, 1}, {1, 1.5, 1}, {-1, 1.5, 1}});
  g.polygon_abs_3({{-1, 0.5, -0.5}, {1, 0.5, -0.5}, {1, 1.5, -0.5}, {-1, 1.5, -0.5}});
  g.close_segment();
  EXPECT_EQ(std::ranges::count(seen_as_in_truth(retained, {32, 32}), 0), 288);
}

// ---- Invisible polygons ------------------------------------------------------------------------

TEST(WorldRays, BackFacesRemovedAndHollowFillsNotSeen) {
  RetainedScene scene;
  GraphicsSystem g;
  g.retain(&scene);
  g.set_line_style({LineStyle::Kind::none});
  g.open_segment(1);
  g.set_back_face_removal(true);
  g.polygon_abs_3({{-0.9, -0.9, 0.5}, {-0.9, 0.9, 0.5}, {0.1, 0.0, 0.5}});  // a back face
  g.polygon_abs_3({{-0.9, -0.9, 0.3}, {0.1, 0.0, 0.3}, {-0.9, 0.9, 0.3}});
  g.set_fill_style({FillStyle::Kind::hollow});
  g.polygon_abs_3({{-0.9, -0.9, 0.9}, {0.9, -0.9, 0.9}, {0.9, 0.9, 0.9}, {-0.9, 0.9, 0.9}});
  g.close_segment();
  const WorldRays rays(scene, g.display_file());
  const auto seen = rays.picks(g.view(), {32, 32});
  EXPECT_EQ(seen, truth(g.display_file(), 32, 32, false).ids);
  EXPECT_GT(std::ranges::count(seen, 1), 100);

  g.set_visibility(1, false);
  EXPECT_EQ(WorldRays(scene, g.display_file()).polygons(), 0u);
  g.set_visibility(1, true);
  g.set_image_translation(1, 0.5, 0.0);
  EXPECT_THROW(WorldRays(scene, g.display_file()), Error);
}

}  // namespace
}  // namespace displayfile
