// The guarantees of a crease angle: facets that meet at more keep their own normals, facets that
// meet at less share the mean, at every vertex for each group that is connected by such sides;
// however the facets run, are rounded, or end on each other's sides.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "clip/geometry/back_face.h"
#include "clip/geometry/unit.h"
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/user_routines/system_inside.h"
#include "tests/error_of.h"
#include "tests/temporary_folder.h"

namespace displayfile {
namespace {

using test::error_of;
using Faces = std::vector<std::vector<Point3>>;

/// Faces of which each has vertices of its own, as in STL.
Mesh mesh_of(const Faces& faces) {
  Mesh mesh;
  mesh.first_corner.push_back(0);
  for (const auto& face : faces) {
    for (const Point3& p : face) {
      mesh.corners.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
      mesh.vertices.push_back(p);
    }
    mesh.first_corner.push_back(mesh.corners.size());
  }
  mesh.objects.push_back({"", 0, faces.size()});
  return mesh;
}

Point3 own_normal(const std::vector<Point3>& face) { return unit(newell_normal(face)); }

/// Returns a normal of length 1 for each corner: the face's own where the corner has none.
std::vector<std::vector<Point3>> normals(const Faces& faces, double degrees, double reach = 0.0) {
  Mesh mesh = mesh_of(faces);
  if (reach > 0.0) mesh.set_reach(reach);
  complete_normals(mesh, degrees);
  std::vector<std::vector<Point3>> of_faces;
  for (std::size_t i = 0, k = 0; i < faces.size(); ++i) {
    auto& of_face = of_faces.emplace_back();
    for (std::size_t c = 0; c < faces[i].size(); ++c, ++k) {
      const Point3 n = mesh.normal(k);
      of_face.push_back(n == Point3(0.0) ? own_normal(faces[i]) : unit(n));
    }
  }
  return of_faces;
}

void expect_near(const Point3& found, const Point3& expected) {
  EXPECT_LT(glm::distance(found, expected), 1e-9)
      << found.x << ' ' << found.y << ' ' << found.z << ", expected " << expected.x << ' '
      << expected.y << ' ' << expected.z;
}

Point3 on_circle(double share, double z) {
  const double angle = 2.0 * std::numbers::pi * share;
  return {std::cos(angle), std::sin(angle), z};
}

/// A prism's sides, and its two ends after them.
Faces prism(int sides) {
  Faces faces;
  std::vector<Point3> top, bottom;
  for (int i = 0; i < sides; ++i) {
    const double a = static_cast<double>(i) / sides, b = (i + 1.0) / sides;
    faces.push_back({on_circle(a, 0), on_circle(b, 0), on_circle(b, 1), on_circle(a, 1)});
    top.push_back(on_circle(a, 1));
    bottom.insert(bottom.begin(), on_circle(a, 0));
  }
  faces.push_back(top);
  faces.push_back(bottom);
  return faces;
}

Point3 radial(const Point3& p) { return unit(Point3(p.x, p.y, 0.0)); }

TEST(CreaseAngle, ABoltHasSharpEdgesAndACylinderIsRound) {
  for (const int sides : {6, 24}) {
    const Faces faces = prism(sides);
    const auto found = normals(faces, 30.0);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      for (std::size_t k = 0; k < faces[i].size(); ++k) {
        const bool is_round = sides == 24 && i < 24;
        expect_near(found[i][k], is_round ? radial(faces[i][k]) : own_normal(faces[i]));
      }
    }
  }
}

TEST(CreaseAngle, FacetsThatMeetAtTheAngleItselfAreSmooth) {
  const Faces box = prism(4);
  expect_near(normals(box, 90.0)[0][0], unit(on_circle(0, 0) - Point3(0, 0, std::sqrt(0.5))));
  expect_near(normals(box, 89.999)[0][0], own_normal(box[0]));
  const Faces hexagon = prism(6);
  expect_near(normals(hexagon, 60.001)[2][3], radial(hexagon[2][3]));
  expect_near(normals(hexagon, 59.999)[2][3], own_normal(hexagon[2]));
}

/// Then a flat polygon stays whole, with one tone.
TEST(CreaseAngle, AFacetsOwnNormalIsLeftToItToTheBit) {
  Faces faces = prism(4);
  const Faces ends{faces[4], faces[5]};
  for (const auto& end : ends) faces.push_back({end[0], end[1], end[2]});
  for (const auto& end : ends) faces.push_back({end[2], end[3], end[0]});
  faces.erase(faces.begin() + 4, faces.begin() + 6);
  for (const double degrees : {0.0, 30.0}) {
    Mesh mesh = mesh_of(faces);
    complete_normals(mesh, degrees);
    for (std::size_t k = 0; k < mesh.corners.size(); ++k) {
      EXPECT_EQ(mesh.normal(k), Point3(0.0)) << degrees;
    }
  }
}

TEST(CreaseAngle, WithoutOneAllFacesAroundAVertexCount) {
  const Faces faces = prism(6);
  Mesh unset = mesh_of(faces), none = mesh_of(faces);
  complete_normals(unset);
  complete_normals(none, 180.0);
  EXPECT_EQ(unset.normals, none.normals);
  EXPECT_EQ(unset.corner_normals, none.corner_normals);
  EXPECT_LT(glm::dot(normals(faces, 180.0)[0][0], own_normal(faces[0])), 0.8);
}

TEST(CreaseAngle, FacesThatRunTheOtherWayAreTurnedForTheMean) {
  const Faces faces = prism(24);
  Faces turned = faces;
  for (std::size_t i = 0; i < turned.size(); i += 3) {
    std::ranges::reverse(turned[i]);
  }
  const auto found = normals(turned, 30.0);
  for (std::size_t i = 0; i < 24; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      expect_near(found[i][k], (i % 3 == 0 ? -1.0 : 1.0) * radial(turned[i][k]));
    }
  }
}

/// A long facet beside two short ones, whose common corner ends on its side: it is a neighbour
/// there.
TEST(CreaseAngle, VerticesAlongSidesPartThem) {
  const Point3 tilt(0.0, 1.0, 0.2);  // of the short ones, across the common side
  for (const double off : {0.0, 1e-7}) {
    const Point3 middle(1.0, off, -off);
    const Faces faces{{{0, 0, 0}, {0, -1, 0}, {2, -1, 0}, {2, 0, 0}},
                      {{0, 0, 0}, middle, middle + tilt, tilt},
                      {middle, {2, 0, 0}, Point3(2, 0, 0) + tilt, middle + tilt}};
    const auto found = normals(faces, 30.0, 1e-6);
    const Point3 level(0, 0, 1), tilted = unit(Point3(0, -0.2, 1));
    const Point3 mean = unit(level + tilted);  // half a turn of each
    EXPECT_LT(glm::distance(found[1][1], mean), 1e-6);
    EXPECT_LT(glm::distance(found[2][0], mean), 1e-6);
    EXPECT_LT(glm::distance(found[1][2], tilted), 1e-6);
    EXPECT_LT(glm::distance(normals(faces, 5.0, 1e-6)[1][1], tilted), 1e-6);
  }
}

/// A seam that a Boolean leaves: its two long sides are a crease and must stay one.
TEST(CreaseAngle, NeedlesJoinNothing) {
  const Point3 middle(1.0, 1e-8, -1e-8);  // half way between the two sides
  const Faces faces{{{0, 0, 0}, {0, -1, 0}, {2, -1, 0}, {2, 0, 0}},
                    {{0, 0, 0}, {2, 0, 0}, middle},
                    {{0, 0, 0}, middle, {1, 0, -1}, {0, 0, -1}},
                    {middle, {2, 0, 0}, {2, 0, -1}, {1, 0, -1}}};
  const auto found = normals(faces, 50.0, 1e-6);
  for (const std::size_t i : {0u, 2u, 3u}) {
    for (const Point3& n : found[i]) EXPECT_LT(glm::distance(n, own_normal(faces[i])), 1e-6);
  }
  // And they hide no smooth side.
  Faces level = faces;
  level[2] = {{0, 0, 0}, middle, {1, 1, 0.2}, {0, 1, 0.2}};
  level[3] = {middle, {2, 0, 0}, {2, 1, 0.2}, {1, 1, 0.2}};
  const Point3 mean = unit(Point3(0, 0, 1) + unit(Point3(0, -0.2, 1)));
  EXPECT_LT(glm::distance(normals(level, 30.0, 1e-6)[0][0], mean), 1e-6);
}

TEST(CreaseAngle, WhereSeveralFacesMeetTheMostLevelAreSmooth) {
  const double slope = std::tan(0.1);
  const Faces faces{{{0, 0, 0}, {0, 1, 0}, {-1, 1, 0}, {-1, 0, 0}},        // to the left
                    {{0, 1, 0}, {0, 0, 0}, {1, 0, slope}, {1, 1, slope}},  // to the right, up
                    {{0, 0, 0}, {0, 1, 0}, {0, 1, -1}, {0, 0, -1}},        // down
                    {{0, 1, 0}, {0, 0, 0}, {0, 0, 1}, {0, 1, 1}}};         // up
  const auto found = normals(faces, 30.0);
  const Point3 mean = unit(own_normal(faces[0]) + own_normal(faces[1]));
  expect_near(found[0][0], mean);
  expect_near(found[1][0], mean);
  expect_near(std::abs(found[2][0].x) * Point3(1, 0, 0), {1, 0, 0});
  expect_near(std::abs(found[3][0].x) * Point3(1, 0, 0), {1, 0, 0});
}

TEST(CreaseAngle, FacesThatShareAVertexAloneAreNoNeighbours) {
  const Faces faces{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 0, 0}, {-1, 0, 0.1}, {-1, -1, 0.1}}};
  const auto found = normals(faces, 30.0);
  expect_near(found[0][0], own_normal(faces[0]));
  expect_near(found[1][0], own_normal(faces[1]));
  EXPECT_GT(glm::distance(normals(faces, 180.0)[0][0], own_normal(faces[0])), 1e-3);
}

/// The corner's angle does not depend on how a facet is cut into triangles.
TEST(CreaseAngle, TheMeanIsWeightedByAngles) {
  Faces faces = prism(24);
  Faces cut;
  for (std::size_t i = 0; i < 24; ++i) {
    const auto& f = faces[i];
    cut.push_back({f[0], f[1], f[2]});
    cut.push_back({f[2], f[3], f[0]});
  }
  const auto found = normals(cut, 30.0);
  for (std::size_t i = 0; i < cut.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) expect_near(found[i][k], radial(cut[i][k]));
  }
}

TEST(CreaseAngle, CornersThatRepeatAreOne) {
  Faces faces = prism(24);
  for (std::size_t i = 0; i < 24; ++i) {
    faces[i].push_back(faces[i].front());
    faces[i].insert(faces[i].begin() + 2, faces[i][2]);
  }
  const auto found = normals(faces, 30.0);
  for (std::size_t i = 0; i < 24; ++i) {
    for (std::size_t k = 0; k < faces[i].size(); ++k) {
      expect_near(found[i][k], radial(faces[i][k]));
    }
  }
}

TEST(CreaseAngle, OthersAreRefused) {
  GraphicsSystem g;
  Mesh mesh = mesh_of(prism(6));
  for (const double bad : {-1.0, -1e-300, 180.0001, std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::quiet_NaN()}) {
    const std::string expected = fmt::format("crease of {} degrees: expected 0 to 180", bad);
    EXPECT_EQ(error_of([&] { g.set_crease_angle(bad); }), expected);
    EXPECT_EQ(error_of([&] { complete_normals(mesh, bad); }), expected);
    EXPECT_EQ(g.looks().crease_degrees, 180.0);
  }
  EXPECT_TRUE(mesh.normals.empty());
  EXPECT_EQ(error_of([&] { replay("set-crease-angle 200\n", "a.draw", g); }),
            "a.draw:1:1: crease of 200 degrees: expected 0 to 180");
  EXPECT_NE(error_of([&] { replay("set-crease-angle\n", "a.draw", g); }), "");
  EXPECT_NE(error_of([&] { replay("set-crease-angle sharp\n", "a.draw", g); }), "");
}

class CreaseOfMesh : public test::TemporaryFolder {
 protected:
  std::string obj(const Faces& faces, const std::string& more = "") const {
    std::string text, f = more;
    int n = 0;
    for (const auto& face : faces) {
      f += "f";
      for (const Point3& p : face) {
        text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
        f += fmt::format(" {}{}", ++n, more.empty() ? "" : "//1");
      }
      f += "\n";
    }
    return file("mesh.obj", text + f).string();
  }
};

TEST_F(CreaseOfMesh, IsRecordedAndReplaysToTheSameDisplayFile) {
  const std::string path = obj(prism(24));
  std::ostringstream recording;
  Recorder recorder(recording);
  GraphicsSystem sharp, replayed, melted;
  sharp.set_recorder(&recorder);
  for (GraphicsSystem* g : {&sharp, &melted}) g->set_shading(Shading::gouraud);
  sharp.set_crease_angle(30.0);
  EXPECT_EQ(sharp.looks().crease_degrees, 30.0);
  import_mesh(path, sharp);
  import_mesh(path, melted);
  EXPECT_NE(recording.str().find("set-crease-angle 30\n"), std::string::npos);
  replay(recording.str(), "recording", replayed);
  EXPECT_EQ(dump(replayed.display_file()), dump(sharp.display_file()));
  EXPECT_NE(dump(melted.display_file()), dump(sharp.display_file()));
  // The end that is seen is one polygon of one tone.
  EXPECT_NE(dump(sharp.display_file()).find("polygon 24 "), std::string::npos);
  EXPECT_EQ(dump(melted.display_file()).find("polygon 24 "), std::string::npos);
}

TEST_F(CreaseOfMesh, FlatShadingHasNone) {
  const std::string path = obj(prism(24));
  GraphicsSystem with, without;
  with.set_crease_angle(30.0);
  import_mesh(path, with);
  import_mesh(path, without);
  EXPECT_EQ(dump(with.display_file()), dump(without.display_file()));
}

TEST_F(CreaseOfMesh, AFilesOwnNormalsAreKeptWithAWarning) {
  const std::string path = obj(prism(6), "vn 0 0.6 0.8\n");
  GraphicsSystem g;
  g.set_shading(Shading::phong);
  EXPECT_TRUE(import_mesh(path, g).warnings.empty());
  SystemInside::by_default(g, Setting::crease_angle, [&] { g.set_crease_angle(20.0); });
  EXPECT_TRUE(import_mesh(path, g).warnings.empty());
  g.set_crease_angle(30.0);
  EXPECT_EQ(import_mesh(path, g).warnings,
            std::vector<std::string>{
                "the crease angle has no effect: the file has normals of all vertices"});
}

}  // namespace
}  // namespace displayfile
