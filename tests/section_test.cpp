// Sections of meshes by planes, against rational arithmetic.

#include "displayfile/mesh/section.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>
#include <utility>

#include "clip/base/error.h"

namespace displayfile {
namespace {

Mesh mesh_of(std::vector<Point3> vertices, const std::vector<std::vector<std::uint32_t>>& faces) {
  Mesh mesh;
  mesh.vertices = std::move(vertices);
  mesh.first_corner.push_back(0);
  for (const auto& face : faces) {
    mesh.corners.insert(mesh.corners.end(), face.begin(), face.end());
    mesh.first_corner.push_back(mesh.corners.size());
  }
  mesh.objects.push_back({"", 0, mesh.faces()});
  return mesh;
}

Mesh unit_cube() {
  return mesh_of(
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
      {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}

/// A block 0 to 12, 0 to 6, 0 to 2 with two square holes through it. Its top and its bottom are
/// polygons with bridges, of which the one to the second hole runs across the first.
Mesh block_with_two_holes() {
  const Point2 corners[3][4] = {{{0, 0}, {12, 0}, {12, 6}, {0, 6}},
                                {{2, 1}, {5, 1}, {5, 4}, {2, 4}},
                                {{7, 3}, {10, 3}, {10, 5}, {7, 5}}};
  std::vector<Point3> vertices;
  for (const double z : {0.0, 2.0}) {
    for (const auto& loop : corners) {
      for (const Point2& p : loop) vertices.emplace_back(p, z);
    }
  }
  std::vector<std::vector<std::uint32_t>> faces{
      {12, 13, 14, 15, 12, 16, 19, 18, 17, 16, 12, 20, 23, 22, 21, 20},
      {0, 3, 2, 1, 0, 4, 5, 6, 7, 4, 0, 8, 9, 10, 11, 8}};
  for (std::uint32_t first : {0U, 4U, 8U}) {
    for (std::uint32_t k = 0; k < 4; ++k) {
      std::uint32_t from = first + k, to = first + (k + 1) % 4;
      if (first > 0) std::swap(from, to);
      faces.push_back({from, to, to + 12, from + 12});
    }
  }
  return mesh_of(vertices, faces);
}

/// A torus of triangles with a hole.
Mesh torus(int around, int across) {
  std::vector<Point3> vertices;
  std::vector<std::vector<std::uint32_t>> faces;
  for (int i = 0; i < around; ++i) {
    for (int k = 0; k < across; ++k) {
      const double u = 2 * M_PI * i / around, v = 2 * M_PI * k / across;
      const double r = 2.0 + 0.7 * std::cos(v);
      vertices.emplace_back(r * std::cos(u), r * std::sin(u), 0.7 * std::sin(v));
      const auto at = [&](int a, int b) {
        return static_cast<std::uint32_t>((a % around) * across + b % across);
      };
      faces.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      faces.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
  }
  return mesh_of(vertices, faces);
}

/// The area in the projection along an axis, a sum over triangles with no loops at all. A vertex
/// in the plane counts as before it.
mpq_class exact_projected_area(const Mesh& mesh, const SectionPlane& plane, std::size_t axis) {
  using Exact = std::array<mpq_class, 3>;
  const auto exact = [](const Point3& p) { return Exact{p.x, p.y, p.z}; };
  const auto value = [&](const Exact& p) {
    return mpq_class(plane.normal.x * p[0] + plane.normal.y * p[1] + plane.normal.z * p[2] -
                     plane.distance);
  };
  const std::size_t x = (axis + 1) % 3, y = (axis + 2) % 3;
  mpq_class sum = 0;
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 2; k < face.size(); ++k) {
      const std::array t{exact(mesh.vertices[face[0]]), exact(mesh.vertices[face[k - 1]]),
                         exact(mesh.vertices[face[k]])};
      Exact up, down;
      bool is_cut = false;
      for (std::size_t i = 0; i < 3; ++i) {
        const Exact &a = t[i], &b = t[(i + 1) % 3];
        const mpq_class va = value(a), vb = value(b);
        if ((va >= 0) == (vb >= 0)) continue;
        is_cut = true;
        Exact& p = vb >= 0 ? up : down;
        for (std::size_t c = 0; c < 3; ++c) p[c] = (a[c] * vb - b[c] * va) / (vb - va);
      }
      if (is_cut) sum += (down[x] * up[y] - up[x] * down[y]) * (-1);
    }
  }
  return sum / -2;
}

void expect_exact_area(const Mesh& mesh, const SectionPlane& plane) {
  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::abs(plane.normal[k]) > std::abs(plane.normal[axis])) axis = k;
  }
  const mpq_class exact = exact_projected_area(mesh, plane, static_cast<std::size_t>(axis));
  const double expected = exact.get_d() * (glm::length(plane.normal) / plane.normal[axis]);
  const Section cut = section(mesh, plane);
  EXPECT_TRUE(cut.closed);
  // Vertices within reach of the plane lie in it: less than that, times what is around the area.
  const double kWithinReach = 1e-14;
  EXPECT_NEAR(std::abs(cut.area), std::abs(expected), 1e-12 * std::abs(expected) + kWithinReach);
  EXPECT_GE(cut.area, 0.0);
}

TEST(Section, CutsACubeInASquare) {
  const Section cut = section(unit_cube(), {{0, 0, 1}, 0.25});
  ASSERT_EQ(cut.loops.size(), 1U);
  EXPECT_EQ(cut.area, 1.0);
  for (const Point3& p : cut.loops[0]) EXPECT_EQ(p.z, 0.25);
  for (const Point3& p : cut.behind.vertices) EXPECT_TRUE(p.z <= 0.25 || p.z == 1.0);
}

TEST(Section, AFaceInThePlaneIsCutWhereThereIsSolidBehindIt) {
  EXPECT_EQ(section(unit_cube(), {{0, 0, 1}, 1.0}).area, 1.0);
  EXPECT_EQ(section(unit_cube(), {{0, 0, 1}, 0.0}).area, 0.0);
  EXPECT_TRUE(section(unit_cube(), {{0, 0, 1}, 0.0}).loops.empty());
  EXPECT_EQ(section(unit_cube(), {{0, 0, -1}, 0.0}).area, 1.0);
}

/// The part behind a plane with its loops as faces.
Mesh closed_by_loops(const Section& cut) {
  Mesh closed = cut.behind;
  for (const auto& loop : cut.loops) {
    const auto first = static_cast<std::uint32_t>(closed.vertices.size());
    closed.vertices.insert(closed.vertices.end(), loop.begin(), loop.end());
    for (std::uint32_t k = 0; k < loop.size(); ++k) closed.corners.push_back(first + k);
    closed.first_corner.push_back(closed.corners.size());
  }
  closed.objects = {{"", 0, closed.faces()}};
  return closed;
}

TEST(Section, WhatIsBehindIsClosedByTheLoopsBitForBit) {
  const Section cut = section(torus(24, 12), {{0.3, -0.5, 0.8}, 0.1});
  EXPECT_TRUE(closed_and_consistently_oriented(closed_by_loops(cut)));
}

/// The area of a mesh's faces at that height, each for itself.
double area_at(const Mesh& mesh, double z) {
  double sum = 0.0;
  for (std::size_t i = 0; i < mesh.faces(); ++i) {
    double twice = 0.0;
    Point3 from = mesh.vertices[mesh.face(i).back()];
    bool is_level = true;
    for (const std::uint32_t v : mesh.face(i)) {
      const Point3& to = mesh.vertices[v];
      is_level = is_level && to.z == z;
      twice += from.x * to.y - to.x * from.y;
      from = to;
    }
    if (is_level) sum += std::abs(twice) / 2.0;
  }
  return sum;
}

/// Triangles of a polygon whose bridges cross its holes would cover these.
TEST(Section, AFaceWithHolesIsCutWhole) {
  for (const double y : {0.5, 2.0, 3.5, 4.5, 5.5}) {
    const Section cut = section(block_with_two_holes(), {{0, 1, 0}, y});
    const double holes = 3.0 * std::clamp(y - 1.0, 0.0, 3.0) + 3.0 * std::clamp(y - 3.0, 0.0, 2.0);
    EXPECT_NEAR(area_at(cut.behind, 2.0), 12.0 * y - holes, 1e-13) << y;
    EXPECT_NEAR(area_at(cut.behind, 0.0), 12.0 * y - holes, 1e-13) << y;
    EXPECT_TRUE(closed_and_consistently_oriented(closed_by_loops(cut))) << y;
  }
}

TEST(Section, LoopsOfAFaceWithHolesAreThoseOfTheSolid) {
  const Section cut = section(block_with_two_holes(), {{0, 1, 0}, 3.5});
  ASSERT_EQ(cut.loops.size(), 3U);
  std::vector<std::pair<double, double>> extents;
  for (const auto& loop : cut.loops) {
    const auto [low, high] = std::ranges::minmax(loop, {}, [](const Point3& p) { return p.x; });
    extents.emplace_back(low.x, high.x);
  }
  std::ranges::sort(extents);
  const std::vector<std::pair<double, double>> expected{{0, 2}, {5, 7}, {10, 12}};
  EXPECT_EQ(extents, expected);
}

/// A prism of three sides on a plate: the plane cuts the plate, and touches the prism in an edge.
TEST(Section, AnEdgeThatThePlaneTouchesIsInNoLoop) {
  const Mesh mesh = mesh_of({{0, 0, 0},
                             {4, 0, 0},
                             {4, 2, 0},
                             {0, 2, 0},
                             {0, 0, 1},
                             {4, 0, 1},
                             {4, 2, 1},
                             {0, 2, 1},
                             {2, 1, 1},
                             {1, 0.5, 1},
                             {3, 0.5, 1},
                             {2, 1, 2},
                             {1, 0.5, 2},
                             {3, 0.5, 2}},
                            {{0, 3, 2, 1},
                             {0, 1, 5, 4},
                             {1, 2, 6, 5},
                             {2, 3, 7, 6},
                             {3, 0, 4, 7},
                             {4, 5, 6, 7, 4, 9, 8, 10, 9},
                             {8, 9, 12, 11},
                             {9, 10, 13, 12},
                             {10, 8, 11, 13},
                             {11, 12, 13}});
  ASSERT_TRUE(closed_and_consistently_oriented(mesh));
  const Section cut = section(mesh, {{0, 1, 0}, 1.0});
  ASSERT_EQ(cut.loops.size(), 1U);
  for (const Point3& p : cut.loops[0]) EXPECT_LE(p.z, 1.0);
  EXPECT_EQ(cut.area, 4.0);
}

/// Two cubes, one on the other: the square between them is in the loops of both.
TEST(Section, ObjectsThatTouchHaveLoopsOfTheirOwn) {
  Mesh stack = unit_cube();
  const Mesh above = unit_cube();
  for (const Point3& p : above.vertices) stack.vertices.push_back(p + Point3(0, 0, 1));
  for (const std::uint32_t corner : above.corners) stack.corners.push_back(corner + 8);
  for (std::size_t i = 1; i <= 6; ++i) stack.first_corner.push_back(24 + 4 * i);
  stack.objects = {{"", 0, 6}, {"", 6, 6}};
  const Section cut = section(stack, {{0, 1, 0}, 0.5});
  EXPECT_TRUE(cut.closed);
  ASSERT_EQ(cut.loops.size(), 2U);
  EXPECT_EQ(cut.loops[0].size(), 4U);
  EXPECT_EQ(cut.loops[1].size(), 4U);
  EXPECT_EQ(cut.area, 2.0);
}

/// The even-odd area of a polygon in a plane of equal z that has no sides across each other.
double area_of(const std::vector<Point3>& polygon) {
  double twice = 0.0;
  Point3 from = polygon.back();
  for (const Point3& to : polygon) {
    twice += from.x * to.y - to.x * from.y;
    from = to;
  }
  return std::abs(twice) / 2.0;
}

Mesh boxes(const std::vector<std::array<Point3, 2>>& corners) {
  Mesh all;
  all.first_corner.push_back(0);
  for (const auto& [low, high] : corners) {
    const Mesh cube = unit_cube();
    const auto first = static_cast<std::uint32_t>(all.vertices.size());
    for (const Point3& p : cube.vertices) all.vertices.push_back(low + p * (high - low));
    all.objects.push_back({"", all.faces(), cube.faces()});
    for (const std::uint32_t corner : cube.corners) all.corners.push_back(first + corner);
    for (int i = 0; i < 6; ++i) all.first_corner.push_back(all.first_corner.back() + 4);
  }
  return all;
}

TEST(Section, WhatIsBehindHasTheObjectsOfTheMesh) {
  const Mesh mesh = boxes({{Point3(0), Point3(2)}, {Point3(3), Point3(4)}, {Point3(1), Point3(3)}});
  const Section cut = section(mesh, {{0, 0, 1}, 1.5});
  ASSERT_EQ(cut.behind.objects.size(), 3U);
  EXPECT_EQ(cut.behind.objects[0].faces, 5U);
  EXPECT_EQ(cut.behind.objects[1].faces, 0U);
  EXPECT_EQ(cut.behind.objects[2].faces, 5U);
  EXPECT_EQ(cut.behind.objects[2].first_face, 5U);
}

/// True if a point is on the line from one to the other.
bool is_between(const Point3& p, const Point3& from, const Point3& to) {
  return glm::length(p - from) + glm::length(to - p) < glm::length(to - from) + 1e-12;
}

/// The total lengths of the sides of faces behind that run along the plane, and of those of no
/// side.
struct LengthsOfSides {
  double in_plane = 0.0, none = 0.0;
};
LengthsOfSides expect_sides_of(const Mesh& mesh, const Section& cut) {
  LengthsOfSides lengths;
  EXPECT_EQ(cut.side_of.size(), cut.behind.corners.size());
  EXPECT_EQ(cut.face_of.size(), cut.behind.faces());
  for (std::size_t i = 0; i < cut.behind.faces(); ++i) {
    const auto face = cut.behind.face(i);
    const auto whole = mesh.face(cut.face_of[i]);
    Point3 from = cut.behind.vertices[face.back()];
    for (std::size_t k = 0; k < face.size(); ++k) {
      const Point3 to = cut.behind.vertices[face[k]];
      const std::size_t side = cut.side_of[cut.behind.first_corner[i] + k];
      if (side == Section::kInPlane) {
        lengths.in_plane += glm::length(to - from);
      } else if (side == Section::kNoSide) {
        lengths.none += glm::length(to - from);
      } else {
        const std::size_t of_face = side - mesh.first_corner[cut.face_of[i]];
        EXPECT_LT(of_face, whole.size());
        const Point3& end = mesh.vertices[whole[of_face]];
        const Point3& begin = mesh.vertices[whole[(of_face + whole.size() - 1) % whole.size()]];
        EXPECT_TRUE(is_between(from, begin, end) && is_between(to, begin, end));
      }
      from = to;
    }
  }
  return lengths;
}

TEST(Section, SidesBehindAreThoseOfTheMeshAndThoseAlongThePlane) {
  const Mesh mesh = block_with_two_holes();
  for (const double y : {0.5, 2.0, 3.5, 4.5, 5.5}) {
    const Section cut = section(mesh, {{0, 1, 0}, y});
    double around = 0.0;
    for (const auto& loop : cut.loops) {
      Point3 from = loop.back();
      for (const Point3& to : loop) around += glm::length(std::exchange(from, to) - to);
    }
    EXPECT_NEAR(expect_sides_of(mesh, cut).in_plane, around, 1e-12) << y;
  }
  const Mesh comb = mesh_of({{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {2, 2, 0}, {1, 1, 0}, {0, 2, 0}},
                            {{0, 1, 2, 3, 4, 5}});
  const LengthsOfSides teeth = expect_sides_of(comb, section(comb, {{0, -1, 0}, -1.5}));
  EXPECT_NEAR(teeth.in_plane, 0.5 + 1.5, 1e-12);
  EXPECT_NEAR(teeth.none, 2.0 * 2.5, 1e-12);  // from tooth to tooth and back
  const Mesh bent = mesh_of({{0, 0, 0}, {4, 0, 0}, {4, 4, 1}, {0, 4, 0}}, {{0, 1, 2, 3}});
  EXPECT_GT(expect_sides_of(bent, section(bent, {{0, 1, 0}, 3.0})).none, 1.0);
}

/// A hollow box, another that overlaps it, and one in the hollow; low above high is inside out.
TEST(Section, CapsAreLoopsWithTheirHoles) {
  const Mesh mesh = boxes({{Point3(0), Point3(10)},
                           {Point3(8, 8, 8), Point3(2, 2, 2)},
                           {Point3(9, 0, 0), Point3(14, 10, 10)},
                           {Point3(4), Point3(6)}});
  for (const double up : {1.0, -1.0}) {
    const SectionPlane plane{{0, 0, up}, 5.0 * up};
    const Section cut = section(mesh, plane);
    std::vector<double> areas;
    for (const auto& polygon : cap_polygons(cut, plane)) areas.push_back(area_of(polygon));
    EXPECT_EQ(areas, (std::vector<double>{100.0 - 36.0, 50.0, 4.0}));
  }
}

/// Areas of caps, once the bodies are turned.
std::vector<double> areas_of_caps(const Mesh& mesh) {
  std::vector<double> areas;
  for (const double up : {1.0, -1.0}) {
    const SectionPlane plane{{0, 0, up}, 5.0 * up};
    Section cut = section(mesh, plane);
    turn_bodies_out(cut, plane);
    for (const auto& polygon : cap_polygons(cut, plane)) areas.push_back(area_of(polygon));
  }
  return areas;
}

TEST(Section, WhatLiesInNoOtherBodyIsSolidWhicheverWayItIsTurned) {
  using Areas = std::vector<double>;
  EXPECT_EQ(areas_of_caps(boxes({{Point3(10), Point3(0)}, {Point3(2), Point3(8)}})),
            (Areas{64.0, 64.0}));  // a hollow box inside out
  EXPECT_EQ(areas_of_caps(boxes({{Point3(0), Point3(10)}, {Point3(12), Point3(4)}})),
            (Areas{100.0, 64.0, 100.0, 64.0}));  // two boxes, one inside out, overlap
  EXPECT_EQ(areas_of_caps(boxes({{Point3(0), Point3(10)},
                                 {Point3(8), Point3(2)},
                                 {Point3(19, 10, 10), Point3(9, 0, 0)},
                                 {Point3(11, 2, 2), Point3(17, 8, 8)}})),
            (Areas{64.0, 64.0, 64.0, 64.0}));  // two hollow ones
}

TEST(Section, AreasAreThoseOfRationalArithmetic) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> in(-1.0, 1.0);
  const Mesh meshes[] = {unit_cube(), torus(24, 12), block_with_two_holes()};
  for (const Mesh& mesh : meshes) {
    for (int k = 0; k < 50; ++k) {
      Point3 normal(in(random), in(random), in(random));
      if (k % 5 == 0) normal = Point3(k % 3 == 0, k % 3 == 1, k % 3 == 2);
      const Point3& vertex = mesh.vertices[random() % mesh.vertices.size()];
      const double through = glm::dot(normal, vertex);  // a vertex: exactly if along an axis
      const SectionPlane plane{normal, k % 2 == 0 ? through : 0.7 * through};
      expect_exact_area(mesh, plane);
    }
  }
}

TEST(Section, AnOpenMeshHasNoLoops) {
  Mesh open = unit_cube();
  open.corners.resize(20);
  open.first_corner.resize(6);
  open.objects[0].faces = 5;
  const Section cut = section(open, {{0, 0, 1}, 0.5});
  EXPECT_FALSE(cut.closed);
  EXPECT_TRUE(cut.loops.empty());
  EXPECT_GT(cut.behind.faces(), 0U);
}

TEST(Section, RefusesPlanesThatAreNone) {
  EXPECT_THROW(section(unit_cube(), {{0, 0, 0}, 1.0}), Error);
  EXPECT_THROW(section(unit_cube(), {{0, 0, std::nan("")}, 1.0}), Error);
  EXPECT_THROW(section(unit_cube(), {{0, 0, 1}, std::numeric_limits<double>::infinity()}), Error);
}

}  // namespace
}  // namespace displayfile
