// Which sides of polygons are lines: the kinds, found in world coordinates among the polygons that
// share a side, on their way into segments, orders and views.

#include "clip/surfaces.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "displayfile/files.h"
#include "displayfile/segments/sorted_display_file.h"
#include "displayfile/views/retained_views.h"
#include "displayfile/views/scene_viewer.h"
#include "tests/quad_meshes.h"
#include "tests/sides_of_kinds.h"

namespace displayfile {
namespace {

using test::box;
using test::count;
using test::drawn;
using test::drawn_sides;
using test::drawn_with;
using test::DrawnSides;
using test::enter;
using test::enter_triangles;
using test::kBoundary;
using test::kCrease;
using test::kMaterial;
using test::kOutline;
using test::Less;
using test::Quad;
using test::Sides;
using test::sides_in_view;
using test::torus;

void expect_same_lengths(const DisplayFile& pieces, const DisplayFile& whole) {
  const DrawnSides of_pieces = drawn(pieces), of_whole = drawn(whole);
  EXPECT_EQ(of_pieces.lengths.size(), of_whole.lengths.size());
  for (const auto& [kinds, length] : of_whole.lengths) {
    const auto same = of_pieces.lengths.find(kinds);
    ASSERT_NE(same, of_pieces.lengths.end()) << names_of(kinds);
    EXPECT_NEAR(same->second, length, 1e-9) << names_of(kinds);
  }
}

template <class Enter>
Sides world_sides(const std::string& words, Enter&& enter_all,
                  const Eye& eye = Eye::at({3, 2, 5})) {
  return sides_in_view(*drawn_with(words, enter_all).retained(), eye);
}

// ---- The kinds ---------------------------------------------------------------------------

TEST(LineKinds, ACubeHasTwelveCreasesAndItsDiagonalsAreNone) {
  const auto quads = [](GraphicsSystem& g) { enter(g, box()); };
  const auto triangles = [](GraphicsSystem& g) { enter_triangles(g, box()); };
  EXPECT_EQ(count(world_sides("crease", quads), kCrease), 12u);
  for (const char* const words : {"crease", "crease=0", "crease=89.9"}) {
    const Sides sides = world_sides(words, triangles);
    EXPECT_EQ(sides.size(), 12u) << words;
    EXPECT_EQ(count(sides, kCrease), 12u) << words;
  }
  EXPECT_EQ(world_sides("crease=90", triangles).size(), 0u);
  EXPECT_EQ(world_sides("boundary", triangles).size(), 0u);
  EXPECT_EQ(world_sides("all,crease", triangles).size(), 18u);
}

TEST(LineKinds, AnOpenBoxHasABoundary) {
  const auto open_box = [](GraphicsSystem& g) {
    auto quads = box();
    quads.pop_back();
    enter(g, quads);
  };
  EXPECT_EQ(world_sides("boundary", open_box).size(), 4u);
  for (const auto& [ends, kinds] : world_sides("boundary,outline", open_box)) {
    EXPECT_TRUE(kinds == kBoundary || kinds == kOutline);
  }
}

TEST(LineKinds, AFoldIsACreaseIfItTurnsByMore) {
  const auto folded = [](double degrees, bool reversed) {
    return [=](GraphicsSystem& g) {
      const double a = degrees * std::numbers::pi / 180.0, x = std::cos(a), z = std::sin(a);
      g.polygon_abs_3({{0, 0, 0}, {0, 1, 0}, {-1, 1, 0}, {-1, 0, 0}});
      if (reversed) {
        g.polygon_abs_3({{0, 0, 0}, {0, 1, 0}, {x, 1, z}, {x, 0, z}});
      } else {
        g.polygon_abs_3({{0, 0, 0}, {x, 0, z}, {x, 1, z}, {0, 1, 0}});
      }
    };
  };
  for (const bool reversed : {false, true}) {  // the directions of the vertices do not matter
    EXPECT_EQ(world_sides("crease", folded(29.0, reversed)).size(), 0u);
    EXPECT_EQ(world_sides("crease", folded(31.0, reversed)).size(), 1u);
    EXPECT_EQ(world_sides("crease", folded(-31.0, reversed)).size(), 1u);
    EXPECT_EQ(world_sides("crease=28", folded(29.0, reversed)).size(), 1u);
    EXPECT_EQ(world_sides("crease=170", folded(171.0, reversed)).size(), 1u);
    EXPECT_EQ(world_sides("crease=0", folded(0.0, reversed)).size(), 0u);
    EXPECT_EQ(world_sides("crease=180", folded(179.0, reversed)).size(), 0u);
  }
}

TEST(LineKinds, OfSeveralPolygonsAtASideAnyTwoMakeACrease) {
  const auto fan = [](const std::vector<double>& directions) {
    return [=](GraphicsSystem& g) {
      for (const double degrees : directions) {
        const double a = degrees * std::numbers::pi / 180.0;
        g.polygon_abs_3({{0, 0, 0}, {0, 0, 1}, {std::cos(a), std::sin(a), 0.5}});
      }
    };
  };
  EXPECT_EQ(world_sides("crease=60.1", fan({0, 120, 240})).size(), 0u);
  EXPECT_EQ(world_sides("crease=59.9", fan({0, 120, 240})).size(), 1u);
  EXPECT_EQ(world_sides("crease=101", fan({10, 90, 180, 270})).size(), 0u);
  EXPECT_EQ(world_sides("crease=99", fan({10, 90, 180, 270})).size(), 1u);
  EXPECT_EQ(world_sides("boundary", fan({0, 120, 240})).size(), 6u);
}

TEST(LineKinds, MaterialIsWhereFillsDiffer) {
  const auto two = [](const FillStyle& left, const FillStyle& right) {
    return [=](GraphicsSystem& g) {
      g.set_light({0.0, 0.0, 1.0});
      g.set_fill_style(left);
      g.polygon_abs_3({{0, 0, 0}, {0, 1, 0}, {-1, 1, 0}, {-1, 0, 0}});
      g.set_fill_style(right);
      g.polygon_abs_3({{0, 0, 0}, {1, 0, 0.5}, {1, 1, 0.5}, {0, 1, 0}});
    };
  };
  const FillStyle red{FillStyle::Kind::solid, {1, 0, 0}}, blue{FillStyle::Kind::solid, {0, 0, 1}};
  EXPECT_EQ(world_sides("material", two(red, red)).size(), 0u);
  EXPECT_EQ(count(world_sides("material", two(red, blue)), kMaterial), 1u);
  EXPECT_EQ(world_sides("material", two(red, {FillStyle::Kind::hollow})).size(), 1u);
}

TEST(LineKinds, SidesMadeByTriangulationAreOutlinesOrNothing) {
  const auto bent = [](GraphicsSystem& g) {
    g.polygon_abs_3({{0, 0, 0}, {1, 0, 0.7}, {1, 1, 0}, {0, 1, 0.7}});
  };
  EXPECT_EQ(world_sides("all,boundary,crease=1", bent).size(), 4u);
  EXPECT_EQ(count(world_sides("crease=1", bent), kCrease), 0u);
  std::size_t outlines = 0;
  for (int k = 0; k < 16; ++k) {
    const double a = 2.0 * std::numbers::pi * k / 16;
    outlines += world_sides("outline", bent, Eye::toward({std::cos(a), std::sin(a), 0.3})).size();
  }
  EXPECT_GT(outlines, 0u);
}

std::vector<Eye> eyes() {
  return {Eye::at({3, 2, 5}),      Eye::at({0.1, 0.0, 1.0}), Eye::toward({0.3, 0.4, 1.0}),
          Eye::toward({0, 0, 1}),  Eye::toward({1, 0, 0}),   Eye::toward({0, 1, 0}),
          Eye::toward({-1, 1, 0}), Eye::at({0.6, 0, 0.2})};
}

/// Closed meshes have closed outlines, whatever the view.
TEST(LineKinds, EvenlyManyOutlinesMeetAtEachVertexOfAClosedMesh) {
  const std::vector<std::vector<Quad>> meshes{box(), torus(12, 8), torus(7, 5)};
  for (const std::vector<Quad>& mesh : meshes) {
    for (const bool triangles : {false, true}) {
      const GraphicsSystem g = drawn_with("outline", [&](GraphicsSystem& system) {
        triangles ? enter_triangles(system, mesh) : enter(system, mesh);
      });
      for (const Eye& eye : eyes()) {
        const Sides sides = sides_in_view(*g.retained(), eye);
        EXPECT_FALSE(sides.empty());
        std::map<Point3, int, Less> at_vertex;
        for (const auto& [ends, kinds] : sides) {
          EXPECT_EQ(kinds, kOutline);
          ++at_vertex[ends.first];
          ++at_vertex[ends.second];
        }
        for (const auto& [vertex, sides_there] : at_vertex) EXPECT_EQ(sides_there % 2, 0);
      }
    }
  }
}

TEST(LineKinds, EdgeOnCountsAsTurnedAway) {
  const auto cube = [](GraphicsSystem& g) { enter(g, box()); };
  EXPECT_EQ(world_sides("outline", cube, Eye::toward({0, 0, 1})).size(), 4u);  // of the front
  EXPECT_EQ(world_sides("outline", cube, Eye::toward({1, 1, 1})).size(), 6u);
}

// ---- Drawn lines -------------------------------------------------------------------------

TEST(LineKinds, BackFacesAndClippingChangeNoKind) {
  const auto outline = [](bool back_faces_removed, double front) {
    GraphicsSystem g;
    g.set_perspective({1.5, 1.2, 5.0});
    g.set_view_depth(front, 3.0);
    g.set_front_plane_clipping(true);
    g.set_back_face_removal(back_faces_removed);
    g.set_hidden_surfaces({.lines = line_selection("outline")});
    g.open_segment(1);
    enter(g, torus(12, 8));
    g.close_segment();
    return drawn_sides(g.display_file());
  };
  const Sides whole = outline(false, -3.0);
  EXPECT_EQ(count(whole, kOutline), whole.size());
  const auto xy = [](const Sides& sides) {
    std::set<std::array<double, 4>> found;
    for (const auto& [ends, kinds] : sides) {
      found.insert({ends.first.x, ends.first.y, ends.second.x, ends.second.y});
    }
    return found;
  };
  EXPECT_EQ(xy(outline(true, -3.0)), xy(whole));
  // A plane through the middle leaves of each outline the part behind it, and adds none.
  const auto kept = xy(outline(false, 0.0)), all = xy(whole);
  std::size_t cut = 0, same = 0;
  for (const auto& side : kept) ++(all.contains(side) ? same : cut);
  EXPECT_GT(same, 4u);
  EXPECT_LE(cut, 6u);
}

TEST(LineKinds, OnlyWhatHasALineStyleIsDrawn) {
  const GraphicsSystem none = drawn_with("outline,crease", [](GraphicsSystem& g) {
    g.set_line_style({LineStyle::Kind::none});
    enter(g, box());
  });
  SortedDisplayFile sorted;
  const std::string drawn =
      dump(sorted.update(none, HiddenMethod::franklin, {.method = HiddenMethod::franklin}));
  EXPECT_EQ(drawn.find("\nline "), drawn.npos) << drawn;
}

/// Lines that the application draws are lines whatever is selected.
TEST(LineKinds, LinesOfTheApplicationStay) {
  const GraphicsSystem g = drawn_with("crease", [](GraphicsSystem& system) {
    system.move_abs_3(-0.5, 0, 0);
    system.line_abs_3(0.5, 0, 0);
    system.polygon_abs_3({{0, 0, 0}, {0.5, 0, 0}, {0.5, 0.5, 0}});
  });
  EXPECT_EQ(g.display_file().segments()[0].lines(), 1u);
  EXPECT_TRUE(drawn_sides(g.display_file()).empty());
}

TEST(LineKinds, AllAloneChangesNothing) {
  GraphicsSystem plain, all;
  all.set_hidden_surfaces({.lines = LineSelection{}});
  for (GraphicsSystem* const g : {&plain, &all}) {
    g->open_segment(1);
    enter(*g, torus(7, 5));
    g->close_segment();
  }
  EXPECT_EQ(dump(plain.display_file()), dump(all.display_file()));
  EXPECT_EQ(all.retained(), nullptr);
  EXPECT_EQ(count(drawn_sides(all.display_file()), kDrawn), drawn_sides(all.display_file()).size());
}

/// A segment keeps the selection in force when it is closed.
TEST(LineKinds, EachSegmentHasItsOwn) {
  GraphicsSystem g;
  g.set_hidden_surfaces({.lines = line_selection("crease")});
  g.open_segment(1);
  enter(g, box());
  g.close_segment();
  g.open_segment(2);
  enter_triangles(g, box());
  g.set_hidden_surfaces({.lines = LineSelection{}});
  g.close_segment();
  const DisplayFile before = g.display_file();
  EXPECT_EQ(count(drawn_sides(before), kCrease), 12u);
  EXPECT_EQ(drawn_sides(before).size(), 18u);
  g.delete_segment(2);
  g.rename_segment(1, 3);
  EXPECT_EQ(count(sides_in_view(*g.retained(), Eye::at({3, 2, 5})), kCrease), 12u);
}

/// A segment whose closing is refused is unchanged, and primitives entered then look as they
/// should.
TEST(LineKinds, ARefusedClosingSelectsNothing) {
  GraphicsSystem system, other;
  for (GraphicsSystem* g : {&system, &other}) {
    g->set_hidden_surfaces({.lines = LineSelection{kinds_of(LineKind::boundary)}});
    g->set_hidden_surfaces({.removal = true});
    g->open_segment(1);
    g->set_line_style({.colour = {1, 0, 0}});
    g->polygon_abs_3({{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0, 0.5, 0}});
    g->set_line_style({.colour = {0, 0, 1}});
    g->polygon_abs_3({{-0.5, -0.5, 0}, {0, 0.5, 0}, {-0.5, 0.5, 0.25}});
    g->polygon_abs_3({{-0.5, -0.5, 0}, {-0.5, 0.5, 0.25}, {0, 0.5, 0}});
  }
  const std::string before = dump(system.display_file());
  system.set_hidden_surfaces({.method = HiddenMethod::perimeter});  // which is for a surface
  EXPECT_THROW(system.close_segment(), Error);
  EXPECT_EQ(dump(system.display_file()), before);
  for (GraphicsSystem* g : {&system, &other}) {
    g->set_hidden_surfaces({.method = HiddenMethod::bsp});
    g->polygon_abs_3({{0.5, -0.5, 0}, {0.5, 0.5, 0}, {0, 0.5, 0}});
  }
  EXPECT_EQ(dump(system.display_file()), dump(other.display_file()));
  for (GraphicsSystem* g : {&system, &other}) g->close_segment();
  EXPECT_EQ(dump(system.display_file()), dump(other.display_file()));
}

/// Kinds go with the sides of polygons that a sort cuts.
TEST(LineKinds, CutSidesKeepThem) {
  const auto crossing = [](GraphicsSystem& g) {
    enter(g, box());
    g.polygon_abs_3({{-1, -1, 0.1}, {1, -1, 0.2}, {1, 1, 0.15}, {-1, 1, -0.1}});
  };
  const GraphicsSystem g = drawn_with("crease,boundary", crossing);
  SortedDisplayFile sorted;
  const DisplayFile& file = sorted.update(g, HiddenMethod::bsp, {.method = HiddenMethod::bsp});
  EXPECT_GT(file.sorted()->counts.cuts, 0u);
  EXPECT_GT(drawn_sides(file).size(), drawn_sides(g.display_file()).size());
  EXPECT_EQ(drawn(g.display_file()).lengths.size(), 2u);
  expect_same_lengths(file, g.display_file());
}

/// A line that polygons share is one, with the lowest of their pick identifiers.
TEST(LineKinds, ASharedLineHasTheLowestPickIdentifier) {
  GraphicsSystem g;
  g.open_segment(1);
  g.set_pick_id(7);
  g.polygon_abs_3({{0, 0, 0}, {0.5, 0, 0}, {0.5, 0.5, 0}});
  g.set_pick_id(3);
  g.polygon_abs_3({{0, 0, 0}, {0.5, 0.5, 0}, {0, 0.5, 0}});
  g.close_segment();
  SortedDisplayFile sorted;
  const DisplayFile& file =
      sorted.update(g, HiddenMethod::franklin, {.method = HiddenMethod::franklin});
  struct Picks {
    std::int32_t now = -1;
    std::multiset<std::int32_t> of_lines;
    void fill(const FillStyle&) {}
    void line_style(const LineStyle&) {}
    void pick(std::int32_t id) { now = id; }
    void move(const Point3&) {}
    void line(const Point3&) { of_lines.insert(now); }
    void polygon(std::span<const Point3>, std::span<const std::int32_t>) { ADD_FAILURE(); }
  } picks;
  file.sorted()->walk(picks);
  EXPECT_EQ(picks.of_lines, (std::multiset<std::int32_t>{3, 3, 3, 7, 7}));
}

TEST(LineKinds, LineMethodsTellThem) {
  const GraphicsSystem g =
      drawn_with("outline,crease", [](GraphicsSystem& system) { enter(system, box()); });
  SortedDisplayFile sorted;
  const DisplayFile& file =
      sorted.update(g, HiddenMethod::franklin, {.method = HiddenMethod::franklin});
  struct Lines {
    LineKinds now = kDrawn;
    std::map<LineKinds, int> of_kinds;
    void fill(const FillStyle&) {}
    void line_style(const LineStyle&) {}
    void pick(std::int32_t) {}
    void move(const Point3&) {}
    void line_kinds(LineKinds kinds) { now = kinds; }
    void line(const Point3&) { ++of_kinds[now]; }
    void polygon(std::span<const Point3>, std::span<const std::int32_t>) { ADD_FAILURE(); }
  } lines;
  file.sorted()->walk(lines);
  EXPECT_EQ(lines.of_kinds, (std::map<LineKinds, int>{{kCrease, 3}, {kOutline | kCrease, 6}}));
}

// ---- New views ---------------------------------------------------------------------------

View seen_from(const Point3& eye) {
  View view;
  view.set_perspective(eye);
  view.set_depth(-3.0, 3.0);
  return view;
}

/// A scene in a new view has the lines that it would have if it had been drawn there.
TEST(LineKinds, NewViewsSelectTheirOwn) {
  const auto draw_from = [](const Point3& eye) {
    GraphicsSystem g;
    g.set_perspective(eye);
    g.set_view_depth(-3.0, 3.0);
    g.set_back_face_removal(true);
    g.set_hidden_surfaces({.lines = line_selection("outline,crease=50")});
    for (int name = 1; name < 3; ++name) {
      g.open_segment(name);
      g.translate_3(0.2, 0.0, 0.1);
      if (name == 1) {
        enter(g, torus(9, 7));
      } else {
        enter(g, box());
      }
      g.close_segment();
    }
    return g;
  };
  const GraphicsSystem first = draw_from({1.5, 1.2, 5.0});
  SceneViewer viewer(*first.retained(), first.display_file());
  RetainedViews views(*first.retained(), first.display_file(), {});
  for (const Point3& eye : {Point3(-2.0, 0.3, 4.0), Point3(0.0, 0.0, 5.0), Point3(1.5, 1.2, 5.0)}) {
    const GraphicsSystem there = draw_from(eye);
    const Sides expected = drawn_sides(there.display_file());
    EXPECT_EQ(drawn_sides(viewer.display_file(seen_from(eye))), expected);
    const ViewedScene right(there.display_file());
    for (const int threads : {1, 3}) {
      const ViewedScene& seen = viewer.view({.view = seen_from(eye), .threads = threads});
      ASSERT_EQ(seen.items(), right.items());
      for (ViewedScene::Item item = 0; item < seen.items(); ++item) {
        for (std::size_t k = 0; k < seen.points(item).size(); ++k) {
          EXPECT_EQ(seen.side_kinds(item, k), right.side_kinds(item, k));
        }
      }
    }
    const DisplayFile sorted = views.view(seen_from(eye));
    EXPECT_GT(sorted.sorted()->counts.cuts, 0u);
    expect_same_lengths(sorted, there.display_file());
  }
}

/// Two cubes on each other, whose common face is cut along the same diagonal in both: four
/// triangles share it, two by two on each other, and none of them bends.
TEST(LineKinds, TheDiagonalOfFacesThatTouchIsNoCrease) {
  const GraphicsSystem g = test::drawn_with("crease", [](GraphicsSystem& system) {
    for (const bool upper : {false, true}) {
      const auto corner = [&](double x, double y) { return Point3(x, y, 0.0); };
      const std::array<Point3, 4> p{corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
      if (upper) {
        system.polygon_abs_3({p[0], p[1], p[2]});
        system.polygon_abs_3({p[0], p[2], p[3]});
      } else {
        system.polygon_abs_3({p[0], p[2], p[1]});
        system.polygon_abs_3({p[0], p[3], p[2]});
      }
      const double z = upper ? -1.0 : 1.0;
      for (std::size_t k = 0; k < 4; ++k) {
        const Point3 &from = p[k], &to = p[(k + 1) % 4];
        system.polygon_abs_3({from, to, to + Point3(0, 0, z), from + Point3(0, 0, z)});
      }
    }
  });
  const Sides sides = test::sides_in_view(*g.retained(), Eye::at({4, 3, 5}));
  EXPECT_EQ(sides.count({{-1, -1, 0}, {1, 1, 0}}), 0u);
  EXPECT_EQ(sides.count({{-1, -1, 0}, {1, -1, 0}}), 1u);
}

}  // namespace
}  // namespace displayfile
