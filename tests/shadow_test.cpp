// The guarantees of shadows: they lie where the world's geometry puts them, whatever the view and
// the hidden-surface method; lit surfaces have no speckles; and with shadows off nothing changes.
// The independent judge is a ray in world coordinates from every visible point.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "displayfile/files.h"
#include "displayfile/text/dump_compare.h"
#include "displayfile/views/retained_views.h"
#include "interp/device/raster_request.h"
#include "interp/draw/draw.h"
#include "interp/files/picture_compare.h"
#include "interp/raster/software.h"
#include "interp/visibility/image_space.h"
#include "tests/truth_scenes.h"

namespace displayfile {
namespace {

using test::Dice;

constexpr int kSize = 48;
constexpr double kAmbient = 0.25;
const Colour kColour{0.9, 0.6, 0.3};

using Polygons = std::vector<std::vector<Point3>>;

/// The window is [-1,1] x [-1,1] in the plane z = 0, which the viewer looks at along -z.
struct Viewer {
  std::optional<Point3> centre;  // of a perspective view
  Point3 parallel{0, 0, 1};

  void set(GraphicsSystem& g) const {
    centre ? g.set_perspective(*centre) : g.set_parallel(parallel);
    g.set_view_depth(-2, 2);
  }
  Point3 toward(const Point3& p) const { return centre ? *centre - p : parallel; }
};
const std::vector<Viewer> kViewers{{}, {{}, {0.3, -0.2, 1}}, {Point3(0.2, 0.3, 3.0)}};

void enter(const Polygons& polygons, GraphicsSystem& g, int segment = 1) {
  g.open_segment(segment);
  for (const auto& polygon : polygons) g.polygon_abs_3(polygon);
  g.close_segment();
}

void set_style(const Point3& light, bool shadows, GraphicsSystem& g) {
  g.set_fill_style({FillStyle::Kind::solid, kColour});
  g.set_line_style({LineStyle::Kind::none});
  g.set_light(light, kAmbient);
  g.set_shadows(shadows);
}

GraphicsSystem drawn(const Polygons& polygons, const Point3& light, const Viewer& viewer = {},
                     bool shadows = true) {
  GraphicsSystem g;
  viewer.set(g);
  set_style(light, shadows, g);
  enter(polygons, g);
  return g;
}

Picture picture(const GraphicsSystem& g, HiddenMethod method = HiddenMethod::z_buffer,
                int threads = 1, int size = kSize) {
  DrawOptions options{.width = size, .height = size, .samples = 1};
  options.surfaces.method = method;
  options.surfaces.threads = threads;
  options.ids = "asked for";
  return draw(g, options);
}

const std::uint32_t kInShadow = pixel_of(kColour * kAmbient);

std::size_t shadowed(const Picture& p) {
  return static_cast<std::size_t>(std::ranges::count(p.pixels, kInShadow));
}

/// Pixels that differ.
std::size_t others(const Picture& a, const Picture& b) {
  return static_cast<std::size_t>(compare(a, b).wrong_pixels);
}

bool nearly(std::uint32_t a, std::uint32_t b) {
  for (const int shift : {0, 8, 16}) {
    const int p = static_cast<int>(a >> shift & 0xFF), q = static_cast<int>(b >> shift & 0xFF);
    if (std::abs(p - q) > 1) return false;
  }
  return true;
}

// ---- The judge ---------------------------------------------------------------------------

enum class Judged { lit, in_shadow, close };

/// A point or a ray this close to an edge, or to another polygon, is not judged. World coordinates.
constexpr double kClose = 1e-9;

Point3 normal_of(const std::vector<Point3>& polygon) {
  return glm::normalize(glm::cross(polygon[1] - polygon[0], polygon[2] - polygon[0]));
}

/// The distance of a point of a convex polygon's plane from its sides; negative outside.
double inside_by(const std::vector<Point3>& polygon, const Point3& p) {
  const Point3 n = normal_of(polygon);
  double least = 1e9;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point3 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    least = std::min(least, glm::dot(glm::cross(n, glm::normalize(b - a)), p - a));
  }
  return least;
}

Judged judge(const Polygons& polygons, std::size_t own, const Point3& p, const Point3& light) {
  bool close = false;
  for (std::size_t k = 0; k < polygons.size(); ++k) {
    if (k == own) continue;
    const Point3 n = normal_of(polygons[k]);
    const double toward = glm::dot(n, light);
    const double t = glm::dot(n, polygons[k][0] - p) / toward;
    if (!(std::abs(toward) > kClose) || t < -kClose) continue;
    const double inside = inside_by(polygons[k], p + t * light);
    if (inside < -kClose) continue;
    if (inside > kClose && t > kClose) return Judged::in_shadow;
    close = true;
  }
  return close ? Judged::close : Judged::lit;
}

struct Agreement {
  std::size_t lit = 0, in_shadow = 0, close = 0, wrong = 0;
};

/// Judges a picture of convex polygons whose identifiers are their indices.
Agreement agreement(const Picture& seen, const Polygons& polygons, const Point3& light,
                    const Viewer& viewer) {
  Agreement sum;
  const Point3 to_light = glm::normalize(light);
  for (int row = 0; row < seen.height; ++row) {
    for (int column = 0; column < seen.width; ++column) {
      const auto at = static_cast<std::size_t>((seen.height - 1 - row) * seen.width + column);
      if (seen.ids[at] < 0) continue;
      const auto own = static_cast<std::size_t>(seen.ids[at]);
      const Point3 in_window((column + 0.5) / seen.width * 2 - 1, (row + 0.5) / seen.height * 2 - 1,
                             0.0);
      const Point3 n = normal_of(polygons[own]), d = viewer.toward(in_window);
      const Point3 p = in_window + d * (glm::dot(n, polygons[own][0] - in_window) / glm::dot(n, d));
      const double cosine = glm::dot(n, to_light) * (glm::dot(n, d) < 0 ? -1 : 1);
      const double intensity = kAmbient + (1 - kAmbient) * std::max(0.0, cosine);
      const Judged judged = judge(polygons, own, p, to_light);
      if (judged == Judged::close) {
        ++sum.close;
        continue;
      }
      ++(judged == Judged::lit ? sum.lit : sum.in_shadow);
      const auto expected = judged == Judged::lit ? pixel_of(kColour * intensity) : kInShadow;
      if (!nearly(seen.pixels[at], expected)) ++sum.wrong;
    }
  }
  return sum;
}

// ---- Scenes ------------------------------------------------------------------------------

double along(Dice& dice, double low, double high) { return low + (high - low) * dice.part(); }

Point3 somewhere(Dice& dice, double far) {
  return {along(dice, -far, far), along(dice, -far, far), along(dice, -far, far)};
}

Point3 direction(Dice& dice) {
  Point3 d;
  do {
    d = somewhere(dice, 1.0);
  } while (glm::length(d) < 0.1);
  return d;
}

/// Triangles and parallelograms that pass through each other, all within the window.
Polygons crossing(std::uint32_t seed, int count) {
  Dice dice(seed);
  Polygons polygons;
  for (int i = 0; i < count; ++i) {
    const Point3 a = somewhere(dice, 0.3), b = 0.3 * direction(dice), c = 0.3 * direction(dice);
    if (dice.one_in(2)) {
      polygons.push_back({a + b, a + c, a - b - c});
    } else {
      polygons.push_back({a + b, a + c, a - b, a - c});
    }
  }
  return polygons;
}

std::vector<Point3> square(const Point3& middle, const Point3& across, const Point3& up) {
  return {middle - across - up, middle + across - up, middle + across + up, middle - across + up};
}

/// A cube's six sides, one of which faces +n; turned about y and x.
Polygons cube(const Point3& middle, double half, double turn = 0.0) {
  const double c = std::cos(turn), s = std::sin(turn);
  const Point3 x(c, s * s, -s * c), y(0, c, s), z(s, -s * c, c * c);
  Polygons sides;
  for (const auto& [u, v, w] : {std::array{x, y, z}, std::array{y, z, x}, std::array{z, x, y}}) {
    sides.push_back(square(middle + half * w, half * u, half * v));
    sides.push_back(square(middle - half * w, half * v, half * u));
  }
  return sides;
}

/// A ball of triangles that share their vertices.
Polygons ball(const Point3& middle, double radius, int around, int up) {
  const auto point = [&](int i, int k) {
    const double a = std::numbers::pi * i / up, b = 2 * std::numbers::pi * (k % around) / around;
    return middle +
           radius * Point3(std::sin(a) * std::sin(b), -std::cos(a), std::sin(a) * std::cos(b));
  };
  const Point3 south = middle - Point3(0, radius, 0), north = middle + Point3(0, radius, 0);
  Polygons sides;
  for (int k = 0; k < around; ++k) {
    sides.push_back({south, point(1, k + 1), point(1, k)});
    sides.push_back({north, point(up - 1, k), point(up - 1, k + 1)});
    for (int i = 1; i + 1 < up; ++i) {
      sides.push_back({point(i, k), point(i, k + 1), point(i + 1, k + 1)});
      sides.push_back({point(i, k), point(i + 1, k + 1), point(i + 1, k)});
    }
  }
  return sides;
}

Polygons together(Polygons a, const Polygons& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// ---- Where shadows lie --------------------------------------------------------------------

/// The square's shadow on the floor, which faces the viewer, is the square moved away from the
/// light by as far as it is above the floor.
TEST(Shadows, OfASquareIsTheSquareThatGeometrySays) {
  const double above = 0.5, half = 0.2;
  const Polygons scene{square({0, 0, -above}, {0.95, 0, 0}, {0, 0.95, 0}),
                       square({0.1, 0.05, 0}, {half, 0, 0}, {0, half, 0})};
  for (const Point3& light :
       {Point3(0.6, 0.3, 1), Point3(-1.1, 0.7, 1), Point3(-0.3, -1.3, 0.9), Point3(1, -0.8, 2)}) {
    const Picture seen = picture(drawn(scene, light), HiddenMethod::z_buffer, 1, 100);
    const double x = 0.1 - above * light.x / light.z, y = 0.05 - above * light.y / light.z;
    std::size_t in_shadow = 0, wrong = 0;
    for (int row = 0; row < 100; ++row) {
      for (int column = 0; column < 100; ++column) {
        const auto at = static_cast<std::size_t>((99 - row) * 100 + column);
        if (seen.ids[at] != 0) continue;
        const double dx = std::abs((column + 0.5) / 50 - 1 - x) - half;
        const double dy = std::abs((row + 0.5) / 50 - 1 - y) - half;
        if (std::abs(dx) < kClose || std::abs(dy) < kClose) continue;
        const bool expected = dx < 0 && dy < 0;
        in_shadow += expected ? 1 : 0;
        wrong += expected == (seen.pixels[at] == kInShadow) ? 0 : 1;
      }
    }
    EXPECT_EQ(wrong, 0u);
    EXPECT_GT(in_shadow, 100u);
  }
}

TEST(Shadows, LieWhereRaysInTheWorldSay) {
  Agreement all;
  for (std::uint32_t seed = 1; seed <= 40; ++seed) {
    Dice dice(seed + 1000);
    const Polygons scene = crossing(seed, 12);
    for (const Viewer& viewer : kViewers) {
      for (int k = 0; k < 4; ++k) {
        const Point3 light = direction(dice);
        const Agreement one = agreement(picture(drawn(scene, light, viewer)), scene, light, viewer);
        EXPECT_EQ(one.wrong, 0u) << "seed " << seed << " light " << k;
        all.lit += one.lit;
        all.in_shadow += one.in_shadow;
        all.close += one.close;
      }
    }
  }
  EXPECT_GT(all.in_shadow, 20000u);
  EXPECT_GT(all.lit, 20000u);
  EXPECT_LT(all.close, 100u);
}

/// The boxes stand on the floor, and no light gets in under their sides; sides that the viewer sees
/// edge-on hide the light like others. Nothing is clipped.
TEST(Shadows, OfBoxesOnAFloorBeginAtTheBoxes) {
  const Polygons floor{square({0, -0.5, 0}, {0.6, 0, 0}, {0, 0, -0.6})};
  const Polygons upright =
      together(together(floor, cube({-0.3, -0.3, 0.1}, 0.2)), cube({0.35, -0.35, -0.2}, 0.15));
  const Polygons wall{square({0, 0, -0.5}, {0.6, 0, 0}, {0, 0.6, 0})};
  const Polygons facing = together(wall, cube({-0.3, 0.1, -0.3}, 0.2));
  std::size_t in_shadow = 0;
  for (const Polygons& scene : {upright, facing}) {
    for (const Viewer& viewer : {Viewer{{}, {0, 0, 1}}, Viewer{{}, {0.2, 0.7, 1}},
                                 Viewer{Point3(0.3, 1.2, 3)}, Viewer{Point3(0.1, 0.2, 4)}}) {
      for (const Point3& light : {Point3(1, 1, 0.4), Point3(-1, 0.5, 0.3), Point3(0.5, 1, -0.6),
                                  Point3(0, 1, 1), Point3(1, 0.3, 0)}) {
        const Agreement one = agreement(picture(drawn(scene, light, viewer)), scene, light, viewer);
        EXPECT_EQ(one.wrong, 0u);
        in_shadow += one.in_shadow;
      }
    }
  }
  EXPECT_GT(in_shadow, 3000u);
}

/// On a closed convex body the parts turned to the light are lit, and all others are dark anyway.
TEST(Shadows, AClosedConvexBodyHasNoneOnItself) {
  Dice dice(7);
  std::size_t coloured = 0;
  for (const double size : {1e-3, 1.0, 1e4}) {
    for (const double offset : {0.0, 1.0, 300.0, 1e5}) {
      const Point3 middle = size * offset * Point3(0.7, -0.4, 0.6);
      for (const Polygons& body :
           {cube(middle, size), cube(middle, size, 0.35), cube(middle, size, 1.1),
            ball(middle, size, 12, 7), ball(middle, size, 40, 30)}) {
        for (const bool perspective : {false, true}) {
          const Point3 light = direction(dice);
          const auto with = [&](bool shadows) {
            GraphicsSystem g;
            g.set_view_reference_point(middle);
            g.set_window(-1.8 * size, 1.8 * size, -1.8 * size, 1.8 * size);
            g.set_view_depth(-3 * size, 3 * size);
            if (perspective) g.set_perspective(middle + size * Point3(1, 2, 6));
            set_style(light, shadows, g);
            enter(body, g);
            return picture(g, HiddenMethod::z_buffer, 1, 64);
          };
          const Picture plain = with(false);
          coloured += static_cast<std::size_t>(
              std::ranges::count_if(plain.ids, [](int id) { return id >= 0; }));
          EXPECT_EQ(others(with(true), plain), 0u)
              << body.size() << " sides, size " << size << ", offset " << offset;
        }
      }
    }
  }
  EXPECT_GT(coloured, 50000u);
}

TEST(Shadows, NoneIsCastByWhatTheLightSeesEdgeOn) {
  const Point3 light(0.3, 0.2, 1);
  const Polygons wall{square({0, 0, -0.5}, {0.9, 0, 0}, {0, 0.9, 0})};
  const Point3 across = 0.3 * glm::normalize(glm::cross(light, Point3(0.1, 1, 0.05)));
  const Polygons scene = together(wall, {square({0.0123, 0.0321, 0}, across, 0.2 * light)});
  const Picture seen = picture(drawn(scene, light));
  EXPECT_EQ(shadowed(seen), static_cast<std::size_t>(std::ranges::count(seen.ids, 1)));
}

/// It is dark already, and nothing more is stored for it.
TEST(Shadows, NoneIsSeenOnWhatIsTurnedAwayFromTheLight) {
  const Polygons scene = together({square({0, 0, -0.5}, {0.9, 0, 0}, {0, 0.9, 0})},
                                  {square({0, 0, 0}, {0.3, 0, 0}, {0, 0.3, 0})});
  const Point3 light(0.2, 0.3, -1);
  EXPECT_EQ(dump(drawn(scene, light).display_file()),
            dump(drawn(scene, light, {}, false).display_file()));
}

TEST(Shadows, OneOnAnotherCoplanarFillIsNot) {
  for (const Viewer& viewer : kViewers) {
    const Point3 u(0.5, 0.1, 0.2), v(-0.1, 0.6, -0.3), light(0.3, 0.4, 1);
    const Polygons scene{square({0, 0, 0}, u, v), square({0, 0, 0}, 0.5 * u, 0.5 * v),
                         square(0.1 * u, 0.3 * v, 0.2 * u)};
    EXPECT_EQ(shadowed(picture(drawn(scene, light, viewer))), 0u);
  }
}

/// Far from the origin, in decimals; and a rug that lies in the floor's plane by a length.
TEST(Shadows, OneOnAnotherThatItTouchesIsNot) {
  for (const char* scene :
       {"set-view-reference-point 5000000 0 0\n{}\nopen-segment 1\n"
        "polygon-abs-3 4999998.7 0.52 -1.3  4999998.7 0.25 1.4  5000001.5 -0.59 1.4"
        "  5000001.5 -0.32 -1.3\n"
        "set-fill-style solid 1 0.5 0.5\n"
        "polygon-abs-3 4999999.5 0.21 -0.6  4999999.7 0.06 0.3  5000000.6 -0.19 0.1\n",
        "set-touching 0.001\n{}\nopen-segment 1\n"
        "polygon-abs-3 -2 0 -2  -2 0 2  2 0 2  2 0 -2\n"
        "set-fill-style solid 1 0.5 0.5\n"
        "polygon-abs-3 -1 -0.0004 -1  -1 -0.0004 1  1 -0.0004 1  1 -0.0004 -1\n"}) {
    const auto picture = [&](const char* shadows) {
      GraphicsSystem g;
      replay(
          "set-view-plane-normal -1 -2 -2\nset-parallel 1 2 2\nset-window -2 2 -2 2\n"
          "set-line-style none\nset-light 0.3 1 0.2 0.3\nset-fill-style solid 0.5 1 0.5\n" +
              fmt::format(fmt::runtime(scene), shadows) + "close-segment\n",
          "touching.draw", g);
      return draw(g, {.width = 64, .height = 64, .samples = 1});
    };
    EXPECT_EQ(picture("set-shadows on").pixels, picture("set-shadows off").pixels);
  }
}

/// Whatever entered it, and whether or not there was light.
TEST(Shadows, AreCastByEverySolidFillThatIsVisible) {
  const Polygons floor{square({0, 0, -0.5}, {0.9, 0, 0}, {0, 0.9, 0})};
  const Polygons roof{square({0, 0, 0}, {0.3, 0, 0}, {0, 0.3, 0})};
  const auto with = [&](const FillStyle& style, bool visible) {
    GraphicsSystem g;
    g.set_line_style({LineStyle::Kind::none});
    g.set_fill_style(style);
    enter(roof, g, 1);
    set_style({1, 0, 1}, true, g);
    enter(floor, g, 2);
    g.set_visibility(1, visible);
    return shadowed(picture(g));
  };
  EXPECT_GT(with({FillStyle::Kind::solid, {0, 0, 1}}, true), 50u);
  EXPECT_EQ(with({FillStyle::Kind::hollow}, true), 0u);
  EXPECT_EQ(with({FillStyle::Kind::solid, {0, 0, 1}}, false), 0u);
}

TEST(Shadows, LinesAreNotInThem) {
  const auto with = [&](bool shadows) {
    GraphicsSystem g;
    set_style({1, 0, 1}, shadows, g);
    g.set_line_style({LineStyle::Kind::solid, {1, 0, 0}, 2.0});
    enter({square({0, 0, -0.5}, {0.9, 0, 0}, {0, 0.9, 0}),
           square({0.3, 0, 0}, {0.3, 0, 0}, {0, 0.3, 0})},
          g);
    return picture(g);
  };
  const Picture lit = with(false), seen = with(true);
  const std::uint32_t red = pixel_of({1, 0, 0});
  EXPECT_GT(shadowed(seen), 20u);
  for (std::size_t k = 0; k < lit.pixels.size(); ++k) {
    EXPECT_EQ(lit.pixels[k] == red, seen.pixels[k] == red);
  }
}

/// On a smoothly shaded fill too a shadow is the ambient light alone.
TEST(Shadows, LieOnSmoothShading) {
  const auto with = [&](bool shadows, Shading shading) {
    GraphicsSystem g;
    set_style({1, 0, 1}, shadows, g);
    g.set_shading(shading);
    g.open_segment(1);
    g.set_vertex_normals({{-0.2, 0, 1}, {0.2, 0, 1}, {0.2, 0, 1}, {-0.2, 0, 1}});
    g.polygon_abs_3(square({0, 0, -0.5}, {0.9, 0, 0}, {0, 0.9, 0}));
    g.set_vertex_normals({});
    g.polygon_abs_3(square({0.3, 0, 0}, {0.3, 0, 0}, {0, 0.3, 0}));
    g.close_segment();
    return picture(g);
  };
  for (const Shading shading : {Shading::gouraud, Shading::phong}) {
    const Picture lit = with(false, shading), seen = with(true, shading);
    EXPECT_EQ(shadowed(lit), 0u);
    EXPECT_GT(shadowed(seen), 50u);
    EXPECT_EQ(others(lit, seen), shadowed(seen));
  }
}

// ---- The same picture ---------------------------------------------------------------------

TEST(Shadows, AreTheSameByEveryMethodAndForAnyNumberOfThreads) {
  for (const std::uint32_t seed : {1u, 2u, 3u}) {
    const Viewer& viewer = kViewers[seed % kViewers.size()];
    const GraphicsSystem g = drawn(crossing(seed, 20), {0.5, 0.7, 1}, viewer);
    const Picture expected = picture(g);
    EXPECT_GT(shadowed(expected), 50u);
    for (const auto& entry : image_space_methods()) {
      for (const int threads : {1, 3}) {
        EXPECT_EQ(picture(g, entry.method, threads).pixels, expected.pixels)
            << name_of(entry.method);
      }
    }
    for (const HiddenMethod method : {HiddenMethod::bsp, HiddenMethod::depth_sort}) {
      EXPECT_EQ(picture(g, method, 2).pixels, expected.pixels) << name_of(method);
    }
  }
}

TEST(Shadows, OfRowsDrawnOneAfterTheOtherAreThose) {
  const GraphicsSystem g = drawn(crossing(4, 20), {0.5, 0.7, 1});
  SoftwareRenderer renderer;
  for (const HiddenMethod method : {HiddenMethod::z_buffer, HiddenMethod::none}) {
    // So wide that the rows come in several parts.
    const RasterRequest request{.width = 1 << 14, .height = 200, .surfaces = {.method = method}};
    const std::vector<std::uint32_t> whole = renderer.draw(g.display_file(), request).pixels;
    std::vector<std::uint32_t> rows;
    int parts = 0;
    renderer.draw(g.display_file(), request, [&](const Picture& some) {
      rows.insert(rows.end(), some.pixels.begin(), some.pixels.end());
      ++parts;
    });
    EXPECT_GT(parts, 1);
    EXPECT_TRUE(rows == whole);
    EXPECT_GT(std::ranges::count(whole, kInShadow), 1000);
  }
}

/// A renderer that has drawn one display file draws the next with its own shadows.
TEST(Shadows, AreThoseOfTheDisplayFileThatIsDrawn) {
  SoftwareRenderer renderer;
  const GraphicsSystem a = drawn(crossing(4, 20), {0.5, 0.7, 1});
  const GraphicsSystem b = drawn(crossing(5, 20), {-0.5, 0.7, 1});
  const GraphicsSystem off = drawn(crossing(4, 20), {0.5, 0.7, 1}, {}, false);
  const auto request = [](HiddenMethod method) {
    return RasterRequest{.width = kSize, .height = kSize, .surfaces = {.method = method}};
  };
  const auto expected = [&](const GraphicsSystem& g, HiddenMethod method) {
    return draw_with_software(g.display_file(), request(method)).pixels;
  };
  for (const HiddenMethod method :
       {HiddenMethod::z_buffer, HiddenMethod::none, HiddenMethod::z_buffer}) {
    for (const GraphicsSystem* g : {&a, &b, &off, &a}) {
      EXPECT_EQ(renderer.draw(g->display_file(), request(method)).pixels, expected(*g, method));
    }
  }
}

/// The image transformation acts after viewing, and takes the shadows along.
TEST(Shadows, MoveWithTheImage) {
  GraphicsSystem g = drawn(crossing(6, 20), {0.5, 0.7, 1}, kViewers[2]);
  for (const HiddenMethod method : {HiddenMethod::z_buffer, HiddenMethod::depth_sort}) {
    g.set_image_rotation(1, 0);
    g.set_image_translation(1, 0, 0);
    const Picture before = picture(g, method);
    g.set_image_rotation(1, 90);
    g.set_image_translation(1, 1, 0);
    const Picture turned = picture(g, method);
    std::size_t differ = 0;
    for (std::size_t row = 0; row < kSize; ++row) {
      for (std::size_t column = 0; column < kSize; ++column) {
        differ +=
            turned.pixels[kSize * (kSize - 1 - column) + row] != before.pixels[kSize * row + column]
                ? 1
                : 0;
      }
    }
    EXPECT_GT(shadowed(before), 50u);
    EXPECT_LE(differ, 2u);  // a centre on an edge may be another polygon's
  }
}

TEST(Shadows, ARetainedSceneHasThemInEveryView) {
  for (const HiddenScope scope : {HiddenScope::segment, HiddenScope::all}) {
    GraphicsSystem g;
    RetainedScene scene;
    g.retain(&scene);
    kViewers[2].set(g);
    set_style({0.5, 0.7, 1}, true, g);
    enter(crossing(5, 20), g);
    g.set_image_translation(1, 0.0625, 0.125);
    RetainedViews views(scene, g.display_file(), {.scope = scope});
    const DisplayFile again = views.view(g.view());
    DisplayFile unsorted = again;
    unsorted.set_sorted(nullptr);
    unsorted.segment(1).set_sorted(nullptr);
    EXPECT_EQ(dump(unsorted), dump(g.display_file()));
    const RasterRequest sorted{.width = kSize, .height = kSize, .sorted = true, .ids = true};
    EXPECT_EQ(draw_with_software(again, sorted).pixels, picture(g).pixels);
  }
}

// ---- Stored data ----------------------------------------------------------------------------

TEST(Shadows, OffChangeNothing) {
  const Polygons scene = crossing(3, 20);
  const GraphicsSystem plain = [&] {
    GraphicsSystem g;
    kViewers[0].set(g);
    g.set_fill_style({FillStyle::Kind::solid, kColour});
    g.set_line_style({LineStyle::Kind::none});
    g.set_light({0.5, 0.7, 1}, kAmbient);
    enter(scene, g);
    return g;
  }();
  const GraphicsSystem off = drawn(scene, {0.5, 0.7, 1}, {}, false);
  EXPECT_EQ(dump(off.display_file()), dump(plain.display_file()));
  EXPECT_EQ(picture(off).pixels, picture(plain).pixels);
  EXPECT_FALSE(GraphicsSystem().looks().attributes.shadows);
}

TEST(Shadows, WithoutLightThereAreNone) {
  const auto with = [](bool shadows) {
    GraphicsSystem g;
    g.set_shadows(shadows);
    enter(crossing(3, 20), g);
    return dump(g.display_file());
  };
  EXPECT_EQ(with(true), with(false));
}

TEST(Shadows, InDumpsFollowTheFillAndAreCompared) {
  const std::string text =
      dump(drawn({square({0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0})}, {0, 0, 2}).display_file());
  EXPECT_NE(text.find("fill solid 0.9 0.6 0.3\nshadow 0.225 0.15 0.075 0 0 1 0\n"),
            std::string::npos)
      << text;
  std::string other = text;
  other.replace(other.find(" 0.075 "), 7, " 0.076 ");
  const auto difference = first_difference(text, other);
  ASSERT_TRUE(difference);
  EXPECT_NE(difference->find("blue is 0.075, expected 0.076"), std::string::npos) << *difference;
}

}  // namespace
}  // namespace displayfile
