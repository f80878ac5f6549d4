#include "displayfile/graphics_system.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "displayfile/segments/display_file.h"
#include "displayfile/user_routines/system_inside.h"
#include "tests/error_of.h"
#include "tests/listing.h"
#include "tests/order_of_entry.h"
#include "tests/unit_square.h"

namespace displayfile {
namespace {

using test::expect_error;
using test::listing;
using test::unit_square;
using test::unit_square_without_lines;

TEST(GraphicsSystem, EntersPolygonsWithStylesAndPickIdentifiers) {
  GraphicsSystem g = unit_square();
  g.set_fill_style({FillStyle::Kind::solid, {1, 0.5, 0}});
  g.set_line_style({LineStyle::Kind::none});
  g.open_segment(7);
  g.polygon_abs_3({{0, 0, 0.5}, {1, 0, 0.5}, {0, 1, 0.25}});
  g.polygon_abs_3({{0, 0, 0.5}, {0.5, 0, 0.5}, {0, 0.5, 0.5}, {0.25, 0.125, 0.5}});
  g.close_segment();
  EXPECT_EQ(listing(g, 7),
            "fill 1 0.5 0;none;pick 0;polygon 3;0 0 0.5;1 0 0.5;0 1 0.25;"
            "pick 1;polygon 4;0 0 0.5;0.5 0 0.5;0 0.5 0.5;0.25 0.125 0.5;");
}

TEST(GraphicsSystem, PickIdentifiersCountPolygonCallsOverAllSegments) {
  GraphicsSystem g = unit_square_without_lines();
  const auto small = [&] { g.polygon_abs_2({{0, 0}, {1, 0}, {0, 1}}); };
  g.open_segment(1);
  small();
  g.polygon_abs_2({{5, 5}, {6, 5}, {5, 6}});  // clipped away, but called
  g.close_segment();
  g.open_segment(2);
  small();
  g.set_pick_id(40);
  small();
  small();
  g.set_pick_id(-1);
  small();
  g.close_segment();
  EXPECT_NE(listing(g, 2).find("pick 2;polygon"), std::string::npos);
  EXPECT_NE(listing(g, 2).find("pick 40;polygon 3;0 0 0;1 0 0;0 1 0;polygon"), std::string::npos);
  EXPECT_NE(listing(g, 2).find("pick 5;polygon"), std::string::npos);
}

TEST(GraphicsSystem, AbsoluteAndRelativeAreTheSame) {
  GraphicsSystem a = unit_square(), r = unit_square();
  a.open_segment(1);
  r.open_segment(1);
  a.move_abs_3(0.25, 0.25, 0.5);
  r.move_abs_3(0.125, 0, 0);
  r.move_rel_3(0.125, 0.25, 0.5);
  a.line_abs_3(0.5, 0.25, 0.75);
  r.line_rel_3(0.25, 0, 0.25);
  a.polygon_abs_3({{0.5, 0.5, 0.75}, {1, 0.5, 0.75}, {1, 1, 0.75}});
  r.polygon_rel_3({{0, 0.25, 0}, {0.5, 0, 0}, {0, 0.5, 0}});
  a.line_abs_2(0.5, 0.5);  // from the polygon's last vertex, at its z
  r.line_rel_2(-0.5, -0.5);
  a.move_abs_2(0.125, 0.125);
  r.move_rel_2(-0.375, -0.375);
  a.polygon_abs_2({{0.5, 0}, {1, 0}, {1, 0.5}});
  r.polygon_rel_2({{0.375, -0.125}, {0.5, 0}, {0, 0.5}});
  a.close_segment();
  r.close_segment();
  EXPECT_EQ(listing(a, 1), listing(r, 1));
  EXPECT_NE(listing(a, 1).find("line 0.5 0.5 0.75"), std::string::npos);
}

TEST(GraphicsSystem, ZIsStoredOnlyWhereItIsNeeded) {
  GraphicsSystem g;
  g.open_segment(1);
  for (int i = 0; i < 100; ++i) g.polygon_abs_2({{0, 0}, {0.5, 0}, {0, 0.5}});
  EXPECT_FALSE(g.display_file().segment(1).stores_z());
  const std::string flat = listing(g, 1);
  g.line_abs_3(0, 0, 0.5);
  EXPECT_TRUE(g.display_file().segment(1).stores_z());
  EXPECT_EQ(listing(g, 1).substr(0, flat.size()), flat);
}

/// With the points as entered, which are used to find touching polygons.
TEST(GraphicsSystem, AtMost200BytesATriangle) {
  GraphicsSystem g;
  g.set_light({1, 2, 3});
  g.open_segment(1);
  for (int i = 0; i < 1000; ++i) {
    g.polygon_abs_3({{-0.9, -0.9, i * 1e-3}, {0.9, -0.8, 0}, {0, 0.8, 0.1}});
  }
  g.close_segment();
  EXPECT_EQ(g.display_file().polygons(), 1000u);
  EXPECT_LE(g.display_file().bytes(), 200u * 1000u);
}

TEST(GraphicsSystem, IdentifiersThatAreOrdinalsTakeNoBytes) {
  const auto bytes = [](int polygons) {
    GraphicsSystem g;
    g.open_segment(1);
    for (int i = 0; i < polygons; ++i) {
      g.polygon_abs_3({{-0.9, -0.9, 1e-3}, {0.9, -0.8, 0}, {0, 0.8, 0.1}});
    }
    return g.display_file().bytes();
  };
  const std::size_t viewed = 3 * sizeof(Point3) + 4 * sizeof(std::int32_t);
  const std::size_t entered = 3 * sizeof(Point3) + sizeof(std::uint32_t);
  EXPECT_EQ(bytes(300) - bytes(100), 200u * (viewed + entered));
}

/// The pick identifiers that a walk visits.
struct Picks {
  std::vector<std::int32_t> of_polygons;
  std::size_t told = 0;
  std::optional<std::int32_t> pick_id;
  std::vector<double> of_vertices;

  void fill(const FillStyle&) {}
  void line_style(const LineStyle&) {}
  void pick(std::int32_t id) {
    EXPECT_NE(pick_id, id) << "told again";
    EXPECT_TRUE(of_vertices.empty()) << "told between a polygon and its intensities";
    pick_id = id;
    ++told;
  }
  void intensities(std::span<const double> values) {
    of_vertices.assign(values.begin(), values.end());
  }
  void move(const Point3&) {}
  void line(const Point3&) {}
  void polygon(std::span<const Point3>, std::span<const std::int32_t>) {
    of_polygons.push_back(pick_id.value_or(-1));
    of_vertices.clear();
  }
};

TEST(Instructions, EveryPolygonHasTheIdentifierThatWasSet) {
  std::mt19937 random(7);
  const std::vector<Point3> triangle{{0, 0, 0}, {1, 0, 0.5}, {0, 1, 0}};
  const std::vector<std::uint8_t> visible{1, 1, 1};
  const std::vector<double> intensities{0.1, 0.2, 0.3};
  constexpr auto kLast = std::numeric_limits<std::int32_t>::max();
  for (int trial = 0; trial < 200; ++trial) {
    Instructions instructions;
    std::vector<std::int32_t> set;
    std::int32_t id = trial % 2 == 0 ? 0 : kLast - 5;
    for (int i = 0; i < 40; ++i) {
      switch (random() % 6) {
        case 0: break;  // the same again
        case 1: id = static_cast<std::int32_t>(random() % 4); break;
        case 2: instructions.enter_line(triangle[0], triangle[1]); break;
        default: id = id == kLast ? 0 : id + 1;
      }
      instructions.set_pick(id);
      const bool shaded = random() % 3 == 0;
      instructions.enter_polygon(
          triangle, visible, shaded ? VertexShading{.intensities = intensities} : VertexShading());
      set.push_back(id);
    }
    Picks walked;
    instructions.walk(walked);
    EXPECT_EQ(walked.of_polygons, set);
    Picks in_order;
    in_order_of_entry(instructions)->walk(in_order);
    EXPECT_EQ(in_order.of_polygons, set);
    EXPECT_EQ(in_order.told, walked.told);
  }
}

TEST(GraphicsSystem, BackFaceRemovalAloneAndWithHiddenLines) {
  const auto polygons = [](const std::function<void(GraphicsSystem&)>& set) {
    GraphicsSystem g;
    set(g);
    g.open_segment(1);
    g.polygon_abs_3({{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}});  // light face to the viewer
    g.polygon_abs_3({{0, 0, 0}, {0, 0.5, 0}, {0.5, 0, 0}});
    g.close_segment();
    return g.display_file().polygons();
  };
  EXPECT_EQ(polygons([](auto&) {}), 2u);
  EXPECT_EQ(polygons([](auto& g) { g.set_back_face_removal(true); }), 1u);
  EXPECT_EQ(polygons([](auto& g) { g.set_hidden_surfaces({.removal = true}); }), 1u);
  EXPECT_EQ(polygons([](auto& g) {
              g.set_hidden_surfaces({.removal = true});
              g.set_back_face_removal(false);
            }),
            2u);
}

TEST(GraphicsSystem, LightShadesTheSideThatIsSeen) {
  GraphicsSystem g = unit_square();
  g.set_fill_style({FillStyle::Kind::solid, {1, 1, 1}});
  g.set_line_style({LineStyle::Kind::none});
  g.set_light({0, 0, 2}, 0.25);
  g.open_segment(1);
  g.polygon_abs_3({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});               // faces the light
  g.polygon_abs_3({{0, 0, 0}, {0, 1, 0}, {1, 0, 0}});               // its dark face: the same
  g.polygon_abs_3({{0.25, 0, 0}, {0.25, 0.5, 0}, {0.5, 0, 0.25}});  // at 45 degrees
  g.set_light({0, 0, -1}, 0.25);
  g.polygon_abs_3({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});  // the light is behind it
  g.close_segment();
  const std::string text = listing(g, 1);
  EXPECT_EQ(text.find("fill 1 1 1;"), 0u);
  EXPECT_NE(text.find("pick 1;polygon"), std::string::npos);  // no new fill for the dark face
  EXPECT_NE(text.find("fill 0.78033 0.78033 0.78033;"), std::string::npos) << text;
  EXPECT_NE(text.find("fill 0.25 0.25 0.25;"), std::string::npos);
}

TEST(GraphicsSystem, PolygonThatIsNotFlatIsTriangulatedAndCounted) {
  GraphicsSystem g = unit_square_without_lines();
  g.open_segment(1);
  g.polygon_abs_3({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5}, {0, 1, 0}});
  g.close_segment();
  EXPECT_EQ(g.display_file().polygons(), 2u);
  EXPECT_EQ(g.counts().triangulated, 1);
  EXPECT_EQ(g.counts().polygons, 1);  // one polygon, one pick identifier
  EXPECT_EQ(listing(g, 1).find("pick 1"), std::string::npos);
}

TEST(GraphicsSystem, SegmentsAreEditedWithoutTouchingOthers) {
  GraphicsSystem g = unit_square();
  for (int name : {3, 1, 2}) {
    g.open_segment(name);
    g.move_abs_2(0, 0);
    g.line_abs_2(1.0 / name, 1);
    g.close_segment();
  }
  const std::string two = listing(g, 2);
  g.rename_segment(3, 9);
  g.delete_segment(1);
  g.set_visibility(9, false);
  EXPECT_EQ(listing(g, 2), two);
  ASSERT_EQ(g.display_file().segments().size(), 2u);
  EXPECT_EQ(g.display_file().segments()[0].name(), 9);  // order of creation
  EXPECT_FALSE(g.display_file().segments()[0].visible);
  g.open_segment(1);  // the name is free again
  g.close_segment();
  g.delete_all_segments();
  EXPECT_TRUE(g.display_file().segments().empty());
}

/// The textbook's errors; after each the system is as it was.
TEST(GraphicsSystem, ErrorsLeaveEverythingAsItWas) {
  GraphicsSystem g = unit_square();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  expect_error([&] { g.close_segment(); }, "no segment open");
  expect_error([&] { g.move_abs_3(0, 0, 0); }, "no segment open");
  expect_error([&] { g.line_abs_2(0, 0); }, "no segment open");
  expect_error([&] { g.polygon_abs_3({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}); }, "no segment open");
  expect_error([&] { g.open_segment(0); }, "invalid segment name");
  expect_error([&] { g.delete_segment(5); }, "no segment named 5");
  expect_error([&] { g.set_visibility(5, true); }, "no segment named 5");
  expect_error([&] { g.set_segment_title(5, "a"); }, "no segment named 5");
  expect_error([&] { g.set_segment_title(1, "a\n"); }, "U+000A");
  expect_error([&] { g.set_segment_title(1, "\xff"); }, "expected UTF-8");
  expect_error([&] { g.set_segment_title(1, std::string(65536, 'a')); }, "at most 65535");
  expect_error([&] { g.set_image_scale(5, 1, 1); }, "no segment named 5");
  expect_error([&] { g.set_image_centre(5, 1, 1); }, "no segment named 5");
  g.open_segment(1);
  g.polygon_abs_3({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  g.move_abs_3(0.5, 0.5, 0);
  const std::string before = listing(g, 1);
  expect_error([&] { g.open_segment(2); }, "segment already open");
  expect_error([&] { g.delete_segment(1); }, "still open");
  expect_error([&] { g.delete_all_segments(); }, "still open");
  expect_error([&] { g.rename_segment(1, 2); }, "still open");
  expect_error([&] { g.set_window(0, 1, 0, 1); }, "segment 1 is open");
  expect_error([&] { g.polygon_abs_3({{0, 0, 0}, {1, 0, 0}}); }, "polygon of 2 sides");
  expect_error([&] { g.polygon_abs_2({}); }, "polygon of 0 sides");
  expect_error([&] { g.polygon_abs_3({{0, 0, 0}, {1, 0, nan}, {0, 1, 0}}); }, "finite");
  expect_error([&] { g.line_abs_3(inf, 0, 0); }, "finite");
  expect_error([&] { g.line_rel_3(1e101, 0, 0); }, "magnitude at most 1e100");
  expect_error([&] { g.scale_3(nan, 1, 1); }, "scale");
  expect_error([&] { g.rotate_x_3(inf); }, "angle");
  expect_error([&] { g.set_fill_style({FillStyle::Kind::solid, {0, 2, 0}}); }, "colour");
  expect_error([&] { g.set_line_style({LineStyle::Kind::solid, {0, 0, 0}, 0.0}); }, "width");
  expect_error([&] { g.set_light({0, 0, 0}); }, "light direction is zero");
  expect_error([&] { g.set_light({0, 0, 1}, 1.5); }, "ambient");
  expect_error([&] { g.set_pick_id(-2); }, "pick identifier");
  EXPECT_EQ(listing(g, 1), before);
  EXPECT_EQ(g.counts().polygons, 1);
  EXPECT_EQ(g.open_segment_name(), 1);
  g.line_abs_3(0.75, 0.5, 0);  // from where the pen was before the errors
  EXPECT_EQ(listing(g, 1), before + "move 0.5 0.5 0;line 0.75 0.5 0;");
  g.close_segment();
  expect_error([&] { g.open_segment(1); }, "segment name 1 in use");
  g.open_segment(2);
  g.close_segment();
  expect_error([&] { g.rename_segment(1, 2); }, "segment name 2 in use");
  expect_error([&] { g.set_view_plane_normal({0, 0, 0}); }, "view plane normal is zero");
  expect_error([&] { g.set_view_depth(3, 2); }, "front plane behind back plane");
  expect_error([&] { g.set_window(0, 0, 0, 1); }, "window has no area");
  g.set_view_up({0, 0, 1});
  expect_error([&] { g.open_segment(3); }, "view up along the view plane normal");
  EXPECT_FALSE(g.open_segment_name());
  EXPECT_FALSE(g.display_file().contains(3));
  g.set_view_up({0, 1, 0});
  g.set_perspective({0, 0, -2});
  expect_error([&] { g.open_segment(3); }, "centre of projection on the wrong side");
  g.set_parallel({0, 0, 1});
  g.open_segment(3);
}

/// A point that lies outside of the view volume is noticed, whichever routine enters it.
TEST(GraphicsSystem, KnowsWhetherAllIsInView) {
  const auto is_all_in_view = [](const std::function<void(GraphicsSystem&)>& enter) {
    GraphicsSystem g;
    g.open_segment(1);
    g.polygon_abs_3({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}});  // up to the window's sides
    enter(g);
    g.close_segment();
    return SystemInside::is_all_in_view(g);
  };
  const std::vector<double> heights(4, 0.0);
  const std::vector<std::function<void(GraphicsSystem&, double)>> routines{
      [](GraphicsSystem& g, double x) {
        g.polygon_abs_3({{0, 0, 0}, {x, 0, 0}, {0, 1, 0}});
      },
      [](GraphicsSystem& g, double x) {
        g.polygon_abs_3({{x, 0, 0}, {x, 1, 0}, {x + 0.5, 1, 0}});
      },
      [](GraphicsSystem& g, double x) {
        g.move_abs_2(0, 0);
        g.line_abs_2(x, 0);
      },
      [](GraphicsSystem& g, double x) {
        g.move_abs_2(x, 0);
        g.text("a");
      },
      [](GraphicsSystem& g, double x) {
        box_3(g, {0, 0, 0}, {x, 1, 1});
      },
      [&](GraphicsSystem& g, double x) {
        g.surface_3({0, x, 2, 0, 1, 2, heights});
      }};
  for (std::size_t k = 0; k < routines.size(); ++k) {
    EXPECT_TRUE(is_all_in_view([&](GraphicsSystem& g) { routines[k](g, 0.5); })) << k;
    EXPECT_FALSE(is_all_in_view([&](GraphicsSystem& g) { routines[k](g, 1.25); })) << k;
  }
  // Contents whose test needs more than a look at each point may lie outside.
  EXPECT_FALSE(is_all_in_view([](GraphicsSystem& g) { g.annotate(Title{"a"}); }));
  GraphicsSystem selected;
  selected.set_hidden_surfaces({.lines = line_selection("outline")});
  selected.open_segment(1);
  selected.close_segment();
  EXPECT_FALSE(SystemInside::is_all_in_view(selected));
}

TEST(GraphicsSystem, LineStyleNoneDrawsNoLines) {
  GraphicsSystem g = unit_square_without_lines();
  g.open_segment(1);
  g.line_abs_2(1, 1);
  g.close_segment();
  EXPECT_EQ(g.display_file().segment(1).lines(), 0u);
}

}  // namespace
}  // namespace displayfile
