// Cuts exactly in the plane of faces: what is kept is whole, and nothing is left of what is cut
// away, also of coordinates that were rounded.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "clip/geometry/back_face.h"
#include "clip/surfaces.h"
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/mesh/section.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/retained_scene.h"
#include "tests/solid_scenes.h"

namespace displayfile {
namespace {

using test::is_closed;
using test::volume;

using Kind = CutFaces::Kind;

/// A step from z = 0 to 2, 1 deep: below z = 1 from x = 0 to 2, above it to 1.
const std::vector<Point2> kStep{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

/// How the step is placed and rounded.
struct Placed {
  glm::dmat3 turn{1.0};
  Point3 offset{0.0};
  bool single = false;

  Point3 operator()(const Point3& p) const {
    const Point3 at = turn * p + offset;
    if (!single) return at;
    return {static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z)};
  }
};

glm::dmat3 turned(double a, double b) {
  const glm::dmat3 about_z(std::cos(a), std::sin(a), 0, -std::sin(a), std::cos(a), 0, 0, 0, 1);
  const glm::dmat3 about_x(1, 0, 0, 0, std::cos(b), std::sin(b), 0, -std::sin(b), std::cos(b));
  return about_x * about_z;
}

std::vector<Placed> places() {
  return {{},
          {turned(0.5, 0.7), {10, -7, 3}, false},
          {turned(0.5, 0.7), {10, -7, 3}, true},
          {turned(-1.1, 2.3), {0.1, 0.2, 0.3}, true},
          {turned(0.3, 0.0), {200, 0, 1.0 / 3.0}, true}};
}

/// The step as triangles.
Mesh step(const Placed& placed) {
  Mesh mesh;
  for (const double y : {0.0, 1.0}) {
    for (const Point2& p : kStep) mesh.vertices.push_back(placed({p.x, y, p.y}));
  }
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.first_corner.push_back(mesh.corners.size());
    mesh.corners.insert(mesh.corners.end(), {a, b, c});
  };
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t j = (i + 1) % 6;
    add(i, j + 6, j);
    add(i, i + 6, j + 6);
  }
  for (const std::uint32_t i : {1u, 2u, 3u, 4u}) {
    add(0, i, i + 1);
    add(6, i + 7, i + 6);
  }
  mesh.first_corner.push_back(mesh.corners.size());
  mesh.objects = {{"", 0, mesh.faces()}};
  if (placed.single) {
    double largest = 0.0;
    for (const Point3& p : mesh.vertices) {
      for (int k = 0; k < 3; ++k) largest = std::max(largest, std::abs(p[k]));
    }
    mesh.set_reach(entered_reach(kUnlessSet, largest, kUnitOfSingles));
  }
  return mesh;
}

/// Sets the plane at z = `level` of the step as placed; `kept` is 1 above it, -1 below it.
void cut_at(GraphicsSystem& g, const Placed& placed, double level, int kept) {
  const Point3 normal = static_cast<double>(kept) * (placed.turn * Point3(0, 0, 1));
  const Point3 at = placed.turn * Point3(0, 0, level) + placed.offset;
  g.set_cutting_plane(1, normal.x, normal.y, normal.z, -glm::dot(normal, at));
}

/// The polygons that were entered.
Mesh entered(const RetainedScene& scene) {
  Mesh mesh;
  mesh.first_corner.push_back(0);
  for (std::uint32_t i = 0; i < scene.size(); ++i) {
    if (scene[i].is_line()) continue;
    for (const Point3& p : scene.points(i)) {
      mesh.corners.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
      mesh.vertices.push_back(p);
    }
    mesh.first_corner.push_back(mesh.corners.size());
  }
  return mesh;
}

std::vector<double> areas(const Mesh& mesh) {
  std::vector<double> all;
  for (std::size_t i = 0; i < mesh.faces(); ++i) {
    std::vector<Point3> face;
    for (const std::uint32_t corner : mesh.face(i)) face.push_back(mesh.vertices[corner]);
    all.push_back(0.5 * glm::length(newell_normal(face)));
  }
  return all;
}

double sum(const std::vector<double>& all) {
  double total = 0.0;
  for (const double one : all) total += one;
  return total;
}

struct Expected {
  double level;
  int kept;
  double volume, closed_area, open_area, cut_area;
};
constexpr Expected kExpected[] = {{0, 1, 3, 14, 14, 2}, {1, 1, 1, 6, 5, 1},
                                  {2, 1, 0, 0, 0, 0},   {0, -1, 0, 0, 0, 0},
                                  {1, -1, 2, 10, 9, 2}, {2, -1, 3, 14, 14, 1}};

constexpr double kNear = 1e-4;

/// Expects of the step, entered by `enter`, the parts that are kept, whole, and nothing else.
template <class Enter>
void expect_no_rags(const Placed& placed, const Enter& enter, const std::string& what) {
  for (const Expected& expected : kExpected) {
    for (const Kind kind : {Kind::open, Kind::closed, Kind::hatched}) {
      RetainedScene scene;
      GraphicsSystem g;
      g.retain(&scene);
      cut_at(g, placed, expected.level, expected.kept);
      g.set_cut_faces({kind, 0.01});
      enter(g);
      const Mesh left = entered(scene);
      const std::vector<double> of_faces = areas(left);
      const std::string at = what + " at " + std::to_string(expected.level) + " kept " +
                             std::to_string(expected.kept) + " " + std::string(name_of(kind));
      for (const double area : of_faces) EXPECT_GT(area, 0.1) << at;
      EXPECT_NEAR(sum(of_faces), kind == Kind::open ? expected.open_area : expected.closed_area,
                  kNear)
          << at;
      if (kind == Kind::open) continue;
      EXPECT_TRUE(is_closed(left)) << at;
      EXPECT_NEAR(left.faces() == 0 ? 0.0 : volume(left), expected.volume, kNear) << at;
      double hatched = 0.0;
      for (std::uint32_t i = 0; i < scene.size(); ++i) {
        if (scene[i].is_line()) hatched += glm::distance(scene.points(i)[0], scene.points(i)[1]);
      }
      EXPECT_NEAR(0.01 * hatched, kind == Kind::hatched ? expected.cut_area : 0.0, 0.03) << at;
    }
  }
}

TEST(FlushCuts, OfMeshesLeaveNoRags) {
  for (const Placed& placed : places()) {
    const Mesh mesh = step(placed);
    expect_no_rags(
        placed, [&](GraphicsSystem& g) { enter_mesh(mesh, g, 1); }, "mesh");
  }
}

TEST(FlushCuts, OfMeshesWithNormalsLeaveNoRags) {
  for (const Placed& placed : places()) {
    Mesh mesh = step(placed);
    complete_normals(mesh, 20);
    ASSERT_FALSE(mesh.corner_normals.empty());
    expect_no_rags(
        placed, [&](GraphicsSystem& g) { enter_mesh(mesh, g, 1); }, "mesh with normals");
  }
}

/// A cut in the plane of a face, of shapes and of solids, turned as the place is.
TEST(FlushCuts, OfShapesLeaveNoRags) {
  const auto enter = [](GraphicsSystem& g, bool combined) {
    g.rotate_x_3(-90);
    g.rotate_z_3(33);
    g.rotate_x_3(21);
    g.translate_3(3, -2, 1);
    g.open_segment(1);
    if (combined) g.begin_solid();
    extrude_3(g, -1, 0, kStep);
    if (combined) g.end_solid();
    g.close_segment();
  };
  // Where its points are: extruded along z, turned so that y is up.
  GraphicsSystem turning;
  turning.rotate_x_3(-90);
  turning.rotate_z_3(33);
  turning.rotate_x_3(21);
  turning.translate_3(3, -2, 1);
  const ModellingTransformation& modelling = turning.modelling_transformation();
  Placed placed;
  placed.offset = modelling.apply({0, 0, 0});
  placed.turn[2] = modelling.apply({0, 1, 0}) - placed.offset;
  for (const bool combined : {false, true}) {
    expect_no_rags(
        placed, [&](GraphicsSystem& g) { enter(g, combined); }, combined ? "solid" : "shape");
  }
}

/// Single polygons and open surfaces have no solid behind them: they stay.
TEST(FlushCuts, PolygonsInThePlaneStay) {
  const std::vector<Point3> up{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}}, down{up.rbegin(), up.rend()};
  for (const int kept : {1, -1}) {
    for (const auto& polygon : {up, down}) {
      RetainedScene scene;
      GraphicsSystem g;
      g.retain(&scene);
      g.set_cutting_plane(1, 0, 0, kept, -kept);
      g.open_segment(1);
      g.polygon_abs_3(polygon);
      g.polygons_abs_3({polygon, std::vector<std::uint32_t>{0, 1, 2}});
      g.close_segment();
      EXPECT_EQ(scene.size(), 2u) << kept;
    }
  }
}

/// The area of what a cut leaves of a mesh, with open faces.
double area_left(const Mesh& mesh, const Expected& expected, bool mirrored) {
  RetainedScene scene;
  GraphicsSystem g;
  g.retain(&scene);
  cut_at(g, {}, expected.level, expected.kept);
  if (mirrored) g.scale_3(-1, 1, 1);
  enter_mesh(mesh, g, 1);
  return sum(areas(entered(scene)));
}

/// A mesh that is inside out is solid, too.
TEST(FlushCuts, OfMeshesInsideOutLeaveNoRags) {
  for (const bool with_normals : {false, true}) {
    Mesh mesh = step({});
    for (std::size_t i = 0; i < mesh.corners.size(); i += 3) {
      std::swap(mesh.corners[i + 1], mesh.corners[i + 2]);
    }
    if (with_normals) complete_normals(mesh, 20);
    for (const Expected& expected : kExpected) {
      EXPECT_NEAR(area_left(mesh, expected, false), expected.open_area, kNear);
    }
  }
}

/// Under a modelling transformation that mirrors, and where normals are entered.
TEST(FlushCuts, OfMirroredMeshesLeaveNoRags) {
  for (const bool with_normals : {false, true}) {
    Mesh mesh = step({});
    if (with_normals) complete_normals(mesh, 20);
    for (const Expected& expected : kExpected) {
      EXPECT_NEAR(area_left(mesh, expected, true), expected.open_area, kNear);
    }
  }
}

TEST(FlushCuts, RecordedAndReplayedTheyAreTheSame) {
  const Mesh mesh = step({turned(0.5, 0.7), {}, true});
  for (const Expected& expected : kExpected) {
    std::ostringstream program;
    Recorder recorder(program);
    GraphicsSystem g;
    g.set_recorder(&recorder);
    cut_at(g, {turned(0.5, 0.7), {}, true}, expected.level, expected.kept);
    enter_mesh(mesh, g, 1);
    g.set_cutting_plane(1, 0, 0, expected.kept, -expected.kept * expected.level);
    g.open_segment(2);
    extrude_3(g, expected.level, 3, kStep);
    g.polygon_abs_3({{0, 0, expected.level}, {0, 1, expected.level}, {1, 0, expected.level}});
    g.close_segment();
    GraphicsSystem again;
    replay(program.str(), "recorded", again);
    EXPECT_EQ(dump(again.display_file()), dump(g.display_file())) << expected.level;
    // As without a recorder.
    GraphicsSystem alone;
    cut_at(alone, {turned(0.5, 0.7), {}, true}, expected.level, expected.kept);
    enter_mesh(mesh, alone, 1);
    EXPECT_EQ(alone.display_file().segment(1).polygons(), g.display_file().segment(1).polygons());
  }
}

TEST(FlushCuts, WithTouchingOffThePlaneIsExact) {
  const Mesh mesh = step({turned(0.5, 0.7), {10, -7, 3}, true});
  RetainedScene scene;
  GraphicsSystem g;
  g.retain(&scene);
  g.set_hidden_surfaces({.touching = touching("off")});
  cut_at(g, {turned(0.5, 0.7), {10, -7, 3}, true}, 2.0, 1);
  g.set_cut_faces({Kind::closed});
  enter_mesh(mesh, g, 1);
  EXPECT_GT(scene.size(), 0u);  // a sliver
}

TEST(FlushCuts, OfSectionsLeaveNoRags) {
  for (const Placed& placed : places()) {
    const Mesh mesh = step(placed);
    for (const Expected& expected : kExpected) {
      // The part behind a section is kept, against its normal.
      const Point3 normal = static_cast<double>(-expected.kept) * (placed.turn * Point3(0, 0, 1));
      const Point3 at = placed.turn * Point3(0, 0, expected.level) + placed.offset;
      const Section cut = section(mesh, {normal, glm::dot(normal, at)});
      EXPECT_TRUE(cut.closed);
      EXPECT_NEAR(cut.area, expected.cut_area, kNear) << expected.level << " " << expected.kept;
      EXPECT_EQ(cut.loops.size(), expected.cut_area > 0.0 ? 1u : 0u);
      const std::vector<double> of_faces = areas(cut.behind);
      for (const double area : of_faces) EXPECT_GT(area, 0.1);
      EXPECT_NEAR(sum(of_faces) + cut.area, expected.closed_area, kNear)
          << expected.level << " " << expected.kept;
    }
  }
}

}  // namespace
}  // namespace displayfile
