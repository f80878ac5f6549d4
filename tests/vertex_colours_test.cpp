// Colours of vertices: linear over each triangle in space, within a stated error; neighbours are
// cut at the same points; everything else about the polygon is as without them.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "clip/geometry/back_face.h"
#include "displayfile/files.h"
#include "displayfile/looks/colour_pieces.h"
#include "interp/draw/draw.h"
#include "tests/error_of.h"
#include "tests/shaded_scenes.h"
#include "tests/truth_scenes.h"

namespace displayfile {
namespace {

using test::along;
using test::Dice;
using test::error_of;
using test::expect_error;
using test::picture;
using Corners = std::array<ColouredCorner, 3>;

Colour any_colour(Dice& dice) { return {along(dice, 0, 1), along(dice, 0, 1), along(dice, 0, 1)}; }

Corners any_corners(Dice& dice) {
  Corners corners;
  for (ColouredCorner& corner : corners) {
    corner = {test::direction(dice), test::direction(dice), any_colour(dice)};
  }
  return corners;
}

/// The weights of a triangle's corners at a point of its plane.
Point3 weights(const Point3& a, const Point3& b, const Point3& c, const Point3& p) {
  const Point3 normal = glm::cross(b - a, c - a);
  const double whole = glm::dot(normal, normal);
  const double of_b = glm::dot(glm::cross(p - a, c - a), normal) / whole;
  const double of_c = glm::dot(glm::cross(b - a, p - a), normal) / whole;
  return {1.0 - of_b - of_c, of_b, of_c};
}

double largest_part(const Colour& difference) {
  return std::max({std::abs(difference.r), std::abs(difference.g), std::abs(difference.b)});
}

// ---- Pieces ----------------------------------------------------------------------------

TEST(ColourPieces, TileTheTriangleInColoursWithinHalfAStep) {
  Dice dice(1);
  ColourPieces pieces;
  for (int i = 0; i < 20; ++i) {
    const Corners corners = any_corners(dice);
    const auto& [a, b, c] = corners;
    const Point3 normal = glm::cross(b.point - a.point, c.point - a.point);
    pieces.cut(corners);
    double area = 0.0;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const auto [of_piece, fill] = pieces[k];
      ASSERT_GE(of_piece.size(), 3u);
      std::vector<Point3> points;
      for (const ColouredCorner& corner : of_piece) {
        points.push_back(corner.point);
        const Point3 w = weights(a.point, b.point, c.point, corner.point);
        const Colour colour = w.x * a.colour + w.y * b.colour + w.z * c.colour;
        EXPECT_LE(largest_part(fill - colour), 0.5 * ColourPieces::kStep + 1e-8);
        const Point3 normal_there = w.x * a.normal + w.y * b.normal + w.z * c.normal;
        EXPECT_LT(glm::distance(corner.normal, normal_there), 1e-8);
      }
      area += 0.5 * glm::dot(newell_normal(points), glm::normalize(normal));
    }
    EXPECT_NEAR(area, 0.5 * glm::length(normal), 1e-9);
  }
}

/// Whichever way the two run along it.
TEST(ColourPieces, OfNeighboursMeetInTheSamePoints) {
  Dice dice(2);
  ColourPieces pieces;
  for (int i = 0; i < 50; ++i) {
    Corners one = any_corners(dice), other = any_corners(dice);
    one[0].point.z = one[1].point.z = 1.0;
    one[2].point.z = 0.0;
    other = {one[1], one[0], other[2]};
    other[2].point.z = 2.0;
    const auto on_the_side = [&](const Corners& corners) {
      std::set<std::tuple<double, double, double>> points;
      pieces.cut(corners);
      for (std::size_t k = 0; k < pieces.size(); ++k) {
        for (const ColouredCorner& corner : pieces[k].corners) {
          const Point3& p = corner.point;
          if (std::abs(p.z - 1.0) < 1e-12) points.insert({p.x, p.y, p.z});
        }
      }
      return points;
    };
    const auto of_one = on_the_side(one);
    EXPECT_GT(of_one.size(), 10u);
    EXPECT_EQ(of_one, on_the_side(other));
  }
}

/// Where the parts of the colour pass steps together, no needles are left between them.
TEST(ColourPieces, OfOneColourToAnotherAreBands) {
  const auto count = [](const Colour& from, const Colour& to) {
    ColourPieces pieces;
    pieces.cut({{{{0.1, 0, 0}, Point3(0.0), from},
                 {{1, 0.3, 0}, Point3(0.0), from},
                 {{0.2, 0.7, 0.1}, Point3(0.0), to}}});
    return pieces.size();
  };
  EXPECT_EQ(count({0, 0, 0}, {1, 1, 1}), 85u);
  EXPECT_EQ(count({1, 0, 0}, {0, 0, 1}), 85u);
  EXPECT_EQ(count({0.2, 0.2, 0.2}, {0.2, 0.2, 0.2}), 1u);
  EXPECT_EQ(count({0, 0, 0}, {0, 3.0 / 255.0, 0}), 1u);
  EXPECT_EQ(count({0, 0, 0}, {0, 4.0 / 255.0, 0}), 2u);
}

// ---- Pictures --------------------------------------------------------------------------

const std::vector<Point3> kTriangle{{-0.9, -0.8, 0.6}, {0.8, -0.5, -1.5}, {-0.1, 0.7, -0.2}};
const std::vector<Colour> kColours{{1, 0, 0.2}, {0.1, 0.9, 0}, {0, 0.3, 1}};

constexpr double kEyeDistance = 3.0;

void look_from_near(GraphicsSystem& g) {
  g.set_perspective({0, 0, kEyeDistance});
  g.set_view_depth(-2, 2);
  g.set_line_style({LineStyle::Kind::none});
}

GraphicsSystem triangle_in_colours() {
  GraphicsSystem g;
  look_from_near(g);
  g.open_segment(1);
  g.set_vertex_colours(kColours);
  g.polygon_abs_3(kTriangle);
  g.close_segment();
  return g;
}

/// The colour of the triangle where the line of sight through a pixel's centre meets it.
Colour colour_at(const Picture& of, int x, int row) {
  const Point3 eye(0, 0, kEyeDistance);
  const Point3 through((x + 0.5) / of.width * 2 - 1, 1 - (row + 0.5) / of.height * 2, 0);
  const Point3 normal = glm::cross(kTriangle[1] - kTriangle[0], kTriangle[2] - kTriangle[0]);
  const double t = glm::dot(kTriangle[0] - eye, normal) / glm::dot(through - eye, normal);
  const Point3 w = weights(kTriangle[0], kTriangle[1], kTriangle[2], eye + t * (through - eye));
  return w.x * kColours[0] + w.y * kColours[1] + w.z * kColours[2];
}

/// In perspective: linear in space, and not over the picture.
TEST(VertexColours, AreLinearOverTheTriangleInSpace) {
  const GraphicsSystem g = triangle_in_colours();
  for (const HiddenMethod method : {HiddenMethod::z_buffer, HiddenMethod::map, HiddenMethod::bsp}) {
    const Picture seen = picture(g, method);
    int covered = 0;
    for (int row = 0; row < seen.height; ++row) {
      for (int x = 0; x < seen.width; ++x) {
        const auto at = static_cast<std::size_t>(row * seen.width + x);
        if (seen.ids[at] < 0) continue;
        ASSERT_EQ(seen.ids[at], 0);
        ++covered;
        const std::uint32_t pixel = seen.pixels[at];
        const Colour shown(pixel & 255, pixel >> 8 & 255, pixel >> 16 & 255);
        EXPECT_LE(largest_part(shown - 255.0 * colour_at(seen, x, row)), 2.0 + 1e-6)
            << x << " " << row;
      }
    }
    EXPECT_GT(covered, 1000);
  }
}

TEST(VertexColours, AreLit) {
  GraphicsSystem g;
  look_from_near(g);
  g.set_light(test::kLight, test::kAmbient);
  g.open_segment(1);
  g.set_vertex_colours(kColours);
  g.polygon_abs_3(kTriangle);
  g.close_segment();
  const Picture lit = picture(g, HiddenMethod::z_buffer);
  const Picture unlit = picture(triangle_in_colours(), HiddenMethod::z_buffer);
  const Point3 normal = glm::cross(kTriangle[1] - kTriangle[0], kTriangle[2] - kTriangle[0]);
  const double intensity = test::intensity_of(normal);
  ASSERT_LT(intensity, 0.95);
  for (std::size_t i = 0; i < lit.pixels.size(); ++i) {
    if (lit.ids[i] < 0) continue;
    EXPECT_NEAR(lit.pixels[i] >> 8 & 255, intensity * (unlit.pixels[i] >> 8 & 255), 1.01);
  }
}

/// Colours that hardly differ: pieces are shaded as one fill, in a parallel view, where normals are
/// linear over the picture and in space.
TEST(VertexColours, AreShadedSmoothly) {
  const std::vector<Point3> normals{{-1, 0, 1}, {1, 0.2, 1}, {0, 1, 1}};
  const auto shaded = [&](bool in_colours) {
    GraphicsSystem g;
    g.set_view_depth(-2, 2);
    g.set_line_style({LineStyle::Kind::none});
    g.set_light(test::kLight, test::kAmbient);
    g.set_shading(Shading::phong);
    g.open_segment(1);
    g.set_vertex_normals(normals);
    g.set_fill_style({FillStyle::Kind::solid, {0.5, 0.5, 0.5}});
    if (in_colours) g.set_vertex_colours({{0.48, 0.5, 0.5}, {0.5, 0.52, 0.5}, {0.5, 0.5, 0.5}});
    g.polygon_abs_3(kTriangle);
    g.close_segment();
    return picture(g, HiddenMethod::z_buffer);
  };
  EXPECT_LE(compare(shaded(true), shaded(false)).largest, 7.0);
}

// ---- The rest of the polygon -----------------------------------------------------------

/// Sides that are drawn, fills that are hollow, and polygons, of a display file.
struct Held {
  int sides = 0, hollow = 0, polygons = 0;
  std::set<int> picks;
  bool is_hollow = false;

  explicit Held(const GraphicsSystem& g) {
    for (const Segment& s : g.display_file().segments()) s.walk_entered(*this);
  }
  void fill(const FillStyle& style) { is_hollow = style.kind == FillStyle::Kind::hollow; }
  void line_style(const LineStyle&) {}
  void pick(int id) { picks.insert(id); }
  void move(const Point3&) {}
  void line(const Point3&) {}
  void polygon(std::span<const Point3>, std::span<const std::int32_t> of_sides) {
    ++polygons;
    hollow += is_hollow ? 1 : 0;
    sides += static_cast<int>(std::ranges::count(of_sides, op::line));
  }
};

const std::vector<Point3> kSquare{{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}};
const std::vector<Colour> kOfSquare{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}};

TEST(VertexColours, LeaveThePolygonsSidesAndPicks) {
  for (const LineStyle::Kind kind : {LineStyle::Kind::solid, LineStyle::Kind::none}) {
    GraphicsSystem g;
    g.set_line_style({kind});
    g.open_segment(1);
    for (int i = 0; i < 2; ++i) {
      g.set_vertex_colours(kOfSquare);
      g.polygon_abs_3(kSquare);
    }
    g.close_segment();
    const Held held(g);
    const bool outlined = kind == LineStyle::Kind::solid;
    EXPECT_EQ(held.sides, outlined ? 8 : 0);
    EXPECT_EQ(held.hollow, outlined ? 2 : 0);
    EXPECT_GT(held.polygons, 2000);
    EXPECT_EQ(held.picks, (std::set{0, 1}));
    EXPECT_EQ(g.counts().polygons, 2);
  }
}

TEST(VertexColours, ThatAreEqualAreAFillStyle) {
  const Colour colour{0.3, 0.1, 0.7};
  const auto square = [&](bool as_vertices) {
    GraphicsSystem g;
    g.open_segment(1);
    if (as_vertices) {
      g.set_vertex_colours(std::vector<Colour>(4, colour));
    } else {
      g.set_fill_style({FillStyle::Kind::solid, colour});
    }
    g.polygon_abs_3(kSquare);
    g.close_segment();
    return dump(g.display_file());
  };
  EXPECT_EQ(square(true), square(false));
}

TEST(VertexColours, AreInPlaceOfAHollowFillForOnePolygon) {
  GraphicsSystem g;
  g.set_fill_style({FillStyle::Kind::hollow});
  g.set_line_style({LineStyle::Kind::none});
  g.open_segment(1);
  g.set_vertex_colours(kOfSquare);
  g.polygon_abs_3(kSquare);
  EXPECT_EQ(g.looks().attributes.fill.kind, FillStyle::Kind::hollow);
  EXPECT_EQ(Held(g).hollow, 0);
  g.polygon_abs_3(kSquare);
  EXPECT_EQ(Held(g).hollow, 1);
  g.set_vertex_colours(kOfSquare);
  g.set_vertex_colours({});
  g.polygon_abs_3(kSquare);
  EXPECT_EQ(Held(g).hollow, 2);
  g.close_segment();
}

/// Half as large, which rounds nothing.
TEST(VertexColours, FollowTheModellingTransformation) {
  const auto square = [](double scale, double size) {
    GraphicsSystem g;
    g.set_hidden_surfaces({.method = HiddenMethod::bsp});  // decides from points as entered
    g.scale_3(scale, scale, scale);
    g.open_segment(1);
    g.set_vertex_colours(kOfSquare);
    std::vector<Point3> vertices = kSquare;
    for (Point3& p : vertices) p *= size;
    g.polygon_abs_3(vertices);
    g.close_segment();
    return dump(g.display_file());
  };
  EXPECT_EQ(square(0.5, 1.0), square(1.0, 0.5));
}

TEST(VertexColours, OfManyPolygonsAreThoseOfEach) {
  const std::vector<std::uint32_t> corners{0, 1, 2, 3};
  const std::vector<std::uint32_t> sides{4};
  GraphicsSystem one_by_one, at_once;
  one_by_one.open_segment(1);
  one_by_one.set_vertex_colours(kOfSquare);
  one_by_one.polygon_abs_3(kSquare);
  one_by_one.close_segment();
  at_once.open_segment(1);
  at_once.polygons_abs_3(
      {.vertices = kSquare, .corners = corners, .sides = sides, .vertex_colours = kOfSquare});
  at_once.close_segment();
  EXPECT_EQ(dump(at_once.display_file()), dump(one_by_one.display_file()));
}

/// Pieces have no cut faces: a solid stays open, and one that should be closed is refused.
TEST(VertexColours, OfSolidsThatAreCut) {
  const std::vector<Point3> vertices{{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0, 0.5, 0}, {0, 0, 0.7}};
  const std::vector<std::uint32_t> corners{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  const ManyPolygons solid{.vertices = vertices, .corners = corners, .vertex_colours = kOfSquare};
  const auto enter = [&](GraphicsSystem& g, CutFaces::Kind faces) {
    g.set_cut_faces({faces});
    g.set_cutting_plane(1, 1, 0, 0, -0.1);
    g.open_segment(1);
    g.polygons_abs_3(solid);
    g.close_segment();
  };
  std::ostringstream recording;
  Recorder recorder(recording);
  GraphicsSystem cut, replayed, closed;
  cut.set_recorder(&recorder);
  enter(cut, CutFaces::Kind::open);
  EXPECT_GT(Held(cut).polygons, 500);
  replay(recording.str(), "recording", replayed);
  EXPECT_EQ(dump(replayed.display_file()), dump(cut.display_file()));
  expect_error([&] { enter(closed, CutFaces::Kind::closed); },
               "colours of vertices within a solid");
  EXPECT_EQ(Held(closed).polygons, 0);
}

TEST(VertexColours, HaveToFitThePolygon) {
  GraphicsSystem g;
  EXPECT_NE(error_of([&] { g.set_vertex_colours({{0, 0, 1}, {0, 0, 1}}); }), "");
  expect_error([&] { g.set_vertex_colours({{0, 0, 1}, {0, 0, 1}, {0, 1, 1.01}}); }, "1.01");
  g.open_segment(1);
  g.set_vertex_colours(kColours);
  EXPECT_EQ(error_of([&] { g.polygon_abs_3(kSquare); }),
            "polygon of 4 sides: expected 3, as many as set-vertex-colours has");
  const std::vector<double> heights{0, 1, 1, 0};
  EXPECT_EQ(error_of([&] {
              g.surface_3({0, 0.5, 2, 0, 0.5, 2, heights});
            }),
            "colours of one polygon's vertices are set: expected none before a surface");
  expect_error([&] { g.polygons_abs_3({}); }, "colours of one polygon's vertices are set");
  g.begin_solid();
  expect_error([&] { g.polygon_abs_3(kTriangle); }, "colours of vertices within a solid");
  g.discard_solid();
  g.polygon_abs_3(kSquare);  // without colours
  const std::vector<std::uint32_t> corners{0, 1, 2};
  const std::vector<FillStyle> fill(1);
  expect_error(
      [&] {
        g.polygons_abs_3({.vertices = kTriangle, .corners = corners, .vertex_colours = kOfSquare});
      },
      "4 colours of 3 vertices");
  expect_error(
      [&] {
        g.polygons_abs_3(
            {.vertices = kTriangle, .corners = corners, .fills = fill, .vertex_colours = kColours});
      },
      "expected one of them");
  g.close_segment();
}

// ---- In drawing programs ---------------------------------------------------------------

std::string dump_of(const std::string& colours) {
  GraphicsSystem g;
  replay("open-segment 1\nset-vertex-colours " + colours +
             "\npolygon-abs-2 0 0 1 0 0 1\nclose-segment\n",
         "p", g);
  return dump(g.display_file());
}

TEST(VertexColours, AreNumbersOrWords) {
  const std::string expected = dump_of("1 0 0  0 1 0  0 0 1");
  EXPECT_EQ(dump_of("red lime blue"), expected);
  EXPECT_EQ(dump_of("#f00 #00ff00 0 0 1  # the corners"), expected);
  EXPECT_EQ(dump_of("red 0 1 0 #00f"), expected);
  EXPECT_NE(dump_of("red lime #00e"), expected);
  EXPECT_NE(dump_of(""), expected);
  expect_error([] { dump_of("red lime blu"); }, "p:2:29: unknown colour 'blu': did you mean");
  expect_error([] { dump_of("1 0 0  0 1 0  0 0"); }, "expected r g b");
  expect_error([] { dump_of("1 0 0  0 1 0  0 0 7"); }, "7");
}

}  // namespace
}  // namespace displayfile
