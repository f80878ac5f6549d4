// The guarantees of Phong shading: each pixel is lit by the normal interpolated linearly over the
// picture of a triangle, whatever clips, sorts or moves it, and no pixel's polygon changes. The
// judge is the definition, in long double.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "clip/geometry/unit.h"
#include "displayfile/entered/normal_plane.h"
#include "displayfile/files.h"
#include "displayfile/looks/phong.h"
#include "displayfile/text/dump_compare.h"
#include "displayfile/views/retained_views.h"
#include "hidden/exact/support_plane.h"
#include "interp/device/raster_request.h"
#include "interp/files/picture_compare.h"
#include "interp/opengl/osmesa.h"
#include "interp/raster/phong_shade.h"
#include "interp/raster/software.h"
#include "interp/vector/svg_device.h"
#include "interp/visibility/image_space.h"
#include "tests/shaded_scenes.h"
#include "tests/temporary_folder.h"
#include "tests/truth_scenes.h"

namespace displayfile {
namespace {

using test::ball;
using test::Dice;
using test::direction;
using test::drawn;
using test::enter;
using test::expect_one_picture_by_all_methods;
using test::intensity_of;
using test::kAmbient;
using test::kFill;
using test::kLight;
using test::picture;
using test::triangles;
using Scene = test::ShadedScene;

/// The contents of the display file: the polygons as they are drawn, with normals, light and fill.
struct Held {
  struct Polygon {
    std::vector<Point3> vertices, normals;
    std::optional<Light> light;
    FillStyle fill;
  };
  std::vector<Polygon> polygons;
  FillStyle style;
  Polygon next;

  explicit Held(const DisplayFile& file) {
    for (const Segment& s : file.segments()) s.walk_entered_drawn(*this);
  }
  explicit Held(const GraphicsSystem& g) : Held(g.display_file()) {}
  void fill(const FillStyle& s) { style = s; }
  void line_style(const LineStyle&) {}
  void pick(int) {}
  void move(const Point3&) {}
  void line(const Point3&) {}
  void intensities(std::span<const double>) { ADD_FAILURE() << "with Phong shading"; }
  void normals(std::span<const Point3> values, const Light& light) {
    next.normals.assign(values.begin(), values.end());
    next.light = light;
  }
  void polygon(std::span<const Point3> vertices, std::span<const std::int32_t>) {
    next.vertices.assign(vertices.begin(), vertices.end());
    next.fill = style;
    polygons.push_back(std::exchange(next, {}));
  }
};

const Scene kOneTriangle{{{{-0.9, -0.8, 0}, {0.9, -0.5, 0.4}, {-0.2, 0.9, -0.3}}},
                         {{{-1, 1, 1.5}, {1, 0, 0.3}, {0, 1, 1}}}};

// ---- Normals in the display file ---------------------------------------------------------

TEST(VertexNormals, AreThoseOfTheSideThatIsSeenOfLengthOne) {
  const std::vector<Point3> front{{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0, 0.5, 0}};
  const std::vector<Point3> normals{{0, 0, 2}, {-1, 1, 1}, {0.5, -0.1, 0.4}};
  const std::vector<Point3> back(front.rbegin(), front.rend());
  const std::vector<Point3> of_back(normals.rbegin(), normals.rend());
  const Held seen(drawn({{front, back}, {normals, of_back}}, Shading::phong));
  ASSERT_EQ(seen.polygons.size(), 2u);
  for (const auto& polygon : seen.polygons) {
    ASSERT_EQ(polygon.normals.size(), 3u);
    EXPECT_EQ(polygon.fill, kFill);
    EXPECT_EQ(polygon.light, (Light{unit(kLight), kAmbient}));
  }
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_LT(glm::length(seen.polygons[0].normals[k] - unit(normals[k])), 1e-15);
    // Normals that point out of the dark face are turned round, and then the dark face is seen.
    EXPECT_LT(glm::length(seen.polygons[1].normals[k] - unit(of_back[k])), 1e-15);
  }
}

/// Where the window cuts a triangle, the rest has the normals that it had in the whole picture.
TEST(VertexNormals, ClippingLeavesThePictureAsItWas) {
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
    for (std::size_t i = 0; i < scene.polygons.size(); ++i) {
      const ClippedPolygon uncut = whole.clip_with_normals(scene.polygons[i], {}, scene.normals[i]);
      ASSERT_EQ(uncut.vertices.size(), 3u);
      EXPECT_TRUE(uncut.intensities.empty());
      const NormalPlane plane(uncut.vertices, uncut.normals);
      const ClippedPolygon left =
          cutting.clip_with_normals(scene.polygons[i], {}, scene.normals[i]);
      ASSERT_EQ(left.normals.size(), left.vertices.size());
      for (std::size_t k = 0; k < left.vertices.size(); ++k) {
        EXPECT_LT(glm::length(left.normals[k] - plane.at(in_wide(left.vertices[k]))), 1e-9);
      }
      cut += left.vertices.size() > 3 ? 1 : 0;
    }
    EXPECT_GT(cut, 50);
  }
}

TEST(VertexNormals, OfATriangleThatReachesBehindTheEyeAreTheirMean) {
  const std::vector<Point3> triangle{{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0, 0.5, 9}};
  const Held held(drawn({{triangle}, {{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}}}, Shading::phong, true));
  ASSERT_EQ(held.polygons.size(), 1u);
  EXPECT_TRUE(held.polygons[0].normals.empty());
  const Point3 mean = Point3(0, 0, 1) + unit(Point3(1, 0, 1)) + unit(Point3(0, 1, 1));
  EXPECT_NEAR(held.polygons[0].fill.colour.r, kFill.colour.r * intensity_of(mean), 1e-14);
}

/// They are directions in the world: image transformations do not change them.
TEST(VertexNormals, StayWhatTheyAreWhereAnImageIsMoved) {
  GraphicsSystem g = drawn(kOneTriangle, Shading::phong);
  const Held before(g);
  g.set_image_scale(1, -0.5, 0.5);
  g.set_image_rotation(1, 30);
  const Held after(g);
  ASSERT_EQ(after.polygons.size(), 1u);
  EXPECT_NE(after.polygons[0].vertices, before.polygons[0].vertices);
  EXPECT_EQ(after.polygons[0].normals, before.polygons[0].normals);
}

TEST(VertexNormals, InDumpsStandBeforeTheirPolygonAndAreCompared) {
  const Scene scene{{{{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0, 0.5, 0}}},
                    {{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}}};
  GraphicsSystem g;
  g.set_light({0, 0, 1}, 0.25);
  g.set_shading(Shading::phong);
  g.open_segment(1);
  for (int k = 0; k < 2; ++k) {
    g.set_vertex_normals(scene.normals[0]);
    g.polygon_abs_3(scene.polygons[0]);
  }
  g.close_segment();
  const std::string text = dump(g.display_file());
  EXPECT_NE(text.find("pick 0\nlight 0 0 1 0.25\nnormals 1 0 0 0 0 1 0 -1 0\npolygon 3 "),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("pick 1\nnormals 1 0 0 0 0 1 0 -1 0\npolygon 3 "), std::string::npos) << text;
  const auto difference_with = [&](const std::string& was, const std::string& is) {
    std::string other = text;
    other.replace(other.find(was), was.size(), is);
    return first_difference(text, other).value_or("");
  };
  EXPECT_NE(difference_with("1 0 -1 0\n", "1 0 -2 0\n").find("normal y is -1, expected -2"),
            std::string::npos);
  EXPECT_NE(difference_with("1 0.25\n", "1 0.5\n").find("ambient light is 0.25, expected 0.5"),
            std::string::npos);
}

// ---- Unchanged pictures ------------------------------------------------------------------

TEST(PhongShading, OfEqualNormalsIsTheFlatPicture) {
  Scene scene = ball(14, 9);
  for (const double length : {1.0, 0.3}) {
    for (std::size_t i = 0; i < scene.polygons.size(); ++i) {
      const auto& p = scene.polygons[i];
      scene.normals[i].assign(4, length * glm::cross(p[2] - p[0], p[3] - p[1]));
    }
    for (const HiddenMethod method : {HiddenMethod::z_buffer, HiddenMethod::bsp}) {
      EXPECT_EQ(compare(picture(drawn(scene, Shading::phong, true), method),
                        picture(drawn(scene, Shading::flat, true), method))
                    .wrong_pixels,
                0);
    }
  }
  const Point3 zero(0.0);
  const std::vector<Point3> triangle{{-0.5, -0.5, 0}, {0.5, -0.5, 0.2}, {0, 0.5, 0.3}};
  EXPECT_EQ(dump(drawn({{triangle}, {{zero, zero, zero}}}, Shading::phong).display_file()),
            dump(drawn({{triangle}, {{}}}, Shading::flat).display_file()));
}

/// Where no normal sees the light, and where all is ambient light, there is nothing to work out at
/// a pixel, and nothing is kept.
TEST(PhongShading, OfOneIntensityIsFlat) {
  // Out of the light face, and turned away from the light.
  const std::vector<Point3> away{{0.6, -0.5, 0.5}, {0.9, -0.3, 0.45}, {0.2, -0.8, 0.4}};
  const Held dark(drawn({kOneTriangle.polygons, {away}}, Shading::phong));
  EXPECT_TRUE(dark.polygons[0].normals.empty());
  EXPECT_EQ(dark.polygons[0].fill.colour, kFill.colour * kAmbient);
  GraphicsSystem g;
  g.set_light(kLight, 1.0);
  g.set_fill_style(kFill);
  g.set_shading(Shading::phong);
  g.open_segment(1);
  g.set_vertex_normals(kOneTriangle.normals[0]);
  g.polygon_abs_3(kOneTriangle.polygons[0]);
  g.close_segment();
  const Held even(g);
  EXPECT_TRUE(even.polygons[0].normals.empty());
  EXPECT_EQ(even.polygons[0].fill, kFill);
  g.set_fill_style({FillStyle::Kind::hollow});
  g.set_light(kLight);
  g.open_segment(2);
  g.set_vertex_normals(kOneTriangle.normals[0]);
  g.polygon_abs_3(kOneTriangle.polygons[0]);
  g.close_segment();
  EXPECT_TRUE(Held(g).polygons.back().normals.empty());
}

TEST(PhongShading, IsNotPaidForByOthers) {
  Scene scene = triangles(3, 60), without = scene;
  for (auto& normals : without.normals) normals.clear();
  const GraphicsSystem none = drawn(without, Shading::phong);
  const GraphicsSystem flat = drawn(scene, Shading::flat);
  EXPECT_EQ(dump(none.display_file()), dump(flat.display_file()));
  EXPECT_EQ(none.display_file().bytes(), flat.display_file().bytes());
  EXPECT_LT(drawn(scene, Shading::gouraud).display_file().bytes(),
            drawn(scene, Shading::phong).display_file().bytes());
}

TEST(PhongShading, ChangesNoItemBuffer) {
  for (const Scene& scene : {triangles(11, 120), ball(14, 9)}) {
    for (const auto& entry : hidden_methods()) {
      if (shows_lines_only(entry.method)) continue;
      const Picture flat = picture(drawn(scene, Shading::flat, true), entry.method);
      const Picture smooth = picture(drawn(scene, Shading::phong, true), entry.method);
      EXPECT_EQ(smooth.ids, flat.ids) << entry.name;
      EXPECT_GT(compare(smooth, flat).wrong_pixels, 1000) << entry.name;
    }
  }
}

// ---- Pictures ----------------------------------------------------------------------------

/// The definition at a pixel's centre, in long double: the colour on a scale of 0 to 255.
std::array<long double, 3> defined_colour(const Held::Polygon& polygon, long double x,
                                          long double y) {
  const auto& v = polygon.vertices;
  const auto corner = support_vertices(v).index;
  const auto area = [](long double ax, long double ay, long double bx, long double by,
                       long double cx,
                       long double cy) { return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax); };
  const Point3 &a = v[corner[0]], &b = v[corner[1]], &c = v[corner[2]];
  const long double all = area(a.x, a.y, b.x, b.y, c.x, c.y);
  const std::array<long double, 3> part{area(x, y, b.x, b.y, c.x, c.y) / all,
                                        area(a.x, a.y, x, y, c.x, c.y) / all,
                                        area(a.x, a.y, b.x, b.y, x, y) / all};
  long double along_light = 0, square = 0;
  for (int k = 0; k < 3; ++k) {
    long double n = 0;
    for (std::size_t i = 0; i < 3; ++i) n += part[i] * polygon.normals[corner[i]][k];
    along_light += n * polygon.light->toward[k];
    square += n * n;
  }
  const long double cosine = std::max(0.0L, along_light / std::sqrt(square));
  const long double ambient = polygon.light->ambient;
  const long double intensity = ambient + (1 - ambient) * cosine;
  return {255 * intensity * polygon.fill.colour.r, 255 * intensity * polygon.fill.colour.g,
          255 * intensity * polygon.fill.colour.b};
}

/// Returns the number of shaded pixels; each is compared with the definition.
int expect_defined(const Picture& seen, const Held& held) {
  int shaded = 0;
  for (int row = 0; row < seen.height; ++row) {
    for (int column = 0; column < seen.width; ++column) {
      const auto at = static_cast<std::size_t>((seen.height - 1 - row) * seen.width + column);
      if (seen.ids[at] < 0) continue;
      const auto& polygon = held.polygons[static_cast<std::size_t>(seen.ids[at])];
      if (polygon.normals.empty()) continue;
      const auto expected =
          defined_colour(polygon, (column + 0.5L) / seen.width, (row + 0.5L) / seen.height);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const int shown = seen.pixels[at] >> (8 * channel) & 0xFF;
        EXPECT_NEAR(shown, static_cast<double>(expected[channel]), 0.5 + 1e-6)
            << column << ' ' << row;
      }
      ++shaded;
    }
  }
  return shaded;
}

TEST(PhongShading, IsTheDefinitionAtEveryPixelFromEveryEye) {
  for (const Point3& eye : {Point3(0.3, 0.4, 3.0), Point3(-2, 0.1, 2.5), Point3(0.5, -3, -2)}) {
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
      GraphicsSystem g;
      g.set_view_plane_normal(-eye);
      g.set_perspective(eye);
      g.set_view_depth(-2, 2);
      enter(triangles(seed, 40), Shading::phong, g);
      // Clipped polygons are not in the display file: identifiers are ordinals of the others.
      const Held held(g);
      DisplayFile file;
      Segment& segment = file.create(1);
      int ordinal = 0;
      for (const auto& polygon : held.polygons) {
        segment.set_style(polygon.fill);
        segment.set_style(LineStyle{LineStyle::Kind::none});
        segment.set_pick(ordinal++);
        segment.enter_polygon(
            polygon.vertices, std::vector<std::uint8_t>(polygon.vertices.size(), 1),
            {.normals = polygon.normals, .light = polygon.light ? &*polygon.light : nullptr});
      }
      segment.close();
      const RasterRequest request{
          .width = 97, .height = 83, .surfaces = {.method = HiddenMethod::z_buffer}, .ids = true};
      EXPECT_GT(expect_defined(draw_with_software(file, request), held), 1000);
    }
  }
}

/// On a ball of few polygons the brightest place lies between the vertices, and the terminator
/// crosses polygons.
TEST(PhongShading, FindsWhatLiesBetweenTheVertices) {
  const Scene scene = ball(5, 4);
  const auto largest_red = [&](Shading shading) {
    std::uint32_t most = 0;
    for (const std::uint32_t pixel :
         picture(drawn(scene, shading), HiddenMethod::z_buffer).pixels) {
      if (pixel != 0xFFFFFFFF) most = std::max(most, pixel & 0xFF);
    }
    return static_cast<double>(most) / 255 / kFill.colour.r;
  };
  double of_vertices = 0;
  for (const auto& normals : scene.normals) {
    for (const Point3& n : normals) of_vertices = std::max(of_vertices, intensity_of(n));
  }
  EXPECT_LT(of_vertices, 0.97);
  EXPECT_NEAR(largest_red(Shading::gouraud), of_vertices, 0.02);
  EXPECT_NEAR(largest_red(Shading::phong), 1.0, 0.005);

  const Point3 toward = unit(kLight), across = unit(glm::cross(Point3(0, 1, 0), toward));
  const Point3 dark = across - 0.5 * toward;
  const Scene bent{{kOneTriangle.polygons[0]}, {{toward, dark, dark}}};
  const auto dark_pixels = [&](Shading shading) {
    const Picture seen = picture(drawn(bent, shading), HiddenMethod::z_buffer);
    return std::ranges::count(seen.pixels, pixel_of(kFill.colour * kAmbient));
  };
  EXPECT_GT(dark_pixels(Shading::phong), 3 * dark_pixels(Shading::gouraud) + 300);
}

TEST(PhongShading, IsTheSameByEveryMethodAndForAnyNumberOfThreads) {
  expect_one_picture_by_all_methods(Shading::phong);
}

/// A window that cuts leaves the remaining pixels unchanged.
TEST(PhongShading, IsNotChangedByClipping) {
  for (const bool perspective : {false, true}) {
    const auto in_window = [&](double half, int size) {
      GraphicsSystem g;
      if (perspective) g.set_perspective({0.3, 0.4, 3.0});
      g.set_view_depth(-2, 2);
      g.set_window(-half, half, -half, half);
      enter(triangles(5, 60), Shading::phong, g);
      DrawOptions options{.width = size, .height = size, .samples = 1};
      options.surfaces.method = HiddenMethod::z_buffer;
      options.ids = "asked for";
      return draw(g, options);
    };
    const Picture cut = in_window(0.5, 64), wide = in_window(1.0, 128);
    int compared = 0;
    for (std::size_t row = 0; row < 64; ++row) {
      for (std::size_t column = 0; column < 64; ++column) {
        const std::size_t here = 64 * row + column, there = 128 * (row + 32) + column + 32;
        if (cut.ids[here] < 0 || cut.ids[here] != wide.ids[there]) continue;
        for (const int shift : {0, 8, 16}) {
          ASSERT_LE(std::abs(static_cast<int>(cut.pixels[here] >> shift & 0xFF) -
                             static_cast<int>(wide.pixels[there] >> shift & 0xFF)),
                    1);
        }
        ++compared;
      }
    }
    EXPECT_GT(compared, 2000);
  }
}

/// Vectors of any width give the results of the plain form, also where normals are nearly zero.
TEST(PhongShading, InVectorsIsThePlainForm) {
  Dice dice(4);
  const PictureSize size{61, 47};
  std::vector<std::uint32_t> pixels;
  for (int trial = 0; trial < 200; ++trial) {
    std::array<Point3, 3> vertices, normals;
    for (std::size_t k = 0; k < 3; ++k) {
      vertices[k] = Point3(0.5) + direction(dice);
      normals[k] = unit(direction(dice));
    }
    if (trial % 3 == 1) normals[1] = -normals[0];
    if (trial % 3 == 2) normals[1] = normals[2] = -normals[0];
    const NormalPlane plane(vertices, normals);
    const Light light{trial % 5 == 0 ? normals[0] : unit(direction(dice)), dice.part()};
    const PhongShade shade({dice.part(), dice.part(), 1.0}, plane, light, size);
    for (const int first : {0, 1, 7}) {
      for (int row = 0; row < size.height; row += 5) {
        pixels.assign(static_cast<std::size_t>(size.width - first), 0);
        shade.paint(row, first, pixels);
        for (std::size_t i = 0; i < pixels.size(); ++i) {
          ASSERT_EQ(pixels[i], shade.at(row, first + static_cast<int>(i)));
        }
      }
    }
  }
}

TEST(PhongShading, ARetainedSceneHasItInEveryView) {
  GraphicsSystem g;
  RetainedScene scene;
  g.retain(&scene);
  g.set_perspective({0.3, 0.4, 3.0});
  g.set_view_depth(-2, 2);
  enter(triangles(5, 60), Shading::phong, g);
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

/// A program that changes the shading has each polygon's own, also where it is retained.
TEST(PhongShading, MayStandBesideOthers) {
  GraphicsSystem g;
  RetainedScene retained;
  g.retain(&retained);
  g.set_light(kLight, kAmbient);
  g.open_segment(1);
  for (const Shading shading : {Shading::phong, Shading::flat, Shading::gouraud, Shading::phong}) {
    g.set_shading(shading);
    g.set_vertex_normals(kOneTriangle.normals[0]);
    g.polygon_abs_3(kOneTriangle.polygons[0]);
  }
  g.close_segment();
  const Instructions& entered = *g.display_file().segment(1).entered();
  EXPECT_EQ(entered.stored_normals().size(), 6u);
  EXPECT_EQ(entered.stored_intensities().size(), 3u);
  RetainedViews views(retained, g.display_file(), {.scope = HiddenScope::segment});
  DisplayFile again = views.view(g.view());
  again.segment(1).set_sorted(nullptr);
  EXPECT_EQ(dump(again), dump(g.display_file()));
}

// ---- Devices that do not interpolate normals ----------------------------------------------

TEST(PhongShading, IsGouraudShadingToOsmesa) {
  if (!osmesa_available()) GTEST_SKIP() << osmesa_description();
  const RasterRequest request{
      .width = 97, .height = 83, .surfaces = {.method = HiddenMethod::z_buffer}, .ids = true};
  const auto by_osmesa = [&](Shading shading) {
    return draw_with_osmesa(drawn(ball(14, 9), shading, true).display_file(), request);
  };
  const Picture phong = by_osmesa(Shading::phong), gouraud = by_osmesa(Shading::gouraud);
  EXPECT_EQ(phong.ids, gouraud.ids);
  EXPECT_LE(compare(phong, gouraud).largest, 1.0);
}

class PhongVectors : public test::TemporaryFolder {};

TEST_F(PhongVectors, AreAsWithGouraudShading) {
  const auto svg = [&](Shading shading) {
    const GraphicsSystem g = drawn({{{{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0, 0.5, 0}}},
                                    {{{-0.5, 0.7, 1}, {0.5, -0.7, -1}, {0, 0, 1}}}},
                                   shading);
    write_svg(g.display_file(), 64, 64, file("t.svg"));
    return test::content(file("t.svg"));
  };
  EXPECT_NE(svg(Shading::phong).find("<linearGradient"), std::string::npos);
  EXPECT_EQ(svg(Shading::phong), svg(Shading::gouraud));
}

}  // namespace
}  // namespace displayfile
