// Cut faces: a closed solid cut by cutting planes is closed again, hatched or not.

#include "displayfile/graphics_system.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "clip/geometry/back_face.h"
#include "displayfile/files.h"
#include "displayfile/mesh/section.h"
#include "displayfile/segments/display_file.h"
#include "interp/draw/draw.h"
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

using Kind = CutFaces::Kind;

const std::vector<Point2> kAngle{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};

std::vector<EnterSolid> shapes() {
  return {
      [](GraphicsSystem& g) {
        box_3(g, {-1, -1, -1}, {1, 1, 1});
      },
      [](GraphicsSystem& g) {
        torus_3(g, {0, 0, 0}, 1, 0.4, 13);
      },
      [](GraphicsSystem& g) {
        sphere_3(g, {0.1, 0, 0}, 1, 12);
      },
      [](GraphicsSystem& g) { extrude_3(g, -1, 1, kAngle); },
      [](GraphicsSystem& g) {
        g.set_light({1, 2, 3});
        g.set_shading(Shading::phong);
        torus_3(g, {0, 0, 0}, 1, 0.4, 9);
      },
      [](GraphicsSystem& g) {
        g.rotate_x_3(20);
        g.scale_3(-1, 1, 1);
        extrude_3(g, -1, 1, kAngle);
      },
  };
}

struct Plane {
  Point3 normal;
  double d;
};

/// Through some point near the middle, also across an axis and through vertices.
Plane any_plane(Source& s) {
  if (s.below(3) == 0) {
    Point3 axis(0.0);
    axis[s.below(3)] = s.below(2) == 0 ? 1.0 : -1.0;
    return {axis, s.below(2) == 0 ? 0.0 : 0.5};
  }
  const Point3 normal = test::any_direction(s);
  return {normal, s.unit() - 0.5};
}

void set(GraphicsSystem& g, int n, const Plane& plane) {
  g.set_cutting_plane(n, plane.normal.x, plane.normal.y, plane.normal.z, plane.d);
}

EnterSolid cut(const EnterSolid& solid, const std::vector<Plane>& planes, const CutFaces& faces) {
  return [=](GraphicsSystem& g) {
    for (std::size_t k = 0; k < planes.size(); ++k) set(g, static_cast<int>(k + 1), planes[k]);
    g.set_cut_faces(faces);
    solid(g);
  };
}

TEST(CutFaces, WhatIsLeftOfASolidIsClosedBitForBit) {
  Source s(1);
  int cut_faces = 0;
  for (const EnterSolid& solid : shapes()) {
    for (int round = 0; round < 60; ++round) {
      std::vector<Plane> planes;
      for (int n = 0; n < 1 + round % 3; ++n) planes.push_back(any_plane(s));
      const Entered left(cut(solid, planes, {Kind::closed}));
      ASSERT_TRUE(is_closed(left.mesh())) << round;
      const Entered open(cut(solid, planes, {Kind::open}));
      cut_faces += static_cast<int>(left.polygons().size() - open.polygons().size());
    }
  }
  EXPECT_GT(cut_faces, 100);
}

TEST(CutFaces, WhatIsLeftAndWhatIsCutAwayAreTheWhole) {
  Source s(2);
  for (const EnterSolid& solid : shapes()) {
    const double whole = volume(Entered(solid).mesh());
    for (int round = 0; round < 10; ++round) {
      const Plane plane = any_plane(s), other{-plane.normal, -plane.d};
      const double left = volume(Entered(cut(solid, {plane}, {Kind::closed})).mesh());
      const double away = volume(Entered(cut(solid, {other}, {Kind::closed})).mesh());
      EXPECT_NEAR(left + away, whole, 1e-12);
      EXPECT_GE(left / whole, 0.0);
    }
  }
}

TEST(CutFaces, TheirAreaIsThatOfTheSection) {
  Source s(3);
  for (const EnterSolid& solid : shapes()) {
    const Mesh whole = Entered(solid).mesh();
    for (int round = 0; round < 20; ++round) {
      const Plane plane = any_plane(s);
      const Section of = section(whole, {-plane.normal, plane.d});
      const Mesh left = Entered(cut(solid, {plane}, {Kind::closed})).mesh();
      double area = 0.0;
      if (!of.loops.empty()) {  // the cut face is the last polygon
        const auto face = left.face(left.faces() - 1);
        std::vector<Point3> polygon;
        for (const std::uint32_t corner : face) polygon.push_back(left.vertices[corner]);
        area = 0.5 * glm::length(newell_normal(polygon));
      }
      EXPECT_NEAR(area, std::abs(of.area), 1e-12);
    }
  }
}

TEST(CutFaces, ABoxCutInTwoHasARectangleInTheStylesInForce) {
  const Entered left([](GraphicsSystem& g) {
    g.set_cutting_plane(2, -1, 0, 0, 0.25);
    g.set_cut_faces({Kind::closed});
    g.set_fill_style({.colour = {1, 0, 0}});
    box_3(g, {-1, -1, -1}, {1, 1, 1});
    g.set_fill_style({.colour = {0, 1, 0}});
    box_3(g, {2, 0, 0}, {3, 1, 1});   // gone
    box_3(g, {-1, 3, 0}, {0, 4, 1});  // whole
  });
  const auto polygons = left.polygons();
  ASSERT_EQ(polygons.size(), 5u + 1u + 6u);
  const std::uint32_t face = polygons[5];
  EXPECT_EQ(left.scene.attributes(face).fill.colour, Colour(1, 0, 0));
  EXPECT_EQ(left.scene[face].pick, 6);  // after those of the box
  EXPECT_EQ(left.scene[polygons[6]].pick, 13);
  ASSERT_EQ(left.scene.points(face).size(), 4u);
  for (const Point3& p : left.scene.points(face)) EXPECT_EQ(p.x, 0.25);
  EXPECT_DOUBLE_EQ(left.drawn_length(face), 8.0);
  // Sides along the plane are those of the faces beside the cut face, too.
  for (std::size_t k = 0; k < 5; ++k) {
    const bool is_across = left.scene.points(polygons[k])[0].x == -1.0 &&
                           left.scene.points(polygons[k])[1].x == -1.0 &&
                           left.scene.points(polygons[k])[2].x == -1.0;
    EXPECT_DOUBLE_EQ(left.drawn_length(polygons[k]), is_across ? 8.0 : 6.5);
  }
}

/// A cut solid is drawn as a solid of the remaining form: the faces beside a cut face draw the
/// sides that they share with it, which is a back face here.
TEST(CutFaces, WhatIsLeftIsDrawnAsASolidOfThatForm) {
  const auto entered = [](bool is_cut, HiddenMethod method) {
    GraphicsSystem g;
    g.set_parallel({0.5, 0.3, 1});
    g.set_hidden_surfaces({.removal = true});
    g.set_hidden_surfaces({.method = method});
    if (is_cut) g.set_cutting_plane(1, 1, 0, 0, 0);
    g.set_cut_faces({Kind::closed});
    g.open_segment(1);
    box_3(g, {is_cut ? -0.5 : 0.0, -0.5, -0.5}, {0.5, 0.5, 0.5});
    g.close_segment();
    return g;
  };
  const DrawOptions options{.width = 90, .height = 90, .samples = 1};
  for (const HiddenMethod method :
       {HiddenMethod::z_buffer, HiddenMethod::bsp, HiddenMethod::map, HiddenMethod::franklin}) {
    EXPECT_EQ(draw(entered(true, method), options).pixels,
              draw(entered(false, method), options).pixels)
        << name_of(method);
  }
}

TEST(CutFaces, AFaceInThePlaneIsCutWhereThereIsSolidBehindIt) {
  const auto box_beside = [](double side) {
    return Entered([&](GraphicsSystem& g) {
             g.set_cutting_plane(1, side, 0, 0, 0);
             g.set_cut_faces({Kind::closed});
             box_3(g, {0, 0, 0}, {1, 1, 1});
           })
        .mesh();
  };
  EXPECT_EQ(box_beside(1).faces(), 6u);
  EXPECT_TRUE(is_closed(box_beside(1)));
  EXPECT_EQ(volume(box_beside(1)), 1.0);
  EXPECT_EQ(box_beside(-1).faces(), 0u);
}

TEST(CutFaces, PartsOfACutFaceAreNotJoinedByLines) {
  const auto angle = [](GraphicsSystem& g) {
    g.set_cutting_plane(1, -1, -1, 0, 3);  // through both arms
    g.set_cut_faces({Kind::closed});
    extrude_3(g, 0, 1, kAngle);
  };
  const Entered left(angle);
  const std::uint32_t face = left.polygons().back();
  const double arm = std::sqrt(2.0);
  EXPECT_NEAR(left.drawn_length(face), 2 * (2 * arm + 2), 1e-12);
  const auto top = std::ranges::count_if(left.polygons(), [&](std::uint32_t i) {
    return std::ranges::all_of(left.scene.points(i), [](const Point3& p) { return p.z == 1.0; });
  });
  EXPECT_EQ(top, 1);  // in one piece
}

TEST(CutFaces, PointsAreThoseOfPolygonsThatAreCutByThemselves) {
  Source s(4);
  for (const EnterSolid& solid : shapes()) {
    const Plane plane = any_plane(s);
    const auto points_of = [&](Kind kind) {
      std::set<std::tuple<double, double, double>> points;
      for (const Point3& p : Entered(cut(solid, {plane}, {kind})).mesh().vertices) {
        points.insert({p.x, p.y, p.z});
      }
      return points;
    };
    const auto closed = points_of(Kind::closed), open = points_of(Kind::open);
    EXPECT_TRUE(std::ranges::includes(open, closed));
  }
}

TEST(CutFaces, HatchingLinesAreSoFarApartAndFillTheCutFaceEvenOdd) {
  constexpr double kSpacing = 0.01;
  const Entered left(cut(
      [](GraphicsSystem& g) {
        torus_3(g, {0, 0, 0}, 1, 0.4, 40);
      },
      {{{0, 0, -1}, 0.1}}, {Kind::hatched, kSpacing}));
  const Mesh mesh = left.mesh();
  EXPECT_TRUE(is_closed(mesh));
  double length = 0.0;
  for (const std::uint32_t line : left.lines()) {
    const Point3 a = left.scene.points(line)[0], b = left.scene.points(line)[1];
    length += glm::length(b - a);
    for (const Point3& p : {a, b}) {
      EXPECT_GE(p.z, 0.1);
      EXPECT_LE(p.z, 0.1 + 3e-6);
      const double radius = std::hypot(p.x, p.y);
      EXPECT_GE(radius, 0.6);
      EXPECT_LE(radius, 1.4);
    }
    const double across = (a.y - a.x) / std::sqrt(2.0) / kSpacing;
    EXPECT_NEAR(across, std::round(across), 1e-9);
    EXPECT_NEAR(b.y - a.y, b.x - a.x, 1e-12);
  }
  const Section of = section(Entered([](GraphicsSystem& g) {
                               torus_3(g, {0, 0, 0}, 1, 0.4, 40);
                             }).mesh(),
                             {{0, 0, 1}, 0.1});
  EXPECT_NEAR(length * kSpacing, of.area, 0.01 * of.area);
}

TEST(CutFaces, HatchingTurnsAndIsAPartOfTheSolidWhereNoSpacingIsSet) {
  const auto lines_of = [](const CutFaces& faces) {
    const Entered left(cut(
        [](GraphicsSystem& g) {
          box_3(g, {0, 0, 0}, {24, 12, 12});
        },
        {{{0, 1, 0}, -6}}, faces));
    std::vector<Point3> steps;
    for (const std::uint32_t line : left.lines()) {
      steps.push_back(left.scene.points(line)[1] - left.scene.points(line)[0]);
      EXPECT_EQ(left.scene[line].pick, -1);
    }
    return steps;
  };
  const auto level = lines_of({Kind::hatched, std::nullopt, 0.0});
  EXPECT_EQ(level.size(), 12u);  // 24 / 24 apart, and the uppermost is on the edge
  for (const Point3& step : level) EXPECT_NEAR(std::abs(step.x), 24.0, 1e-3);
  for (const Point3& step : lines_of({Kind::hatched, 3.0, 90.0})) {
    EXPECT_NEAR(std::abs(step.z), 12.0, 1e-3);
  }
  // Seen from where the solid was cut away, y < 6, with z up, they rise to the right.
  for (const Point3& step : lines_of({Kind::hatched})) EXPECT_NEAR(step.x, step.z, 1e-12);
}

/// Nothing is seen of a face that is turned away, nor of its hatching, beyond its outline or in
/// another way.
TEST(CutFaces, HatchingIsNoPartOfAViewInWhichItsFaceIsTurnedAway) {
  const auto dump_of = [](const CutFaces& faces, bool removes_back_faces) {
    GraphicsSystem g;
    g.set_parallel({0.5, 0.3, 1});
    g.set_hidden_surfaces({.removal = true});
    g.set_hidden_surfaces({.method = HiddenMethod::franklin});
    g.set_back_face_removal(removes_back_faces);
    g.set_cutting_plane(1, 1, 0, 0, 0);
    g.set_cut_faces(faces);
    g.open_segment(1);
    box_3(g, {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
    g.close_segment();
    return dump(g.display_file());
  };
  for (const bool removes : {true, false}) {
    const std::string closed = dump_of({Kind::closed}, removes);
    EXPECT_EQ(dump_of({Kind::hatched, 0.05, 30.0}, removes), closed);
  }
}

/// The solid is the remainder of its parts.
TEST(CutFaces, HatchingIsAPartOfTheSolidAndNotOfWhatWasTakenAway) {
  const auto lines_of = [](double length, std::optional<double> spacing) {
    const Entered entered([&](GraphicsSystem& g) {
      g.set_cutting_plane(1, 1, 0, 0, -0.5);
      g.set_cut_faces({Kind::hatched, spacing, 45.0});
      g.begin_solid(SolidOperation::difference);
      box_3(g, {0, 0, 0}, {1, 1, 1});
      cylinder_3(g, {0.5, 0.5, 0.5 - length / 2}, 0.2, length, 24);
      g.end_solid();
    });
    std::size_t lines = 0;
    for (std::uint32_t i = 0; i < entered.scene.size(); ++i) {
      if (entered.scene[i].is_line()) ++lines;
    }
    return lines;
  };
  for (const std::optional<double> spacing : {std::optional<double>(), std::optional(0.001)}) {
    EXPECT_EQ(lines_of(100.0, spacing), lines_of(2.0, spacing));
  }
  EXPECT_GT(lines_of(100.0, {}), 20u);
}

TEST(CutFaces, WhatIsEnteredPolygonByPolygonOrNotClosedStaysOpen) {
  const std::vector<Point3> vertices{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}};
  const std::vector<std::uint32_t> open{0, 2, 1, 0, 1, 3, 1, 2, 3},
      closed{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  const auto faces_of = [&](const EnterSolid& enter) {
    return Entered(cut(enter, {{{-1, 0, 0}, 1}}, {Kind::closed})).mesh().faces();
  };
  EXPECT_EQ(faces_of([&](GraphicsSystem& g) { g.polygons_abs_3({vertices, open}); }), 3u);
  EXPECT_EQ(faces_of([&](GraphicsSystem& g) { g.polygons_abs_3({vertices, closed}); }), 5u);
  const auto one_by_one = [&](GraphicsSystem& g) {
    for (std::size_t k = 0; k < closed.size(); k += 3) {
      g.polygon_abs_3({vertices[closed[k]], vertices[closed[k + 1]], vertices[closed[k + 2]]});
    }
  };
  EXPECT_EQ(faces_of(one_by_one), 4u);
  EXPECT_EQ(faces_of([&](GraphicsSystem& g) {
              g.begin_solid();
              one_by_one(g);
              g.end_solid();
            }),
            5u);
}

TEST(CutFaces, AMeshIsCutAsASolid) {
  Mesh mesh = Entered([](GraphicsSystem& g) { sphere_3(g, {0, 0, 0}, 1, 20); }).mesh();
  for (const bool with_normals : {false, true}) {
    if (with_normals) complete_normals(mesh);
    RetainedScene scene;
    GraphicsSystem g;
    g.retain(&scene);
    g.set_shading(with_normals ? Shading::gouraud : Shading::flat);
    g.set_light({1, 1, 1});
    g.set_cutting_plane(1, 0, 1, 0, 0.2);
    g.set_cut_faces({Kind::closed});
    enter_mesh(mesh, g, 1);
    std::vector<Point3> vertices;
    std::vector<std::uint32_t> corners, sides;
    for (std::uint32_t i = 0; i < scene.size(); ++i) {
      for (const Point3& p : scene.points(i)) {
        corners.push_back(static_cast<std::uint32_t>(vertices.size()));
        vertices.push_back(p);
      }
      sides.push_back(scene[i].sides);
    }
    EXPECT_FALSE(open_side(vertices, corners, sides));
    EXPECT_EQ(scene.is_smooth(0), with_normals);
  }
}

TEST(CutFaces, RecordedAndReplayedTheyAreTheSame) {
  for (const Shading shading : {Shading::flat, Shading::phong}) {
    std::ostringstream program;
    Recorder recorder(program);
    GraphicsSystem g;
    g.set_recorder(&recorder);
    g.set_shading(shading);
    g.set_light({1, 2, 3});
    g.set_cutting_plane(1, 0.3, 1, 0.1, 0);
    g.set_cutting_plane(4, 1, 0, -1, 0.3);
    g.open_segment(1);
    torus_3(g, {0, 0, 0}, 0.7, 0.2, 11);
    g.set_cut_faces({Kind::hatched, 0.05, 30});
    g.translate_3(0.1, 0.2, 0.3);
    torus_3(g, {0, 0, 0}, 0.7, 0.2, 11);
    g.set_pick_id(5);
    g.polygons_abs_3({std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                      std::vector<std::uint32_t>{0, 1, 2},
                      {},
                      std::vector<FillStyle>{{.colour = {1, 0, 0}}}});
    box_3(g, {0, 0, 0}, {0.3, 0.4, 0.5});
    g.set_cut_faces({Kind::closed});
    box_3(g, {0, 0, 0}, {0.3, 0.4, 0.5});
    g.close_segment();
    GraphicsSystem again;
    replay(program.str(), "recorded", again);
    EXPECT_EQ(dump(again.display_file()), dump(g.display_file()));
    EXPECT_NE(program.str().find("set-cut-faces hatched 0.05 30\n"), std::string::npos);
  }
}

TEST(CutFaces, HatchingOfABareMeshIsRecordedAndTakenBackAfterIt) {
  const Mesh mesh = Entered([](GraphicsSystem& g) { sphere_3(g, {0, 0, 0}, 1, 20); }).mesh();
  std::ostringstream program;
  Recorder recorder(program);
  GraphicsSystem g;
  g.set_recorder(&recorder);
  g.set_cutting_plane(1, 0, 0, -1, 0.2);
  g.set_cut_faces({Kind::hatched});
  const auto lines = [&] {
    std::size_t all = 0;
    for (const Segment& segment : g.display_file().segments()) all += segment.lines();
    return all;
  };
  enter_meshes(std::span(&mesh, 1), g);
  const std::size_t hatching = lines();
  EXPECT_GT(hatching, 10u);
  EXPECT_TRUE(g.looks().attributes.line.of_kinds.empty());
  EXPECT_EQ(g.looks().attributes.line.kind, LineStyle::Kind::solid);
  GraphicsSystem again;
  replay(program.str(), "recorded", again);
  EXPECT_EQ(dump(again.display_file()), dump(g.display_file()));
  // A style that was set stays, and hatches a mesh by itself.
  g.set_line_kind_style(StyledLines::hatch, {.width = 3.0});
  enter_meshes(std::span(&mesh, 1), g);
  EXPECT_EQ(lines(), 2 * hatching);
  EXPECT_EQ(g.looks().attributes.line.of_kinds.of(StyledLines::hatch),
            (LineKindStyle{.width = 3.0}));
  // Without cut faces, or with a line style that is none, there is none.
  g.set_line_kind_style(StyledLines::hatch, {});
  g.set_line_style({LineStyle::Kind::none});
  enter_meshes(std::span(&mesh, 1), g);
  EXPECT_EQ(lines(), 2 * hatching);
}

/// The angle too where the spacing is the default.
TEST(CutFaces, TheAngleIsRecordedWithTheUsualSpacing) {
  for (const auto& [faces, line] :
       {std::pair(CutFaces{Kind::hatched}, "set-cut-faces hatched\n"),
        std::pair(CutFaces{Kind::hatched, std::nullopt, 0.0}, "set-cut-faces hatched usual 0\n"),
        std::pair(CutFaces{Kind::hatched, std::nullopt, -30.5},
                  "set-cut-faces hatched usual -30.5\n")}) {
    std::ostringstream program;
    Recorder recorder(program);
    GraphicsSystem g, again;
    g.set_recorder(&recorder);
    g.set_cutting_plane(1, 0.3, 1, 0.1, 0);
    g.set_cut_faces(faces);
    g.open_segment(1);
    box_3(g, {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
    g.close_segment();
    EXPECT_NE(program.str().find(line), std::string::npos) << program.str();
    replay(program.str(), "recorded", again);
    EXPECT_EQ(again.looks().cut_faces.spacing, std::nullopt);
    EXPECT_EQ(again.looks().cut_faces.angle, faces.angle);
    EXPECT_EQ(dump(again.display_file()), dump(g.display_file()));
  }
  GraphicsSystem g;
  replay("set-cut-faces hatched usual\n", "p", g);
  EXPECT_EQ(g.looks().cut_faces.spacing, std::nullopt);
  EXPECT_EQ(g.looks().cut_faces.angle, 45.0);
}

TEST(CutFaces, WordsThatAreNoneAreRefusedAndTheOldOnesStay) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  GraphicsSystem g;
  g.set_cut_faces({Kind::hatched, 0.5, 30});
  expect_error([&] { g.set_cut_faces({Kind::hatched, 0.0}); }, "hatching 0 apart");
  expect_error([&] { g.set_cut_faces({Kind::hatched, kNone}); }, "hatching nan apart");
  expect_error([&] { g.set_cut_faces({Kind::hatched, 1.0, kNone}); }, "angle");
  EXPECT_EQ(g.looks().cut_faces.angle, 30.0);
  g.set_cut_faces({Kind::hatched, 1e-9});
  g.set_cutting_plane(1, 0, 1, 0, 0);
  g.open_segment(1);
  expect_error([&] { box_3(g, {-1, -1, -1}, {1, 1, 1}); }, "at most 100000 lines");
  EXPECT_EQ(g.counts().solids_open, 0u);
  EXPECT_EQ(g.counts().polygons, 0);
  g.close_segment();
  const auto error_of_program = [](const std::string& program) {
    GraphicsSystem of_program;
    return test::error_of([&] { replay(program, "p", of_program); });
  };
  EXPECT_NE(error_of_program("set-cut-faces shut\n")
                .find("p:1:15: cut faces are open, closed or hatched, not 'shut'"),
            std::string::npos);
  EXPECT_NE(
      error_of_program("set-cut-faces closed 1\n").find("2 arguments, expected open | closed"),
      std::string::npos);
  EXPECT_NE(error_of_program("set-cut-faces hatched x\n").find("p:1:23"), std::string::npos);
}

/// A comb, each of whose teeth nearly all of very many hatching lines cross.
TEST(CutFaces, HatchingThatIsCutIntoTooManyPartsIsRefused) {
  std::vector<Point2> comb{{60, -1}, {60, 0}};
  for (int k = 59; k >= 0; --k) {
    comb.emplace_back(k + 0.9, 0.0);
    comb.emplace_back(k + 0.5, 60.0);
    comb.emplace_back(k + 0.1, 0.0);
  }
  comb.emplace_back(0, -1);
  GraphicsSystem g;
  g.set_cutting_plane(1, 0, 0, 1, 0);
  g.open_segment(1);
  g.set_cut_faces({Kind::hatched, 1.3e-3, 0.0});
  expect_error([&] { extrude_3(g, -0.5, 0.5, comb); },
               "cross hatching lines at most 4000000 times");
  g.set_cut_faces({Kind::hatched, 0.5, 0.0});
  extrude_3(g, -0.5, 0.5, comb);
  g.close_segment();
}

}  // namespace
}  // namespace displayfile
