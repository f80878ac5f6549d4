// Vertices within reach, and sides with the ends of others along them: solids whose faces are
// divided arbitrarily are drawn, closed and cut like undivided ones.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "displayfile/mesh/mesh.h"
#include "displayfile/mesh/section.h"
#include "hidden/touching/vertices_within_reach.h"
#include "tests/predicate_inputs.h"
#include "tests/quad_meshes.h"
#include "tests/random_views.h"
#include "tests/sides_of_kinds.h"

namespace displayfile {
namespace {

using test::Source;
using Polygon = std::vector<Point3>;

// ---- Vertices and sides ------------------------------------------------------------------------

TEST(VerticesWithinReach, EachIsTheFirstThatStandsForItself) {
  // The third is within reach of the second, which represents no others; likewise the fourth of the
  // third.
  const std::vector<Point3> points{{0, 0, 0}, {0.9, 0, 0}, {1.8, 0, 0}, {2.7, 0, 0}, {0, 0, 1}};
  EXPECT_EQ(first_within(points, 1.0), (std::vector<std::uint32_t>{0, 0, 2, 2, 0}));
  EXPECT_EQ(first_within(points, 0.0), (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
  const std::vector<Point3> equal{{1, 2, 3}, {0.0, 0, 0}, {1, 2, 3}, {-0.0, 0, 0}};
  EXPECT_EQ(first_within(equal, 0.0), (std::vector<std::uint32_t>{0, 1, 0, 1}));
}

/// Cells of which doubles cannot count as many as there are to a point.
TEST(VerticesWithinReach, FarBeyondTheReachThoseThatAreEqualAreOne) {
  const std::vector<Point3> points{{1e9, 1, 0}, {1e9, 1, 0}, {1e9, 1, 1e-30}, {-1e9, 0, 0}};
  EXPECT_EQ(first_within(points, 1e-20), (std::vector<std::uint32_t>{0, 0, 0, 3}));
}

TEST(VerticesWithinReach, AreFoundAcrossCells) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Source s(seed);
    const double reach = std::ldexp(1.0, -s.between(2, 12));
    std::vector<Point3> points;
    for (int n = 0; n < 300; ++n) {
      const Point3 cell(s.between(-3, 3), s.between(-3, 3), s.between(-1, 1));
      points.push_back(32.0 * reach * cell + 1.2 * reach * test::any_direction(s));
    }
    std::vector<std::uint32_t> expected(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      expected[i] = i;
      for (std::uint32_t k = 0; k < i && expected[i] == i; ++k) {
        if (expected[k] == k && glm::distance(points[k], points[i]) <= reach) expected[i] = k;
      }
    }
    EXPECT_EQ(first_within(points, reach), expected) << "seed " << seed;
  }
}

TEST(PartedSides, HaveTheEndsThatLieAlongThemInOrder) {
  const std::vector<Point3> points{{0, 0, 0}, {4, 0, 0}, {3, 1e-9, 0}, {1, -1e-9, 0},
                                   {2, 1, 0}, {5, 0, 0}, {2, 1e-6, 0}, {4.5, 0, 0}};
  const std::vector<SideOfPoints> sides{{0, 1}, {1, 0}, {2, 3}, {3, 4}, {5, 6}, {7, 4}};
  const PartedSides parted(points, sides, 1e-8);
  const auto along = [&](std::size_t side) {
    const auto of_side = parted.along(side);
    return std::vector<std::uint32_t>(of_side.begin(), of_side.end());
  };
  EXPECT_EQ(along(0), (std::vector<std::uint32_t>{3, 2}));
  EXPECT_EQ(along(1), (std::vector<std::uint32_t>{2, 3}));
  EXPECT_TRUE(along(2).empty());
  EXPECT_TRUE(along(3).empty());
  EXPECT_TRUE(along(5).empty());
}

/// Short sides are looked at together with long ones of other directions.
TEST(PartedSides, HaveTheEndsThatAreBesideThem) {
  const std::vector<Point3> points{{0, 0, 0}, {3, 0, 0},       {2, 0, 0},
                                   {2, 1, 0}, {2.005, 0.5, 0}, {3, 0.5, 0}};
  const std::vector<SideOfPoints> sides{{0, 1}, {2, 3}, {4, 5}};
  const PartedSides parted(points, sides, 0.01);
  ASSERT_EQ(parted.along(1).size(), 1u);
  EXPECT_EQ(parted.along(1)[0], 4u);
}

// ---- Solids ------------------------------------------------------------------------------------

/// A prism over an L, whose faces run counterclockwise seen from outside; the ends of the L are two
/// rectangles each, so that the end of the seam between them lies along a side of one.
std::vector<Polygon> prism(bool with_whole_ends) {
  const std::vector<Point2> outline{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}};
  const auto at = [](const Point2& p, double z) { return Point3(p, z); };
  std::vector<Polygon> faces;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Point2 &p = outline[k], &q = outline[(k + 1) % outline.size()];
    faces.push_back({at(p, 0), at(q, 0), at(q, 1), at(p, 1)});
  }
  std::vector<std::vector<Point2>> ends{{{0, 0}, {3, 0}, {3, 1}, {0, 1}},
                                        {{0, 1}, {1, 1}, {1, 2}, {0, 2}}};
  if (with_whole_ends) ends = {outline};
  for (const auto& end : ends) {
    Polygon top, bottom;
    for (const Point2& p : end) top.push_back(at(p, 1)), bottom.insert(bottom.begin(), at(p, 0));
    faces.push_back(top);
    faces.push_back(bottom);
  }
  return faces;
}

/// Cuts convex polygons in two, from a point of one side to one of another. Some of the points are
/// tied to their side by a triangle that has no area up to rounding.
void cut_some(Source& s, int cuts, bool with_needles, std::vector<Polygon>& faces) {
  for (int n = 0; n < cuts; ++n) {
    const auto f = static_cast<std::size_t>(s.below(static_cast<int>(faces.size())));
    const Polygon face = faces[f];
    const auto sides = static_cast<int>(face.size());
    int a = s.below(sides), b = s.below(sides - 1);
    if (b >= a) ++b;
    if (a > b) std::swap(a, b);
    const auto on_side = [&](int k) {
      const Point3 &p = face[static_cast<std::size_t>(k)],
                   &q = face[static_cast<std::size_t>((k + 1) % sides)];
      return p + (0.1 + 0.8 * s.unit()) * (q - p);
    };
    const Point3 from = on_side(a), to = on_side(b);
    Polygon one{from}, other{to};
    for (int k = a + 1; k <= b; ++k) one.push_back(face[static_cast<std::size_t>(k)]);
    one.push_back(to);
    for (int k = b + 1; k <= a + sides; ++k) {
      other.push_back(face[static_cast<std::size_t>(k % sides)]);
    }
    other.push_back(from);
    faces[f] = one;
    faces.push_back(other);
    if (!with_needles) continue;
    for (const auto& [k, point] : {std::pair(a, from), std::pair(b, to)}) {
      const auto side = static_cast<std::size_t>(k);
      faces.push_back({face[side], face[(side + 1) % face.size()], point});
    }
  }
}

/// Turned and moved, so that ends lie along sides up to rounding.
glm::dmat3 any_turn(Source& s) {
  const Point3 x = test::any_direction(s);
  const Point3 y = glm::normalize(glm::cross(x, test::any_direction(s)));
  return {x, y, glm::cross(x, y)};
}

struct Solids {
  std::vector<Polygon> clean, cut;
};
Solids any_solids(std::uint64_t seed, bool with_needles = false) {
  Source s(seed);
  Solids solids{prism(true), prism(false)};
  cut_some(s, s.between(0, 40), with_needles, solids.cut);
  if (seed % 4 == 0) return solids;
  const glm::dmat3 turn = any_turn(s);
  const Point3 move = 3.0 * test::any_direction(s);
  for (auto* const faces : {&solids.clean, &solids.cut}) {
    for (Polygon& face : *faces) {
      for (Point3& p : face) p = turn * p + move;
    }
  }
  return solids;
}

std::map<LineKinds, double> lengths(const std::vector<Polygon>& faces, const std::string& words,
                                    const Eye& eye) {
  const GraphicsSystem g = test::drawn_with(words, [&](GraphicsSystem& system) {
    for (const Polygon& face : faces) system.polygon_abs_3(face);
  });
  std::map<LineKinds, double> lengths;
  for (const auto& [ends, kinds] : test::sides_in_view(*g.retained(), eye)) {
    lengths[kinds] += glm::distance(ends.first, ends.second);
  }
  return lengths;
}

void expect_kinds_of_the_clean_solid(bool with_needles) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Solids solids = any_solids(seed, with_needles);
    Source s(seed);
    for (const char* const words : {"crease,boundary", "outline,crease", "outline"}) {
      const Eye eye = Eye::at(8.0 * test::any_direction(s));
      const auto expected = lengths(solids.clean, words, eye),
                 found = lengths(solids.cut, words, eye);
      EXPECT_EQ(found.size(), expected.size()) << "seed " << seed << ", " << words;
      for (const auto& [kinds, length] : expected) {
        EXPECT_NEAR(found.contains(kinds) ? found.at(kinds) : 0.0, length, 1e-9)
            << "seed " << seed << ", " << words << ": " << names_of(kinds);
      }
    }
  }
}

TEST(PartedSides, AreOfTheKindsOfTheCleanSolid) { expect_kinds_of_the_clean_solid(false); }

/// Whichever way rounding turns them.
TEST(PartedSides, WithNeedlesAlongThemAreOfTheKindsOfTheCleanSolid) {
  expect_kinds_of_the_clean_solid(true);
}

/// Where back faces are removed, a side of which only the other face stays is drawn as a line, and
/// no more.
TEST(PartedSides, AreDrawnWhereBackFacesAreRemoved) {
  const auto drawn_length = [](const std::vector<Polygon>& faces, const std::string& words) {
    GraphicsSystem g;
    g.set_perspective({1.5, 1.2, 30.0});
    g.set_window(-12.0, 12.0, -12.0, 12.0);
    g.set_view_depth(-12.0, 12.0);
    g.set_hidden_surfaces({.lines = line_selection(words)});
    g.set_back_face_removal(true);
    g.open_segment(1);
    for (const Polygon& face : faces) g.polygon_abs_3(face);
    g.close_segment();
    double length = 0.0;
    for (const auto& [ends, kinds] : test::drawn_sides(g.display_file())) {
      EXPECT_EQ(kinds & 128, 0);
      const Point3 way = ends.second - ends.first;
      length += std::hypot(way.x, way.y);
    }
    return length;
  };
  for (std::uint64_t seed = 1; seed < 200; ++seed) {
    if (seed % 4 == 0) continue;  // seen along an axis
    const Solids solids = any_solids(seed);
    for (const char* const words : {"crease,boundary", "outline,crease", "outline"}) {
      const double expected = drawn_length(solids.clean, words);
      EXPECT_GT(expected, 0.01);
      EXPECT_NEAR(drawn_length(solids.cut, words), expected, 1e-9)
          << "seed " << seed << ", " << words;
    }
  }
}

Mesh mesh_of(const std::vector<Polygon>& faces) {
  Mesh mesh;
  mesh.first_corner.push_back(0);
  for (const Polygon& face : faces) {
    for (const Point3& p : face) {
      mesh.corners.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
      mesh.vertices.push_back(p);
    }
    mesh.first_corner.push_back(mesh.corners.size());
  }
  mesh.objects.push_back({"", 0, mesh.faces()});
  return mesh;
}

TEST(PartedSides, BoundSolids) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Solids solids = any_solids(seed);
    EXPECT_TRUE(closed_and_consistently_oriented(mesh_of(solids.cut))) << "seed " << seed;
    std::ranges::reverse(solids.cut.back());
    EXPECT_FALSE(closed_and_consistently_oriented(mesh_of(solids.cut))) << "seed " << seed;
    solids.cut.pop_back();
    EXPECT_FALSE(closed_and_consistently_oriented(mesh_of(solids.cut))) << "seed " << seed;
  }
}

TEST(PartedSides, SectionsAreClosed) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Solids solids = any_solids(seed);
    Source s(seed);
    const Polygon& face = solids.clean.front();
    const Point3 through = (face[0] + face[2]) / 2.0, normal = test::any_direction(s);
    const SectionPlane plane{normal, glm::dot(normal, through)};
    const Section expected = section(mesh_of(solids.clean), plane);
    const Section found = section(mesh_of(solids.cut), plane);
    ASSERT_TRUE(expected.closed && found.closed) << "seed " << seed;
    EXPECT_NEAR(found.area, expected.area, 1e-9) << "seed " << seed;
  }
}

/// A polygon that is folded back on itself is a line, once.
TEST(PartedSides, OfOnePolygonAloneAreItsBoundary) {
  const std::vector<Polygon> line{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}};
  EXPECT_NEAR(lengths(line, "boundary", Eye::at({1, 2, 3}))[test::kBoundary], 2.0, 1e-12);
}

/// Two rectangles that meet at a right angle, one of them further along: each of the two sides is
/// in part a boundary and in part a crease, and no other side is divided.
TEST(PartedSides, ThatAreOfOneKindNowhereAreDrawnWhole) {
  const std::vector<Polygon> faces{{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}},
                                   {{3, 0, 0}, {1, 0, 0}, {1, 0, 1}, {3, 0, 1}}};
  const auto drawn = lengths(faces, "crease,boundary", Eye::at({5, 7, 9}));
  double length = 0.0, of_creases = 0.0;
  for (const auto& [kinds, of_kinds] : drawn) {
    length += of_kinds;
    if ((kinds & test::kCrease) != 0) of_creases += of_kinds;
  }
  EXPECT_NEAR(length, 12.0, 1e-12);
  EXPECT_NEAR(of_creases, 4.0, 1e-12);
}

/// A box whose top is three rectangles, as in some files.
TEST(PartedSides, OfABoxWithThreeRectanglesOnTopAreItsEdges) {
  std::vector<Polygon> faces{
      {{0, 0, 0}, {0, 2, 0}, {4, 2, 0}, {4, 0, 0}}, {{0, 0, 0}, {4, 0, 0}, {4, 0, 1}, {0, 0, 1}},
      {{4, 0, 0}, {4, 2, 0}, {4, 2, 1}, {4, 0, 1}}, {{4, 2, 0}, {0, 2, 0}, {0, 2, 1}, {4, 2, 1}},
      {{0, 2, 0}, {0, 0, 0}, {0, 0, 1}, {0, 2, 1}}, {{0, 1, 1}, {4, 1, 1}, {4, 2, 1}, {0, 2, 1}},
      {{0, 0, 1}, {2, 0, 1}, {2, 1, 1}, {0, 1, 1}}, {{2, 0, 1}, {4, 0, 1}, {4, 1, 1}, {2, 1, 1}}};
  const auto drawn = lengths(faces, "outline,crease,boundary", Eye::at({-5, -7, 9}));
  double length = 0.0;
  for (const auto& [kinds, of_kinds] : drawn) {
    length += of_kinds;
    EXPECT_EQ(kinds & test::kBoundary, 0);
  }
  EXPECT_NEAR(length, 4.0 * (4.0 + 2.0 + 1.0), 1e-12);
  EXPECT_TRUE(closed_and_consistently_oriented(mesh_of(faces)));
  const Section cut = section(mesh_of(faces), {{0, 1, 0}, 1.0});
  EXPECT_TRUE(cut.closed);
  EXPECT_NEAR(cut.area, 4.0, 1e-12);
}

}  // namespace
}  // namespace displayfile
