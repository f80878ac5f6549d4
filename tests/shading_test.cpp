// The guarantees of Gouraud shading: the intensities are those of the vertices' normals, run
// linearly over the picture of each triangle whatever clips or sorts it, and change no pixel's
// polygon. OpenGL's own interpolation (OSMesa) is the independent judge.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "clip/geometry/unit.h"
#include "displayfile/entered/normal_plane.h"
#include "displayfile/files.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/segments/sorted_display_file.h"
#include "displayfile/text/dump_compare.h"
#include "displayfile/views/retained_views.h"
#include "interp/device/raster_request.h"
#include "interp/draw/draw.h"
#include "interp/files/picture_compare.h"
#include "interp/opengl/osmesa.h"
#include "interp/raster/software.h"
#include "interp/vector/svg_device.h"
#include "interp/visibility/image_space.h"
#include "tests/error_of.h"
#include "tests/mesa_leaks.h"
#include "tests/shaded_scenes.h"
#include "tests/temporary_folder.h"
#include "tests/truth_scenes.h"

namespace displayfile {
namespace {

using test::ball;
using test::Dice;
using test::drawn;
using test::enter;
using test::error_of;
using test::expect_one_picture_by_all_methods;
using test::intensity_of;
using test::kAmbient;
using test::kFill;
using test::kLight;
using test::picture;
using test::triangles;
using Scene = test::ShadedScene;

/// The contents of the display file: the polygons, each with its intensities and fill colour.
struct Held {
  struct Polygon {
    std::vector<Point3> vertices;
    std::vector<double> intensities;
    FillStyle fill;
  };
  std::vector<Polygon> polygons;
  FillStyle style;
  std::vector<double> next;

  explicit Held(const GraphicsSystem& g) {
    for (const Segment& s : g.display_file().segments()) s.walk_entered(*this);
  }
  void fill(const FillStyle& s) { style = s; }
  void line_style(const LineStyle&) {}
  void pick(int) {}
  void move(const Point3&) {}
  void line(const Point3&) {}
  void intensities(std::span<const double> values) { next.assign(values.begin(), values.end()); }
  void polygon(std::span<const Point3> vertices, std::span<const std::int32_t>) {
    polygons.push_back({{vertices.begin(), vertices.end()}, std::exchange(next, {}), style});
  }
};

// ---- Intensities -----------------------------------------------------------------------

TEST(VertexIntensities, AreThoseOfTheNormalsOnTheSideThatIsSeen) {
  const std::vector<Point3> front{{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0, 0.5, 0}};
  const std::vector<Point3> normals{{0, 0, 2}, {-1, 1, 1}, {0.5, -0.1, 0.4}};
  const std::vector<Point3> back(front.rbegin(), front.rend());
  const std::vector<Point3> of_back(normals.rbegin(), normals.rend());
  const Held seen(drawn({{front, back}, {normals, of_back}}, Shading::gouraud));
  ASSERT_EQ(seen.polygons.size(), 2u);
  ASSERT_EQ(seen.polygons[0].intensities.size(), 3u);
  ASSERT_EQ(seen.polygons[1].intensities.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(seen.polygons[0].intensities[k], intensity_of(normals[k]), 1e-15);
    // Normals that point out of the dark face are turned round, and then the dark face is seen.
    EXPECT_NEAR(seen.polygons[1].intensities[k], intensity_of(of_back[k]), 1e-15);
  }
  EXPECT_EQ(seen.polygons[0].fill, kFill);
}

TEST(VertexIntensities, ZeroStandsForThePolygonsOwnNormal) {
  const std::vector<Point3> triangle{{-0.5, -0.5, 0}, {0.5, -0.5, 0.2}, {0, 0.5, 0.3}};
  const Point3 own = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  const Point3 zero(0.0), other(1, 0, 1);
  const Held mixed(drawn({{triangle}, {{zero, other, zero}}}, Shading::gouraud));
  EXPECT_NEAR(mixed.polygons[0].intensities[0], intensity_of(own), 1e-14);
  EXPECT_NEAR(mixed.polygons[0].intensities[1], intensity_of(other), 1e-14);
  EXPECT_EQ(dump(drawn({{triangle}, {{zero, zero, zero}}}, Shading::gouraud).display_file()),
            dump(drawn({{triangle}, {{}}}, Shading::flat).display_file()));
}

/// However it is scaled, turned or mirrored, the polygon has the normals of the surface.
TEST(VertexIntensities, NormalsFollowTheModellingTransformation) {
  const Scene scene = ball(12, 8);
  for (const Point3& scale : {Point3(0.5, 1, 0.8), Point3(-0.7, 0.9, 1), Point3(-1, -0.5, -1)}) {
    GraphicsSystem transformed;
    transformed.set_view_depth(-2, 2);
    transformed.scale_3(scale.x, scale.y, scale.z);
    transformed.rotate_x_3(90);
    enter(scene, Shading::gouraud, transformed);
    Scene by_hand = scene;
    for (auto& polygon : by_hand.polygons) {
      for (Point3& p : polygon) p = {p.x * scale.x, -p.z * scale.z, p.y * scale.y};
    }
    for (auto& normals : by_hand.normals) {
      for (Point3& n : normals) n = {n.x / scale.x, -n.z / scale.z, n.y / scale.y};
    }
    const Held a(transformed), b(drawn(by_hand, Shading::gouraud));
    ASSERT_EQ(a.polygons.size(), b.polygons.size());
    for (std::size_t i = 0; i < a.polygons.size(); ++i) {
      ASSERT_EQ(a.polygons[i].intensities.size(), b.polygons[i].intensities.size());
      for (std::size_t k = 0; k < a.polygons[i].intensities.size(); ++k) {
        EXPECT_NEAR(a.polygons[i].intensities[k], b.polygons[i].intensities[k], 1e-12);
      }
    }
  }
}

/// Where the window cuts a triangle, the rest is shaded as it was in the whole picture.
TEST(VertexIntensities, ClippingLeavesThePictureAsItWas) {
  for (const bool perspective : {false, true}) {
    View view;
    view.set_depth(-2, 2);
    if (perspective) view.set_perspective({0.3, 0.4, 3.0});
    View wide = view;
    wide.set_window({-100, 100, -100, 100});
    ClipPipeline cutting{ViewVolume(view)}, whole{ViewVolume(wide)};
    const auto in_wide = [](const Point3& p) {
      return Point3((2 * p.x - 1 + 100) / 200, (2 * p.y - 1 + 100) / 200, p.z);
    };
    int cut = 0;
    const Scene scene = triangles(7, 400);
    Dice dice(8);
    for (const auto& triangle : scene.polygons) {
      const std::array intensities{dice.part(), dice.part(), dice.part()};
      const ClippedPolygon uncut = whole.clip_polygon(triangle, {}, intensities);
      ASSERT_EQ(uncut.vertices.size(), 3u);
      const IntensityPlane plane(uncut.vertices, uncut.intensities);
      const ClippedPolygon left = cutting.clip_polygon(triangle, {}, intensities);
      ASSERT_EQ(left.intensities.size(), left.vertices.size());
      for (std::size_t k = 0; k < left.vertices.size(); ++k) {
        EXPECT_NEAR(left.intensities[k], plane.at(in_wide(left.vertices[k])), 1e-9);
      }
      cut += left.vertices.size() > 3 ? 1 : 0;
    }
    EXPECT_GT(cut, 50);
  }
}

/// Such a triangle has no picture over which an intensity could be linear.
TEST(VertexIntensities, ATriangleThatReachesBehindTheEyeIsFlat) {
  const std::vector<Point3> triangle{{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0, 0.5, 9}};
  const Scene scene{{triangle}, {{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}}};
  const Held held(drawn(scene, Shading::gouraud, true));
  ASSERT_EQ(held.polygons.size(), 1u);
  EXPECT_TRUE(held.polygons[0].intensities.empty());
  EXPECT_NE(held.polygons[0].fill, kFill);
}

TEST(SetVertexNormals, AreOfTheNextPolygonAndHaveToFitIt) {
  GraphicsSystem g;
  EXPECT_NE(error_of([&] { g.set_vertex_normals({{0, 0, 1}, {0, 0, 1}}); }), "");
  EXPECT_NE(error_of([&] { g.set_vertex_normals({{0, 0, 1}, {0, 0, 1}, {0, 1, 1e200}}); }), "");
  g.set_light(kLight);
  g.set_shading(Shading::gouraud);
  g.open_segment(1);
  g.set_vertex_normals({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}});
  EXPECT_EQ(error_of([&] {
              g.polygon_abs_2({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
            }),
            "polygon of 4 sides: expected 3, as many as set-vertex-normals has");
  g.polygon_abs_2({{0, 0}, {1, 0}, {1, 1}});          // these are still its normals
  g.polygon_abs_2({{0, 0}, {1, 0}, {1, 1}, {0, 1}});  // it has none
  g.set_vertex_normals({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}});
  g.set_vertex_normals({});
  g.polygon_abs_2({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  g.close_segment();
  const Held held(g);
  ASSERT_EQ(held.polygons.size(), 3u);
  EXPECT_EQ(held.polygons[0].intensities.size(), 3u);
  EXPECT_TRUE(held.polygons[1].intensities.empty());
  EXPECT_TRUE(held.polygons[2].intensities.empty());
}

// ---- Unchanged pictures ----------------------------------------------------------------

TEST(FlatShading, PaysNothingForNormals) {
  Scene scene = triangles(3, 60), without = scene;
  for (auto& normals : without.normals) normals.clear();
  const GraphicsSystem flat = drawn(scene, Shading::flat);
  const GraphicsSystem none = drawn(without, Shading::gouraud);
  EXPECT_EQ(dump(flat.display_file()), dump(none.display_file()));
  EXPECT_EQ(flat.display_file().bytes(), none.display_file().bytes());
  EXPECT_LT(flat.display_file().bytes(), drawn(scene, Shading::gouraud).display_file().bytes());
}

/// Normals that are all the polygon's own, and light that comes from everywhere.
TEST(GouraudShading, OfEqualIntensitiesIsTheFlatPicture) {
  Scene scene = ball(14, 9);
  for (std::size_t i = 0; i < scene.polygons.size(); ++i) {
    const auto& p = scene.polygons[i];
    scene.normals[i].assign(4, glm::cross(p[2] - p[0], p[3] - p[1]));
  }
  for (const HiddenMethod method : {HiddenMethod::z_buffer, HiddenMethod::bsp}) {
    EXPECT_EQ(compare(picture(drawn(scene, Shading::gouraud, true), method),
                      picture(drawn(scene, Shading::flat, true), method))
                  .wrong_pixels,
              0);
    const auto everywhere = [&](Shading shading) {
      GraphicsSystem g;
      g.set_perspective({0.3, 0.4, 3.0});
      enter(ball(14, 9), shading, g);
      g.open_segment(2);
      g.set_light(kLight, 1.0);
      for (const auto& p : scene.polygons) {
        g.set_vertex_normals(p);
        g.polygon_abs_3(p);
      }
      g.close_segment();
      g.set_visibility(1, false);
      return picture(g, method);
    };
    EXPECT_EQ(compare(everywhere(Shading::gouraud), everywhere(Shading::flat)).wrong_pixels, 0);
  }
}

TEST(GouraudShading, ChangesNoItemBuffer) {
  for (const Scene& scene : {triangles(11, 120), ball(14, 9)}) {
    for (const auto& entry : hidden_methods()) {
      if (shows_lines_only(entry.method)) continue;
      const Picture flat = picture(drawn(scene, Shading::flat, true), entry.method);
      const Picture smooth = picture(drawn(scene, Shading::gouraud, true), entry.method);
      EXPECT_EQ(smooth.ids, flat.ids) << entry.name;
      EXPECT_GT(compare(smooth, flat).wrong_pixels, 1000) << entry.name;
    }
  }
}

/// The even-odd rule fills the same with normals and without, although polygons become triangles.
TEST(SmoothShading, APolygonThatCrossesItselfKeepsItsShape) {
  std::vector<Point3> pentagram, normals;
  for (int k = 0; k < 5; ++k) {
    const double angle = 0.1 + 0.8 * std::numbers::pi * k;
    pentagram.emplace_back(0.9 * std::cos(angle), 0.9 * std::sin(angle), 0.0);
    normals.emplace_back(0.3 * std::cos(angle), 0.3 * std::sin(angle), 1.0);
  }
  const std::vector<Point3> bow_tie{{-0.9, -0.8, 0}, {0.9, 0.8, 0}, {0.9, -0.8, 0}, {-0.9, 0.8, 0}};
  for (const std::vector<Point3>& polygon : {pentagram, bow_tie}) {
    const std::vector<Point3> own(normals.begin(),
                                  normals.begin() + static_cast<std::ptrdiff_t>(polygon.size()));
    const Scene scene{{polygon}, {own}};
    const Picture flat = picture(drawn(scene, Shading::flat), HiddenMethod::z_buffer);
    EXPECT_GT(std::ranges::count_if(flat.ids, [](auto id) { return id >= 0; }), 1000);
    for (const Shading shading : {Shading::gouraud, Shading::phong}) {
      const Picture smooth = picture(drawn(scene, shading), HiddenMethod::z_buffer);
      // New corners are rounded, and may move a centre across a side.
      const auto differ = std::inner_product(flat.ids.begin(), flat.ids.end(), smooth.ids.begin(),
                                             0, std::plus<>(), std::not_equal_to<>());
      EXPECT_LE(differ, 4) << polygon.size();
    }
  }
}

// ---- Pictures --------------------------------------------------------------------------

/// The definition, worked out at a pixel's centre from the triangle's own corners.
TEST(GouraudShading, IsLinearOverThePictureOfATriangle) {
  const std::vector<Point3> triangle{{-0.9, -0.8, 0}, {0.9, -0.5, 0.4}, {-0.2, 0.9, -0.3}};
  const std::vector<Point3> normals{{-1, 1, 1.5}, {1, 0, 0.3}, {0, 1, 1}};
  const GraphicsSystem g = drawn({{triangle}, {normals}}, Shading::gouraud);
  const Picture seen = picture(g, HiddenMethod::z_buffer);
  const auto area = [](Point2 a, Point2 b, Point2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  };
  const Point2 a(triangle[0]), b(triangle[1]), c(triangle[2]);
  int inside = 0;
  for (int row = 0; row < seen.height; ++row) {
    for (int column = 0; column < seen.width; ++column) {
      const auto at = static_cast<std::size_t>((seen.height - 1 - row) * seen.width + column);
      if (seen.ids[at] < 0) continue;
      const Point2 p((2.0 * column + 1) / seen.width - 1, (2.0 * row + 1) / seen.height - 1);
      const double intensity =
          (area(p, b, c) * intensity_of(normals[0]) + area(a, p, c) * intensity_of(normals[1]) +
           area(a, b, p) * intensity_of(normals[2])) /
          area(a, b, c);
      for (int channel = 0; channel < 3; ++channel) {
        const double expected = 255 * intensity * kFill.colour[channel];
        const int shown = seen.pixels[at] >> (8 * channel) & 0xFF;
        ASSERT_NEAR(shown, expected, 0.5 + 1e-9) << column << ' ' << row;
      }
      ++inside;
    }
  }
  EXPECT_GT(inside, 1000);
}

TEST(GouraudShading, IsTheSameByEveryMethodAndForAnyNumberOfThreads) {
  expect_one_picture_by_all_methods(Shading::gouraud);
}

/// The diagonals are those of the world, not of the picture.
TEST(GouraudShading, TurnsWithThePicture) {
  Scene scene = ball(9, 7);
  const auto turned = [&](const Point3& up) {
    GraphicsSystem g;
    g.set_view_up(up);
    g.set_view_depth(-2, 2);
    enter(scene, Shading::gouraud, g);
    DrawOptions options{.width = 80, .height = 80, .samples = 1};
    options.surfaces.method = HiddenMethod::z_buffer;
    return draw(g, options);
  };
  const Picture upright = turned({0, 1, 0}), sideways = turned({1, 0, 0});
  const auto largest_channel_difference = [](std::uint32_t p, std::uint32_t q) {
    int most = 0;
    for (const int shift : {0, 8, 16}) {
      most = std::max(most, std::abs(static_cast<int>(p >> shift & 0xFF) -
                                     static_cast<int>(q >> shift & 0xFF)));
    }
    return most;
  };
  int coloured = 0, others = 0;
  for (std::size_t row = 0; row < 80; ++row) {
    for (std::size_t column = 0; column < 80; ++column) {
      const std::uint32_t a = upright.pixels[80 * row + column];
      const std::uint32_t b = sideways.pixels[80 * (79 - column) + row];
      coloured += a != 0xFFFFFFFF ? 1 : 0;
      others += largest_channel_difference(a, b) > 1 ? 1 : 0;
    }
  }
  EXPECT_GT(coloured, 1500);
  EXPECT_LT(others, 40);  // centres on an edge belong by a rule for left and right
}

/// OpenGL interpolates colours of its own accord.
TEST(GouraudShading, IsWhatOsmesaShows) {
  if (!osmesa_available()) GTEST_SKIP() << osmesa_description();
  for (const std::uint32_t seed : {1u, 2u, 3u}) {
    const GraphicsSystem g = seed == 3 ? drawn(ball(14, 9), Shading::gouraud, true)
                                       : drawn(triangles(seed, 40), Shading::gouraud, seed == 2);
    const RasterRequest request{
        .width = 97, .height = 83, .surfaces = {.method = HiddenMethod::z_buffer}, .ids = true};
    const Picture ours = draw_with_software(g.display_file(), request);
    Picture theirs = draw_with_osmesa(g.display_file(), request);
    std::size_t others = 0;  // pixels where it sees another polygon
    for (std::size_t k = 0; k < ours.pixels.size(); ++k) {
      if (ours.ids[k] == theirs.ids[k]) continue;
      theirs.pixels[k] = ours.pixels[k];
      ++others;
    }
    EXPECT_LT(others, 80u);
    EXPECT_LE(compare(ours, theirs).largest, 1.0);
  }
}

TEST(GouraudShading, ARetainedSceneHasItInEveryView) {
  GraphicsSystem g;
  RetainedScene scene;
  g.retain(&scene);
  g.set_perspective({0.3, 0.4, 3.0});
  g.set_view_depth(-2, 2);
  enter(triangles(5, 60), Shading::gouraud, g);
  RetainedViews views(scene, g.display_file(), {.scope = HiddenScope::segment});
  const DisplayFile again = views.view(g.view());
  DisplayFile unsorted = again;
  unsorted.segment(1).set_sorted(nullptr);
  EXPECT_EQ(dump(unsorted), dump(g.display_file()));
  const RasterRequest sorted{.width = 97, .height = 83, .sorted = true, .ids = true};
  const Picture from_tree = draw_with_software(again, sorted);
  const Picture expected = picture(g, HiddenMethod::z_buffer);
  EXPECT_LE(compare(from_tree, expected).largest, 1.0);
}

class SmoothVectors : public test::TemporaryFolder {};

/// The ramps themselves: vector_ramps_test.cpp.
TEST_F(SmoothVectors, AreGradients) {
  GraphicsSystem g = drawn({{{{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0, 0.5, 0}}},
                            {{{-0.5, 0.7, 1}, {0.5, -0.7, -1}, {0, 0, 1}}}},
                           Shading::gouraud);
  write_svg(g.display_file(), 64, 64, file("t.svg"));
  EXPECT_NE(test::content(file("t.svg")).find("<linearGradient"), std::string::npos);
}

// ---- Meshes ----------------------------------------------------------------------------

class SmoothMesh : public test::TemporaryFolder {
 protected:
  std::string file(const std::string& name, const std::string& text) const {
    return TemporaryFolder::file(name, text).string();
  }
};

constexpr int kCubeFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                  {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

Point3 cube_corner(int i) { return {2 * (i & 1) - 1, (i & 2) - 1, (i >> 1 & 2) - 1}; }

/// A cube of triangles, its sides cut along either diagonal, so that a corner has three to six
/// faces.
std::string cube_obj() {
  std::string text;
  for (int i = 0; i < 8; ++i) {
    const Point3 p = cube_corner(i);
    text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
  }
  for (int f = 0; f < 6; ++f) {
    const int s = f % 2;
    const auto& c = kCubeFaces[f];
    text += fmt::format("f {} {} {}\nf {} {} {}\n", c[s] + 1, c[s + 1] + 1, c[s + 2] + 1,
                        c[s + 2] + 1, c[(s + 3) % 4] + 1, c[s] + 1);
  }
  return text;
}

/// Every corner sees three faces of a right angle each, however they are triangulated.
TEST_F(SmoothMesh, NormalsAreTheMeanOfTheFacesByAngle) {
  Mesh mesh = read_mesh(file("cube.obj", cube_obj()), true);
  complete_normals(mesh);
  ASSERT_EQ(mesh.corner_normals.size(), mesh.corners.size());
  for (std::size_t k = 0; k < mesh.corners.size(); ++k) {
    const Point3& vertex = mesh.vertices[mesh.corners[k]];
    EXPECT_LT(glm::length(unit(mesh.normal(k)) - unit(vertex)), 1e-12);
  }
}

TEST_F(SmoothMesh, PositionsThatAreTheSameAreOneVertexAlsoInStl) {
  std::string stl = "solid cube\n";
  for (const auto& c : kCubeFaces) {
    for (const auto& t : {std::array{0, 1, 2}, std::array{2, 3, 0}}) {
      stl += "facet normal 0 0 0\nouter loop\n";
      for (const int k : t) {
        const Point3 p = cube_corner(c[k]);
        stl += fmt::format("vertex {} {} {}\n", p.x, p.y, p.z);
      }
      stl += "endloop\nendfacet\n";
    }
  }
  Mesh mesh = read_mesh(file("cube.stl", stl + "endsolid cube\n"), true);
  complete_normals(mesh);
  for (std::size_t k = 0; k < mesh.corners.size(); ++k) {
    const Point3& vertex = mesh.vertices[mesh.corners[k]];
    EXPECT_LT(glm::length(unit(mesh.normal(k)) - unit(vertex)), 1e-12);
  }
}

TEST_F(SmoothMesh, TheFilesOwnNormalsAreKept) {
  const std::string path = file("one.obj",
                                "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvn 0.6 0 0.8\n"
                                "f 1//1 2//2 3//1\n");
  Mesh mesh = read_mesh(path, true);
  complete_normals(mesh);
  int tilted = 0;
  for (std::size_t k = 0; k < mesh.corners.size(); ++k) {
    const bool at_1 = mesh.vertices[mesh.corners[k]].x == 1.0;
    EXPECT_EQ(mesh.normal(k), at_1 ? Point3(0.6, 0, 0.8) : Point3(0, 0, 1));
    tilted += at_1 ? 1 : 0;
  }
  EXPECT_EQ(tilted, 1);
  EXPECT_TRUE(read_mesh(path).normals.empty());  // not requested
  EXPECT_TRUE(read_mesh(path).corner_normals.empty());
}

/// Imported with normals, a mesh is a drawing program that draws the same.
TEST_F(SmoothMesh, ImportedItReplaysToTheSameDisplayFile) {
  const std::string path = file("cube.obj", cube_obj());
  std::ostringstream recording;
  Recorder recorder(recording);
  GraphicsSystem imported, replayed, flat;
  imported.set_recorder(&recorder);
  imported.set_shading(Shading::gouraud);
  import_mesh(path, imported);
  replay(recording.str(), "recording", replayed);
  const std::string text = dump(imported.display_file());
  EXPECT_EQ(first_difference(dump(replayed.display_file()), text), std::nullopt);
  EXPECT_NE(text.find("\nintensities "), std::string::npos);
  import_mesh(path, flat);
  EXPECT_EQ(dump(flat.display_file()).find("intensities"), std::string::npos);
}

// ---- Dumps -----------------------------------------------------------------------------

TEST(IntensitiesInDumps, StandBeforeTheirPolygonAndAreCompared) {
  const Scene scene{{{{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0, 0.5, 0}}},
                    {{{1, 0, 0.1}, {0, 0, 1}, {1, -1, 0.1}}}};
  const std::string text = dump(drawn(scene, Shading::gouraud).display_file());
  EXPECT_NE(text.find("pick 0\nintensities 0.2 "), std::string::npos) << text;
  EXPECT_NE(text.find(" 0.2\npolygon 3 "), std::string::npos) << text;
  std::string other = text;
  other.replace(other.find(" 0.2\npolygon"), 4, " 0.3");
  const auto difference = first_difference(text, other);
  ASSERT_TRUE(difference);
  EXPECT_NE(difference->find("intensity is 0.2, expected 0.3"), std::string::npos) << *difference;
}

}  // namespace
}  // namespace displayfile
