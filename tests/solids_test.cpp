// Solids entered whole, and combined.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/mesh/section.h"
#include "displayfile/solids/open_solids.h"
#include "tests/error_of.h"
#include "tests/random_views.h"
#include "tests/solid_scenes.h"

namespace displayfile {
namespace {

using test::Entered;
using test::EnterSolid;
using test::expect_error;
using test::is_closed;
using test::Source;
using test::volume;

constexpr auto kUnion = SolidOperation::unite;
constexpr auto kIntersection = SolidOperation::intersect;
constexpr auto kDifference = SolidOperation::difference;

EnterSolid solid_of(SolidOperation operation, const std::vector<EnterSolid>& parts) {
  return [=](GraphicsSystem& g) {
    g.begin_solid(operation);
    for (const EnterSolid& part : parts) part(g);
    g.end_solid();
  };
}

[[maybe_unused]] EnterSolid box(const Point3& low, const Point3& high) {
  return [=](GraphicsSystem& g) { box_3(g, low, high); };
}

/// The faces of a box, one by one, except for the last `missing`.
void box_by_polygons(GraphicsSystem& g, int missing) {
  const std::array<std::array<Point3, 4>, 6> faces{
      {{{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}},
       {{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}},
       {{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}},
       {{{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}},
       {{{1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {1, 1, 1}}},
       {{{0, 1, 0}, {0, 0, 0}, {0, 0, 1}, {0, 1, 1}}}}};
  for (int k = 0; k < 6 - missing; ++k) g.polygon_abs_3(faces[static_cast<std::size_t>(k)]);
}

// ---- Without a library ---------------------------------------------------------------------

TEST(Solids, OnePartIsTheSolidAsItIs) {
  const auto by = [](const EnterSolid& enter) {
    GraphicsSystem g;
    g.set_perspective({3, 2, 6});
    g.set_light({1, 2, 3});
    g.open_segment(1);
    enter(g);
    box_3(g, {-1, -1, -1}, {0, 0, 0});  // with the pick identifiers that follow
    g.close_segment();
    return dump(g.display_file());
  };
  const auto two_colours = [](GraphicsSystem& g) {
    g.set_fill_style({.colour = {1, 0, 0}});
    box_by_polygons(g, 0);
    g.set_fill_style({.colour = {0, 0, 1}});
  };
  for (const SolidOperation operation : {kUnion, kIntersection, kDifference}) {
    EXPECT_EQ(by(solid_of(operation, {two_colours})), by(two_colours));
    EXPECT_EQ(by(solid_of(operation, {solid_of(kUnion, {two_colours})})), by(two_colours));
    const auto torus = [](GraphicsSystem& g) { torus_3(g, {0, 0, 0}, 0.5, 0.2, 9); };
    EXPECT_EQ(by(solid_of(operation, {torus})), by(torus));
  }
}

TEST(Solids, CallsOutOfOrderAreRefusedAndNothingIsLost) {
  GraphicsSystem g;
  expect_error([&] { g.begin_solid(); }, "no segment open");
  g.open_segment(1);
  expect_error([&] { g.end_solid(); }, "no solid open: expected begin-solid before");
  expect_error([&] { g.discard_solid(); }, "no solid open");
  g.begin_solid();
  expect_error([&] { g.end_solid(); }, "a solid of nothing");
  expect_error([&] { g.open_segment(2); }, "segment already open");
  expect_error([&] { g.close_segment(); }, "a solid is still open");
  expect_error([&] { g.line_abs_3(1, 0, 0); }, "a line within a solid");
  expect_error([&] { g.text("no"); }, "a text within a solid");
  const std::array heights{0.0, 0.0, 0.0, 0.0};
  expect_error([&] { g.surface_3({0, 1, 2, 0, 1, 2, heights}); }, "a surface within a solid");
  box_by_polygons(g, 1);
  expect_error([&] { g.end_solid(); },
               "the solid is not closed: its side from 0 0 0 to 0 1 0 is no other polygon's");
  EXPECT_EQ(g.counts().solids_open, 1u);
  g.polygon_abs_3({{0, 1, 0}, {0, 0, 0}, {0, 0, 1}, {0, 1, 1}});  // the missing face
  EXPECT_EQ(dump(g.display_file()).find("polygon"), std::string::npos);
  g.end_solid();
  EXPECT_NE(dump(g.display_file()).find("polygon"), std::string::npos);
  g.close_segment();
}

TEST(Solids, WhatIsDiscardedWasNeverBegun) {
  const auto by = [](bool discarding, std::string* recorded) {
    std::ostringstream program;
    Recorder recorder(program);
    GraphicsSystem g;
    g.set_recorder(&recorder);
    g.open_segment(1);
    g.begin_solid();
    for (int half : {0, 1}) {
      if (half == 1 && discarding) {
        g.begin_solid();
        box_by_polygons(g, 2);
        g.discard_solid();
      }
      const double z = half == 0 ? 0 : 1;  // two halves of one part
      g.polygon_abs_3({{0, 0, z}, {z, 1 - z, z}, {1, 1, z}, {1 - z, z, z}});
      if (half == 1) continue;
      g.polygon_abs_3({{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}});
      g.polygon_abs_3({{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}});
      g.polygon_abs_3({{1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {1, 1, 1}});
      g.polygon_abs_3({{0, 1, 0}, {0, 0, 0}, {0, 0, 1}, {0, 1, 1}});
    }
    g.end_solid();
    g.close_segment();
    if (recorded != nullptr) *recorded = program.str();
    return dump(g.display_file());
  };
  std::string recorded;
  EXPECT_EQ(by(true, &recorded), by(false, nullptr));
  GraphicsSystem again;
  replay(recorded, "recorded", again);
  EXPECT_EQ(dump(again.display_file()), by(false, nullptr));
}

TEST(Solids, TheyNestToAStatedDepth) {
  GraphicsSystem g;
  g.open_segment(1);
  for (std::size_t k = 0; k < OpenSolids::kDeepest; ++k) g.begin_solid();
  expect_error([&] { g.begin_solid(); }, "expected at most 32");
  expect_error([&] { box_3(g, {0, 0, 0}, {1, 1, 1}); }, "a shape being one, too");
  box_by_polygons(g, 0);
  while (g.counts().solids_open > 0) g.end_solid();
  g.close_segment();
  EXPECT_EQ(g.counts().polygons, 6);
}

TEST(Solids, ProgramsNameThePlace) {
  const auto error_of_program = [](const std::string& program) {
    GraphicsSystem g;
    return test::error_of([&] { replay(program, "p", g); });
  };
  EXPECT_EQ(error_of_program("open-segment 1\nend-solid\n"),
            "p:2:1: no solid open: expected begin-solid before");
  EXPECT_NE(error_of_program("open-segment 1\nbegin-solid sum\n")
                .find("p:2:13: the operation on solids is union, intersection or difference"),
            std::string::npos);
  EXPECT_EQ(error_of_program("open-segment 1\n  begin-solid union\nbox-3 0 1 0 1 0 1\n"),
            "p:3:18: 1 solid still open at the end: expected end-solid");
  EXPECT_EQ(error_of_program("open-segment 1\nbegin-solid union\nclose-segment\n"),
            "p:3:1: a solid is still open: end it first, by end-solid");
  EXPECT_NE(error_of_program("open-segment 1\nbegin-solid union\npolygon-abs-3 0 0 0 1 0 0 0 1 0\n"
                             "end-solid\n")
                .find("p:4:1: the solid is not closed"),
            std::string::npos);
}

#if !DISPLAYFILE_COMBINES_SOLIDS

TEST(Solids, WithoutTheLibraryItIsNamed) {
  GraphicsSystem g;
  g.open_segment(1);
  g.begin_solid();
  box_3(g, {0, 0, 0}, {1, 1, 1});
  box_3(g, {0, 0, 0}, {2, 1, 1});
  expect_error([&] { g.end_solid(); }, "libcgal-dev");
  EXPECT_EQ(g.counts().solids_open, 1u);
}

#else

// ---- Combined ------------------------------------------------------------------------------

TEST(CombinedSolids, OfTwoBoxes) {
  const EnterSolid a = box({0, 0, 0}, {2, 2, 2}), b = box({1, 1, 1}, {3, 3, 3});
  const std::array expected{15.0, 1.0, 7.0};
  const std::array<std::size_t, 3> faces{12, 6, 9};
  const std::array operations{kUnion, kIntersection, kDifference};
  for (std::size_t k = 0; k < 3; ++k) {
    const Mesh mesh = Entered(solid_of(operations[k], {a, b})).mesh();
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_EQ(volume(mesh), expected[k]);
    EXPECT_EQ(mesh.faces(), faces[k]);
  }
}

TEST(CombinedSolids, VolumesOfPartsThatLieAnyhowAddUp) {
  Source s(6);
  for (int round = 0; round < 24; ++round) {
    const auto any_solid = [&]() -> EnterSolid {
      const Point3 by{s.unit(), s.unit(), s.unit()};
      const double turn = 360 * s.unit();
      const int kind = s.below(3);
      return [=](GraphicsSystem& g) {
        g.save_transformation_3();
        g.translate_3(by.x, by.y, by.z);
        g.rotate_x_3(turn);
        g.rotate_y_3(turn);
        if (kind == 0) box_3(g, {0, 0, 0}, {1, 0.8, 1.2});
        if (kind == 1) torus_3(g, {0, 0, 0}, 0.8, 0.3, 11);
        if (kind == 2) cone_3(g, {0, 0, 0}, 0.8, 1, 13, 0.3);
        g.restore_transformation_3();
      };
    };
    const EnterSolid a = any_solid(), b = any_solid();
    const auto volume_of = [&](SolidOperation operation, const std::vector<EnterSolid>& parts) {
      const Mesh mesh = Entered(solid_of(operation, parts)).mesh();
      EXPECT_TRUE(is_closed(mesh)) << round;
      return mesh.faces() == 0 ? 0.0 : volume(mesh);
    };
    const double both = volume_of(kIntersection, {a, b});
    const double of_a = volume_of(kUnion, {a}), of_b = volume_of(kUnion, {b});
    EXPECT_NEAR(volume_of(kUnion, {a, b}), of_a + of_b - both, 1e-12) << round;
    EXPECT_NEAR(volume_of(kDifference, {a, b}), of_a - both, 1e-12) << round;
    EXPECT_NEAR(volume_of(kDifference, {a, solid_of(kDifference, {a, b})}), both, 1e-12) << round;
  }
}

TEST(CombinedSolids, PartsFollowEachOtherInTheirOrder) {
  const EnterSolid a = box({0, 0, 0}, {4, 1, 1}), b = box({-1, -1, -1}, {1, 2, 2}),
                   c = box({3, -1, -1}, {5, 2, 2});
  EXPECT_EQ(volume(Entered(solid_of(kDifference, {a, b, c})).mesh()), 2.0);
  EXPECT_EQ(volume(Entered(solid_of(kDifference, {b, a})).mesh()), 17.0);
  EXPECT_EQ(volume(Entered(solid_of(kUnion, {a, b, c})).mesh()), 38.0);
  // One within another: b and c together, without a.
  EXPECT_EQ(volume(Entered(solid_of(kDifference, {solid_of(kUnion, {b, c}), a})).mesh()), 34.0);
}

/// Polygons of one colour, and the length of their drawn sides.
struct Painted {
  int polygons = 0;
  double drawn = 0.0;
};

std::map<double, Painted> by_red(const Entered& entered) {
  std::map<double, Painted> all;
  for (const std::uint32_t i : entered.polygons()) {
    Painted& painted = all[entered.scene.attributes(i).fill.colour.r];
    ++painted.polygons;
    painted.drawn += entered.drawn_length(i);
  }
  return all;
}

EnterSolid in_red(double red, int pick, const EnterSolid& solid) {
  return [=](GraphicsSystem& g) {
    g.set_fill_style({.colour = {red, 0, 0}});
    g.set_pick_id(pick);
    solid(g);
  };
}

TEST(CombinedSolids, FacesKeepTheColoursAndPickIdentifiersOfTheirParts) {
  const auto hole = [](GraphicsSystem& g) { cylinder_3(g, {1, 1, -1}, 0.5, 3, 12); };
  const Entered drilled(
      solid_of(kDifference, {in_red(1.0, 7, box({0, 0, 0}, {2, 2, 1})), in_red(0.5, 9, hole)}));
  const auto painted = by_red(drilled);
  EXPECT_EQ(painted.at(1.0).polygons, 6);
  EXPECT_EQ(painted.at(0.5).polygons, 12);
  for (const std::uint32_t i : drilled.polygons()) {
    EXPECT_EQ(drilled.scene[i].pick, drilled.scene.attributes(i).fill.colour.r == 1.0 ? 7 : 9);
  }
  EXPECT_TRUE(is_closed(drilled.mesh()));
  // A face with a hole shows its own sides and those of the hole, and nothing between them.
  const double around = 12 * 2 * 0.5 * std::sin(3.14159265358979 / 12);
  EXPECT_NEAR(painted.at(1.0).drawn, 2 * (8 + around) + 4 * 6, 1e-9);
}

/// Sides are not parted where diagonals of triangles, which were not entered, meet them.
TEST(CombinedSolids, FacesHaveTheCornersOfTheSolidAlone) {
  for (int seed = 0; seed < 8; ++seed) {
    Source s(static_cast<std::uint64_t>(seed));
    const double turn = seed == 0 ? 0.0 : 10.0 * seed;
    const double x = 0.7 + 0.06 * s.below(10), y = 0.7 + 0.06 * s.below(10);
    const auto bored = solid_of(kDifference, {[=](GraphicsSystem& g) {
                                                g.rotate_x_3(turn);
                                                g.rotate_z_3(2.0 * turn);
                                                box_3(g, {0, 0, 0}, {2, 2, 1});
                                              },
                                              [=](GraphicsSystem& g) {
                                                cylinder_3(g, {x, y, -1}, 0.5, 3, 24);
                                              }});
    const Entered plate(bored);
    std::map<std::size_t, int> polygons;  // by their number of corners
    for (const std::uint32_t i : plate.polygons()) ++polygons[plate.scene.points(i).size()];
    // A face with a hole is one polygon, with a bridge there and back.
    EXPECT_EQ(polygons, (std::map<std::size_t, int>{{4, 4 + 24}, {4 + 24 + 2, 2}})) << seed;
    EXPECT_TRUE(is_closed(plate.mesh())) << seed;
  }
}

TEST(CombinedSolids, FacesInOnePlaneShowNoSideBetweenThem) {
  const EnterSolid a = box({0, 0, 0}, {1, 1, 1}), b = box({1, 0, 0}, {3, 1, 1});
  const Entered beam(solid_of(kUnion, {a, b}));
  double drawn = 0.0;
  for (const std::uint32_t i : beam.polygons()) drawn += beam.drawn_length(i);
  EXPECT_DOUBLE_EQ(drawn, 2 * (4 * 3 + 8 * 1));  // of a box, each side from both faces
  EXPECT_EQ(volume(beam.mesh()), 3.0);
  // Where two colours meet, the side between them is a side of the part.
  const Entered two(solid_of(kUnion, {in_red(1.0, 1, a), in_red(0.5, 2, b)}));
  drawn = 0.0;
  for (const std::uint32_t i : two.polygons()) drawn += two.drawn_length(i);
  EXPECT_DOUBLE_EQ(drawn, 2 * (4 * 3 + 8 * 1) + 2 * 4);
}

TEST(CombinedSolids, EachPartHasItsOwnTransformation) {
  const auto turned = [](GraphicsSystem& g) {
    g.save_transformation_3();
    g.rotate_z_3(45);
    g.scale_3(-1, 1, 1);  // inside out
    box_3(g, {-1, -1, -1}, {1, 1, 1});
    g.restore_transformation_3();
  };
  const Mesh mesh = Entered([&](GraphicsSystem& g) {
                      g.translate_3(5, 0, 0);
                      solid_of(kIntersection, {box({-1, -1, -1}, {1, 1, 1}), turned})(g);
                    }).mesh();
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_NEAR(volume(mesh), 2 * 8 * (std::sqrt(2.0) - 1), 1e-12);  // an octagon
  for (const Point3& p : mesh.vertices) EXPECT_GE(p.x, 4.0);
}

TEST(CombinedSolids, PolygonsBetweenShapesAreOnePart) {
  const auto loose = [](GraphicsSystem& g) { box_by_polygons(g, 0); };
  const Mesh mesh = Entered(solid_of(kDifference, {box({-1, -1, -1}, {2, 2, 2}), loose})).mesh();
  EXPECT_EQ(volume(mesh), 26.0);  // with a hollow
  EXPECT_TRUE(is_closed(mesh));
  const Mesh first = Entered(solid_of(kIntersection, {loose, box({0.5, 0, 0}, {2, 2, 2})})).mesh();
  EXPECT_EQ(volume(first), 0.5);
}

TEST(CombinedSolids, RoundFacesKeepTheirNormals) {
  const Entered half([](GraphicsSystem& g) {
    g.set_light({1, 2, 3});
    g.set_shading(Shading::phong);
    solid_of(kDifference, {box({-2, -2, -2}, {2, 2, 0.3}), [](GraphicsSystem& s) {
                             sphere_3(s, {0, 0, 0}, 1, 24);
                           }})(g);
  });
  EXPECT_TRUE(is_closed(half.mesh()));
  int smooth = 0;
  for (const std::uint32_t i : half.polygons()) {
    if (!half.scene.is_smooth(i)) continue;
    ++smooth;
    const WorldPolygon polygon = half.scene.polygon(i);
    for (std::size_t k = 0; k < polygon.vertex_normals.size(); ++k) {
      // The hollow's surface is turned to its middle.
      EXPECT_GT(-glm::dot(polygon.vertex_normals[k], glm::normalize(polygon.vertices[k])), 0.99);
    }
  }
  EXPECT_GT(smooth, 100);
}

TEST(CombinedSolids, OfNothingNothingIsEnteredAndCounted) {
  GraphicsSystem g;
  g.open_segment(1);
  solid_of(kIntersection, {box({0, 0, 0}, {1, 1, 1}), box({2, 0, 0}, {3, 1, 1})})(g);
  EXPECT_EQ(dump(g.display_file()).find("polygon"), std::string::npos);
  EXPECT_EQ(g.counts().empty_solids, 1);
  // An empty part of another solid is not counted.
  solid_of(kUnion, {solid_of(kDifference, {box({0, 0, 0}, {1, 1, 1}), box({0, 0, 0}, {1, 1, 1})}),
                    box({0, 0, 0}, {1, 1, 1})})(g);
  EXPECT_EQ(g.counts().empty_solids, 1);
  EXPECT_NE(dump(g.display_file()).find("polygon"), std::string::npos);
  g.close_segment();
}

TEST(CombinedSolids, WhatIsNoSolidIsRefusedAndNothingIsLost) {
  GraphicsSystem g;
  g.open_segment(1);
  g.begin_solid(kUnion);
  box_3(g, {0, 0, 0}, {1, 1, 1});
  g.begin_solid();
  const std::vector<Point2> crossing{{0, 0}, {2, 2}, {2, 0}, {0, 2.5}};
  extrude_3(g, 0, 1, crossing);
  g.end_solid();
  expect_error([&] { g.end_solid(); }, "part 2 of 2 of the solid passes through itself near");
  g.discard_solid();
  EXPECT_EQ(g.counts().solids_open, 0u);
  g.begin_solid(kUnion);
  g.begin_solid();
  box_by_polygons(g, 0);
  g.translate_3(1, 1, 0);  // they touch along an edge: enter them as two parts
  box_by_polygons(g, 0);
  g.end_solid();
  box_3(g, {0, 0, 0}, {1, 1, 1});
  expect_error([&] { g.end_solid(); }, "part 1 of 2 of the solid passes through itself near");
  EXPECT_EQ(g.counts().solids_open, 1u);
  g.discard_solid();
  EXPECT_EQ(g.counts().polygons, 0);
  g.close_segment();
}

EnterSolid bush() {
  return solid_of(kDifference, {[](GraphicsSystem& g) {
                                  cylinder_3(g, {0, 0, 0}, 1, 1, 16);
                                },
                                [](GraphicsSystem& g) {
                                  cylinder_3(g, {0, 0, -1}, 0.5, 3, 12);
                                },
                                box({0.3, -0.1, 0.2}, {2, 0.1, 0.8})});
}

TEST(CombinedSolids, CutAndHatchedTheyAreClosed) {
  const Mesh whole = Entered(bush()).mesh();
  const auto left = [](const Point3& n, double d, CutFaces::Kind kind) {
    return Entered([&](GraphicsSystem& g) {
      g.set_cutting_plane(1, n.x, n.y, n.z, d);
      g.set_cut_faces({kind});
      bush()(g);
    });
  };
  for (const auto kind : {CutFaces::Kind::closed, CutFaces::Kind::hatched}) {
    for (const Point3& n : {Point3(0, 1, 0), Point3(0, 0, -1), Point3(0.3, 0.4, 0.5)}) {
      const Entered part = left(n, 0.45, kind), other = left(-n, -0.45, kind);
      EXPECT_TRUE(is_closed(part.mesh()));
      EXPECT_NEAR(volume(part.mesh()) + volume(other.mesh()), volume(whole), 1e-12);
      EXPECT_EQ(part.lines().empty(), kind == CutFaces::Kind::closed);
    }
  }
}

TEST(CombinedSolids, RecordedAndReplayedTheyAreTheSame) {
  for (const Shading shading : {Shading::flat, Shading::phong}) {
    std::ostringstream program;
    Recorder recorder(program);
    GraphicsSystem g;
    g.set_recorder(&recorder);
    g.set_light({1, 2, 3});
    g.set_shading(shading);
    g.open_segment(1);
    g.rotate_x_3(30);
    bush()(g);
    g.set_cut_faces({CutFaces::Kind::hatched});
    g.set_cutting_plane(1, 0, 1, 0, 0);
    bush()(g);
    solid_of(kUnion, {[](GraphicsSystem& s) { box_by_polygons(s, 0); }, bush()})(g);
    g.close_segment();
    GraphicsSystem again;
    replay(program.str(), "recorded", again);
    EXPECT_EQ(dump(again.display_file()), dump(g.display_file()));
  }
}

TEST(CombinedSolids, ProgramsHaveThem) {
  GraphicsSystem by_program, by_call;
  replay(
      "open-segment 1\nbegin-solid difference\nbox-3 0 2 0 2 0 2\nbegin-solid union\n"
      "box-3 1 3 1 3 1 3\nbox-3 1 3 1 3 -1 0.5\nend-solid\nend-solid\nclose-segment\n",
      "p", by_program);
  by_call.open_segment(1);
  solid_of(kDifference,
           {box({0, 0, 0}, {2, 2, 2}),
            solid_of(kUnion, {box({1, 1, 1}, {3, 3, 3}), box({1, 1, -1}, {3, 3, 0.5})})})(by_call);
  by_call.close_segment();
  EXPECT_EQ(dump(by_program.display_file()), dump(by_call.display_file()));
}

#endif

}  // namespace
}  // namespace displayfile
