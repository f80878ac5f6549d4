// Primitive shapes: closed, turned outward, of the right volume.

#include "displayfile/graphics_system.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "displayfile/files.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/shapes/closed_shape.h"
#include "displayfile/shapes/swept.h"
#include "interp/draw/draw.h"
#include "tests/error_of.h"
#include "tests/retained_truth.h"

namespace displayfile {
namespace {

using test::expect_error;
using test::Retained;

using Enter = std::function<void(GraphicsSystem&)>;

/// The polygons that a shape enters, as a mesh with vertices of their own, in world coordinates.
Mesh mesh_of(const Enter& enter, const Point3& scale = Point3(1.0), bool smooth = false) {
  Retained retained;
  if (smooth) {
    retained.system.set_light({1, 2, 3});
    retained.system.set_shading(Shading::gouraud);
  }
  retained.system.scale_3(scale.x, scale.y, scale.z);
  retained.system.open_segment(1);
  enter(retained.system);
  retained.system.close_segment();
  Mesh mesh;
  for (std::uint32_t i = 0; i < retained.scene.size(); ++i) {
    mesh.first_corner.push_back(mesh.corners.size());
    for (const Point3& p : retained.scene.points(i)) {
      mesh.corners.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
      mesh.vertices.push_back(p);
    }
  }
  mesh.first_corner.push_back(mesh.corners.size());
  mesh.objects = {{"shape", 0, mesh.faces()}};
  return mesh;
}

double volume(const Mesh& mesh) {
  double sum = 0.0;
  for (std::size_t i = 0; i < mesh.faces(); ++i) {
    const auto face = mesh.face(i);
    for (std::size_t k = 2; k < face.size(); ++k) {
      sum += glm::dot(mesh.vertices[face[0]],
                      glm::cross(mesh.vertices[face[k - 1]], mesh.vertices[face[k]]));
    }
  }
  return sum / 6.0;
}

const std::vector<Point2> kAngle{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
const std::vector<Point2> kGlass{{0, 0},     {0.6, 0},   {0.2, 0.3}, {0.2, 0.8},
                                 {0.8, 1.4}, {0.7, 1.5}, {0, 0.9}};
const std::vector<Point2> kBush{{1, 0}, {2, 0}, {2, 1}, {1, 1}};

struct Shape {
  const char* name;
  Enter enter;
  std::size_t faces;
  double volume;
};
double area_of_regular(int n) { return 0.5 * n * std::sin(2.0 * std::numbers::pi / n); }

std::vector<Shape> shapes() {
  const double a7 = area_of_regular(7);
  return {
      {"box",
       [](GraphicsSystem& g) {
         box_3(g, {-1, 0, 2}, {1, 3, 2.5});
       },
       6, 3.0},
      {"wedge",
       [](GraphicsSystem& g) {
         wedge_3(g, {-1, 0, 2}, {1, 3, 2.5});
       },
       5, 1.5},
      {"prism",
       [](GraphicsSystem& g) {
         prism_3(g, {1, 2, 3}, 2, 0.5, 7);
       },
       9, 2.0 * a7},
      {"cylinder",
       [](GraphicsSystem& g) {
         cylinder_3(g, {1, 2, 3}, 2, 0.5, 7);
       },
       9, 2.0 * a7},
      {"cone",
       [](GraphicsSystem& g) {
         cone_3(g, {1, 2, 3}, 2, 3, 7);
       },
       8, 4.0 * a7},
      {"truncated cone",
       [](GraphicsSystem& g) {
         cone_3(g, {0, 0, 3}, 2, 3, 7, 1);
       },
       9, 7.0 * a7},
      {"widening cone",
       [](GraphicsSystem& g) {
         cone_3(g, {0, 0, 3}, 1, 3, 7, 2);
       },
       9, 7.0 * a7},
      {"angle", [](GraphicsSystem& g) { extrude_3(g, 1, 3, kAngle); }, 8, 10.0},
      {"bush", [](GraphicsSystem& g) { turn_3(g, 7, kBush); }, 28, 3.0 * a7},
      {"least sphere",
       [](GraphicsSystem& g) {
         sphere_3(g, {0, 0, 0}, 1, 3);
       },
       6, 2.0 / 3.0 * area_of_regular(3)},
      {"square cone",
       [](GraphicsSystem& g) {
         turn_3(g, 4, {{{0, 0}, {1, 0}, {0, 3}}});
       },
       5, 2.0},
  };
}

TEST(Shapes, AreClosedAndTurnedOutwardAndHaveTheirVolumes) {
  for (const auto& [name, enter, faces, true_volume] : shapes()) {
    const Mesh mesh = mesh_of(enter);
    EXPECT_TRUE(closed_and_consistently_oriented(mesh)) << name;
    EXPECT_EQ(mesh.faces(), faces) << name;
    EXPECT_NEAR(volume(mesh), true_volume, 1e-12 * true_volume) << name;
  }
}

TEST(Shapes, AreTurnedOutwardWhereTheModellingTransformationMirrors) {
  for (const auto& [name, enter, faces, true_volume] : shapes()) {
    for (const Point3& scale : {Point3(-1, 1, 1), Point3(2, -1, 1), Point3(-1, -1, -0.5)}) {
      for (const bool smooth : {false, true}) {
        const Mesh mesh = mesh_of(enter, scale, smooth);
        EXPECT_TRUE(closed_and_consistently_oriented(mesh)) << name;
        EXPECT_TRUE(smooth || mesh.faces() == faces) << name;
        const double size = std::abs(scale.x * scale.y * scale.z) * true_volume;
        EXPECT_NEAR(volume(mesh), size, 1e-12 * size) << name;
      }
    }
  }
}

/// A mirrored half of a pair is lit like the other one.
TEST(Shapes, AreLitFromOutsideWhereTheyAreMirrored) {
  Picture pictures[2];
  for (const bool mirrored : {false, true}) {
    GraphicsSystem g;
    g.set_light({0, 1, 2});
    g.set_shading(Shading::phong);
    g.set_hidden_surfaces({.removal = true});
    if (mirrored) g.scale_3(-1, 1, 1);
    g.open_segment(1);
    torus_3(g, {0, 0, 0}, 0.6, 0.2, 16);
    g.close_segment();
    pictures[mirrored] = draw(g, {.width = 40, .height = 40, .samples = 1});
  }
  int different = 0;
  for (std::size_t row = 0; row < 40; ++row) {
    for (std::size_t column = 0; column < 40; ++column) {
      different +=
          pictures[0].pixels[row * 40 + column] != pictures[1].pixels[row * 40 + (39 - column)];
    }
  }
  EXPECT_LT(different, 80);  // centres on sides, and last digits
}

TEST(Shapes, RoundOnesAreClosedWithAnyFacetsAndComeNearerToTheTrueVolume) {
  const double pi = std::numbers::pi;
  double error_of_sphere = 1.0, error_of_torus = 1.0;
  for (const int facets : {3, 4, 5, 8, 16, 33, 64, 128}) {
    const Mesh sphere = mesh_of([&](GraphicsSystem& g) { sphere_3(g, {3, 1, 2}, 1.5, facets); });
    const Mesh torus = mesh_of([&](GraphicsSystem& g) { torus_3(g, {3, 1, 2}, 1.5, 0.4, facets); });
    const Mesh glass = mesh_of([&](GraphicsSystem& g) { turn_3(g, facets, kGlass); });
    for (const Mesh* mesh : {&sphere, &torus, &glass}) {
      EXPECT_TRUE(closed_and_consistently_oriented(*mesh)) << facets;
    }
    const double of_sphere = 1.0 - volume(sphere) / (4.0 / 3.0 * pi * 1.5 * 1.5 * 1.5);
    const double of_torus = 1.0 - volume(torus) / (2.0 * pi * pi * 1.5 * 0.4 * 0.4);
    EXPECT_GT(of_sphere, 0.0);  // inscribed
    EXPECT_GT(of_torus, 0.0);
    EXPECT_LT(of_sphere, error_of_sphere);
    EXPECT_LE(of_torus, error_of_torus);
    error_of_sphere = of_sphere;
    error_of_torus = of_torus;
  }
  EXPECT_LT(error_of_sphere, 2e-3);
  EXPECT_LT(error_of_torus, 3e-3);
}

TEST(Shapes, AProfileMayRunEitherWayAround) {
  const std::vector<Point2> back(kAngle.rbegin(), kAngle.rend());
  const auto dump_of = [](const std::vector<Point2>& profile) {
    const Mesh mesh = mesh_of([&](GraphicsSystem& g) {
      extrude_3(g, 0, 1, profile);
      g.translate_3(0, 0, 5);
      turn_3(g, 6, profile);
    });
    EXPECT_TRUE(closed_and_consistently_oriented(mesh));
    return volume(mesh);
  };
  EXPECT_NEAR(dump_of(kAngle), dump_of(back), 1e-12);
}

TEST(Shapes, EveryPolygonHasAPickIdentifierAndIsFlat) {
  GraphicsSystem g;
  g.rotate_x_3(33);
  g.rotate_y_3(21);
  g.open_segment(1);
  for (const Shape& shape : shapes()) shape.enter(g);
  sphere_3(g, {3, 1, 2}, 1.5, 32);
  torus_3(g, {3, 1, 2}, 1.5, 0.4, 32);
  turn_3(g, 32, kGlass);
  EXPECT_EQ(g.counts().triangulated, 0);
  const auto before = g.counts().polygons;
  box_3(g, {0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(g.counts().polygons, before + 6);
}

TEST(Shapes, SmoothShadingHasTheNormalsOfWhatIsRound) {
  const ClosedShape sphere =
      turned(std::vector<Point2>{{0, -1}, {1, 0}, {0, 1}}, 8, TurnedLight::smooth,
             std::vector<Point2>{{0, -1}, {1, 0}, {0, 1}});
  ASSERT_EQ(sphere.normals.size(), sphere.corners.size());
  for (std::size_t k = 0; k < sphere.corners.size(); ++k) {
    EXPECT_LT(glm::length(sphere.normals[k] - sphere.vertices[sphere.corners[k]]), 1e-15);
  }
  std::string dumps[2];
  for (const bool smooth : {false, true}) {
    GraphicsSystem g;
    g.set_light({1, 2, 3});
    if (smooth) g.set_shading(Shading::gouraud);
    g.open_segment(1);
    cylinder_3(g, {0, 0, -0.3}, 0.5, 0.5, 12);
    prism_3(g, {0, 0, 0.3}, 0.5, 0.5, 12);
    g.close_segment();
    dumps[smooth] = dump(g.display_file());
  }
  const auto count = [](const std::string& text, const std::string& word) {
    std::size_t n = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
      ++n;
    return n;
  };
  EXPECT_EQ(count(dumps[0], "intensities"), 0u);
  EXPECT_GT(count(dumps[1], "intensities"), 8u);   // the cylinder's sides, as two triangles each,
  EXPECT_LE(count(dumps[1], "intensities"), 24u);  // and neither its caps nor the prism
}

TEST(Shapes, RecordedTheyReplayTheSame) {
  for (const bool smooth : {false, true}) {
    std::ostringstream program;
    Recorder recorder(program);
    GraphicsSystem g;
    g.set_recorder(&recorder);
    g.set_light({1, 2, 3});
    g.set_shading(smooth ? Shading::phong : Shading::flat);
    g.open_segment(1);
    for (const Shape& shape : shapes()) shape.enter(g);
    g.line_rel_3(0.1, 0.1, 0.1);
    g.close_segment();
    GraphicsSystem again;
    replay(program.str(), "recorded", again);
    EXPECT_EQ(dump(again.display_file()), dump(g.display_file()));
  }
}

TEST(Shapes, ProgramsHaveThem) {
  GraphicsSystem by_program, by_call;
  replay(
      "open-segment 1\nbox-3 -1 1 0 3 2 2.5\nwedge-3 -1 1 0 3 2 2.5\nprism-3 1 2 3 2 0.5 7\n"
      "cylinder-3 1 2 3 2 0.5 7\ncone-3 1 2 3 2 3 7\ncone-3 0 0 3 2 3 7 1\ncone-3 0 0 3 1 3 7 2\n"
      "extrude-3 1 3  0 0  3 0  3 1  1 1  1 3  0 3\nturn-3 7  1 0  2 0  2 1  1 1\n"
      "sphere-3 0 0 0 1 3\nturn-3 4  0 0  1 0  0 3\ntorus-3 0 0 0 1 0.5 8\nclose-segment\n",
      "p", by_program);
  by_call.open_segment(1);
  for (const Shape& shape : shapes()) shape.enter(by_call);
  torus_3(by_call, {0, 0, 0}, 1, 0.5, 8);
  by_call.close_segment();
  EXPECT_EQ(dump(by_program.display_file()), dump(by_call.display_file()));
}

TEST(Shapes, WhatCannotBeOneIsRefusedAndNothingIsEntered) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  GraphicsSystem g;
  g.set_light({1, 2, 3});
  for (const Shading shading : {Shading::flat, Shading::gouraud}) {
    g.set_shading(shading);
    for (const Shape& shape : shapes()) {
      expect_error([&] { shape.enter(g); }, "no segment open");
    }
  }
  g.open_segment(1);
  expect_error(
      [&] {
        box_3(g, {0, 1, 0}, {1, 1, 1});
      },
      "box from y 1 to 1: expected y-min < y-max");
  expect_error([&] { wedge_3(g, {0, 0, 0}, {1, 1, kNone}); }, "wedge from z 0 to nan");
  expect_error([&] { cylinder_3(g, {0, 0, 0}, 0, 1, 8); }, "radius 0: expected a number above 0");
  expect_error([&] { prism_3(g, {0, 0, 0}, 1, -1, 8); }, "height -1: expected");
  expect_error([&] { cone_3(g, {0, 0, 0}, 1, 1, 8, -0.5); }, "top radius -0.5: expected 0 or more");
  expect_error([&] { sphere_3(g, {0, 0, 0}, kNone, 8); }, "radius nan");
  expect_error([&] { sphere_3(g, {0, 0, 0}, 1, 2); }, "2 facets: expected 3 to 1000");
  expect_error([&] { cylinder_3(g, {0, 0, 0}, 1, 1, 1001); }, "1001 facets");
  expect_error([&] { torus_3(g, {0, 0, 0}, 1, 1, 8); }, "tube radius 1: expected less than");
  expect_error([&] { torus_3(g, {0, 0, 0}, 1, 0.1, -8); }, "-8 facets");
  expect_error([&] { box_3(g, {-1e200, 0, 0}, {1, 1, 1}); }, "at most 1e100");
  expect_error([&] { sphere_3(g, {1e100, 0, 0}, 1e100, 8); }, "at most 1e100");
  expect_error([&] { extrude_3(g, 0, 0, kAngle); }, "extruded from z 0 to 0");
  expect_error([&] { extrude_3(g, 0, 1, {{{0, 0}, {1, 0}}}); }, "profile of 2 points");
  expect_error([&] { extrude_3(g, 0, 1, {{{0, 0}, {1, 0}, {2, 0}}}); }, "profile of no area");
  expect_error(
      [&] {
        extrude_3(g, 0, 1, {{{0, 0}, {1, 0}, {1, 1}, {0, 0}}});
      },
      "point 4 of the profile, 0 0, is equal to the next");
  expect_error([&] { turn_3(g, 8, {{{0, 0}, {1, kNone}, {1, 1}}}); }, "point 2 of the profile");
  expect_error(
      [&] {
        turn_3(g, 8, {{{-1, 0}, {1, 0}, {1, 1}}});
      },
      "point 1 of the profile is at -1 from the axis");
  g.close_segment();
  EXPECT_EQ(g.counts().polygons, 0);
  const auto error_of_program = [](const std::string& program) {
    GraphicsSystem of_program;
    return test::error_of([&] { replay(program, "p", of_program); });
  };
  EXPECT_EQ(error_of_program("open-segment 1\nsphere-3 0 0 0 1\n"),
            "p:2:17: sphere-3: 4 arguments, expected 5: x y z radius facets");
  EXPECT_NE(error_of_program("open-segment 1\nturn-3 8 0 0 1\n").find("expected 1 and a multiple"),
            std::string::npos);
}

}  // namespace
}  // namespace displayfile
