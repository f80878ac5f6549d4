#include "displayfile/graphics_system.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <optional>
#include <random>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "clip/error.h"
#include "displayfile/retained_views.h"
#include "displayfile/text/dump.h"
#include "tests/order_of_entry.h"

namespace displayfile {
namespace {

/// Instructions as short text, to hold against what the application called.
struct Listing {
  std::ostringstream out;
  void fill(const FillStyle& s) {
    if (s.kind == FillStyle::Kind::hollow) {
      out << "hollow;";
    } else {
      out << "fill " << s.colour.r << ' ' << s.colour.g << ' ' << s.colour.b << ';';
    }
  }
  void line_style(const LineStyle& s) {
    out << (s.kind == LineStyle::Kind::none    ? "none;"
            : s.kind == LineStyle::Kind::solid ? "solid;"
                                               : "dashed;");
  }
  void pick(int id) { out << "pick " << id << ';'; }
  void point(const Point3& p) { out << p.x << ' ' << p.y << ' ' << p.z << ';'; }
  void move(const Point3& p) {
    out << "move ";
    point(p);
  }
  void line(const Point3& p) {
    out << "line ";
    point(p);
  }
  void polygon(std::span<const Point3> vertices, std::span<const std::int32_t>) {
    out << "polygon " << vertices.size() << ';';
    for (const Point3& p : vertices) point(p);
  }
};

std::string listing(const GraphicsSystem& g, int name) {
  Listing l;
  g.display_file().segment(name).walk_drawn(l);
  return l.out.str();
}

/// A system whose display coordinates are its world coordinates.
GraphicsSystem unit_square() {
  GraphicsSystem g;
  g.set_window(0, 1, 0, 1);
  g.set_view_depth(-1, 0);
  return g;
}

void expect_error(const std::function<void()>& call, const std::string& words) {
  try {
    call();
    ADD_FAILURE() << "expected an error: " << words;
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
  }
}

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
  GraphicsSystem g = unit_square();
  g.set_line_style({LineStyle::Kind::none});
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

TEST(GraphicsSystem, ModellingTransformationsActInTheOrderOfTheCalls) {
  GraphicsSystem g = unit_square();
  g.open_segment(1);
  g.translate_3(0.5, 0, 0);
  g.rotate_z_3(90);  // turns the moved point about the origin, exactly
  g.move_abs_3(0, 0, 0);
  g.create_transformation_3();
  g.line_abs_3(0.25, 0.25, 0);
  g.scale_3(2, 4, 1);
  g.line_abs_3(0.25, 0.25, 0);
  g.close_segment();
  EXPECT_EQ(listing(g, 1), "solid;move 0 0.5 0;line 0.25 0.25 0;line 0.5 1 0;");
}

TEST(GraphicsSystem, ImageTransformationScalesThenRotatesThenTranslates) {
  GraphicsSystem g = unit_square();
  g.open_segment(1);
  g.move_abs_2(0, 0);
  g.line_abs_2(0.5, 0.25);
  g.close_segment();
  g.set_image_translation(1, 0.5, 0.125);
  g.set_image_rotation(1, 90);
  g.set_image_scale(1, 2, 1);
  EXPECT_EQ(listing(g, 1), "solid;move 0.5 0.125 0;line 0.25 1.125 0;");
}

/// The centre stays where it is, whatever the scale and the rotation; unset, or of no effect, it
/// changes no bit.
TEST(GraphicsSystem, ImageTransformationAboutACentreOfItsOwn) {
  const auto drawn = [](const std::function<void(GraphicsSystem&)>& set) {
    GraphicsSystem g = unit_square();
    g.open_segment(1);
    g.move_abs_2(0.5, 0.25);
    g.line_abs_2(0.75, 0.375);
    g.close_segment();
    set(g);
    return listing(g, 1);
  };
  EXPECT_EQ(drawn([](GraphicsSystem& g) {
              g.set_image_centre(1, 0.5, 0.25);
              g.set_image_rotation(1, 90);
              g.set_image_scale(1, 2, 1);
            }),
            "solid;move 0.5 0.25 0;line 0.375 0.75 0;");
  EXPECT_EQ(drawn([](GraphicsSystem& g) {
              g.set_image_rotation(1, 180);
              g.set_image_translation(1, 0.125, 0);
              g.set_image_centre(1, 0.5, 0.25);
            }),
            "solid;move 0.625 0.25 0;line 0.375 0.125 0;");
  const auto plain = drawn([](GraphicsSystem&) {});
  EXPECT_EQ(drawn([](GraphicsSystem& g) { g.set_image_centre(1, 0.3, 0.7); }), plain);
  EXPECT_EQ(drawn([](GraphicsSystem& g) {
              g.set_image_rotation(1, 17);
              g.set_image_centre(1, 0, 0);
            }),
            drawn([](GraphicsSystem& g) { g.set_image_rotation(1, 17); }));
  drawn([](GraphicsSystem& g) {
    for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), 1.1e9, -1e300}) {
      expect_error([&] { g.set_image_centre(1, wrong, 0); }, "image centre is");
      expect_error([&] { g.set_image_centre(1, 0, wrong); }, "at most 1e9");
    }
    EXPECT_EQ(g.display_file().segment(1).image, ImageTransformation{});
  });
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

TEST(GraphicsSystem, AtMost160BytesATriangle) {
  GraphicsSystem g;
  g.set_light({1, 2, 3});
  g.open_segment(1);
  for (int i = 0; i < 1000; ++i) {
    g.polygon_abs_3({{-0.9, -0.9, i * 1e-3}, {0.9, -0.8, 0}, {0, 0.8, 0.1}});
  }
  g.close_segment();
  EXPECT_EQ(g.display_file().polygons(), 1000u);
  EXPECT_LE(g.display_file().bytes(), 160u * 1000u);
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
  EXPECT_EQ(bytes(300) - bytes(100), 200u * (3 * sizeof(Point3) + 4 * sizeof(std::int32_t)));
}

/// What a walk tells of pick identifiers.
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
      instructions.enter_polygon(triangle, visible, shaded ? intensities : std::vector<double>());
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
  EXPECT_EQ(polygons([](auto& g) { g.set_hidden_line_removal(true); }), 1u);
  EXPECT_EQ(polygons([](auto& g) {
              g.set_hidden_line_removal(true);
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
  GraphicsSystem g = unit_square();
  g.set_line_style({LineStyle::Kind::none});
  g.open_segment(1);
  g.polygon_abs_3({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5}, {0, 1, 0}});
  g.close_segment();
  EXPECT_EQ(g.display_file().polygons(), 2u);
  EXPECT_EQ(g.polygons_triangulated(), 1);
  EXPECT_EQ(g.polygons_entered(), 1);  // one polygon, one pick identifier
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
  EXPECT_EQ(g.polygons_entered(), 1);
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

/// What is saved acts last: an arm is written from the outside in.
/// A point is told where a line that goes there ends, to the bit.
TEST(GraphicsSystem, ToDeviceIsWhereThingsAreDrawn) {
  const auto expect_same = [](GraphicsSystem& g) {
    const Point3 joint(0.125, -0.25, 0.5);
    const std::optional<Point3> before = g.to_device(joint);
    g.open_segment(1);
    EXPECT_EQ(g.to_device(joint), before);
    g.move_abs_3(0, 0, 0);
    g.line_abs_3(joint.x, joint.y, joint.z);
    g.close_segment();
    EXPECT_EQ(g.display_file().segment(1).entered()->stored_points().back(), before);
  };
  GraphicsSystem parallel;
  parallel.rotate_z_3(33);
  parallel.translate_3(0.1, 0.2, -0.1);
  expect_same(parallel);

  GraphicsSystem perspective;
  perspective.set_perspective({0.3, 0.2, 4});
  perspective.set_window(-1, 1, -2, 1);
  perspective.set_window_fit(WindowFit::widen);
  perspective.set_viewport(0.25, 0.75, 0, 1);
  perspective.set_aspect_ratio(1.5);
  perspective.rotate_x_3(-20);
  expect_same(perspective);
  EXPECT_FALSE(perspective.to_device({0, -10, 20})) << "behind the eye";
  perspective.create_transformation_3();
  EXPECT_FALSE(perspective.to_device({0.3, 0.2, 4})) << "the eye";
  const std::optional<Point3> outside = perspective.to_device({100, 0, 0});
  ASSERT_TRUE(outside);
  EXPECT_GT(outside->x, 1.0);
  expect_error([&] { perspective.to_device({0, 0, 1e300}); }, "coordinates 0 0 1e+300");
  perspective.set_perspective({0, 0, -4});
  expect_error([&] { perspective.to_device({0, 0, 0}); }, "centre of projection");
}

TEST(GraphicsSystem, WhatIsSavedActsOnAllThatIsCalledUntilItIsRestored) {
  GraphicsSystem g = unit_square();
  g.open_segment(1);
  g.rotate_z_3(90);
  g.translate_3(0.5, 0.25, 0);
  g.move_abs_3(0, 0, 0);
  g.save_transformation_3();
  g.line_abs_3(0.125, 0, 0);  // as before
  g.translate_3(0.25, 0, 0);  // along the arm, which stands upright
  g.line_abs_3(0, 0, 0);
  g.save_transformation_3();
  g.rotate_z_3(90);
  g.translate_3(0.125, 0, 0);
  g.line_abs_3(0.125, 0, 0);
  g.create_transformation_3();  // anew in the coordinates saved last
  g.line_abs_3(0, 0, 0);
  g.restore_transformation_3();
  g.line_abs_3(0.0625, 0, 0);
  g.restore_transformation_3();
  g.line_abs_3(0, 0, 0);
  g.create_transformation_3();
  g.line_abs_3(1, 1, 0);
  g.close_segment();
  EXPECT_EQ(listing(g, 1),
            "solid;move 0.5 0.25 0;line 0.5 0.375 0;line 0.5 0.5 0;line 0.375 0.625 0;"
            "line 0.5 0.5 0;line 0.5 0.5625 0;line 0.5 0.25 0;line 1 1 0;");
}

/// What is restored is what was saved to the bit, normals of vertices go the same way, and a
/// refused call changes nothing.
TEST(GraphicsSystem, SavedTransformations) {
  const auto draw = [](GraphicsSystem& g) {
    g.set_vertex_normals({{0, 0, 1}, {1, 2, 3}, {0, 1, 1}});
    g.polygon_abs_3({{0.1, 0.1, 0.3}, {0.3, 0.1, 0.1}, {0.1, 0.3, 0.2}});
  };
  const auto start = [](GraphicsSystem& g) {
    g.set_light({1, 2, 3});
    g.set_shading(Shading::gouraud);
    g.open_segment(1);
  };
  GraphicsSystem plain, nested;
  start(plain);
  start(nested);
  plain.rotate_x_3(33);
  plain.scale_3(0.7, 0.8, -0.9);
  plain.rotate_y_3(21);
  draw(plain);
  nested.rotate_y_3(21);
  nested.save_transformation_3();
  nested.scale_3(0.7, 0.8, -0.9);
  nested.save_transformation_3();
  nested.rotate_x_3(33);
  draw(nested);
  plain.close_segment();
  nested.close_segment();
  const auto values = [](const GraphicsSystem& g) {
    std::vector<double> all;
    for (const Point3& p : g.display_file().segment(1).entered()->stored_points()) {
      all.insert(all.end(), {p.x, p.y, p.z});
    }
    const auto intensities = g.display_file().segment(1).entered()->stored_intensities();
    all.insert(all.end(), intensities.begin(), intensities.end());
    return all;
  };
  const auto of_plain = values(plain), of_nested = values(nested);
  ASSERT_EQ(of_plain.size(), 12u);
  ASSERT_EQ(of_nested.size(), 12u);
  for (std::size_t i = 0; i < 12; ++i) EXPECT_NEAR(of_plain[i], of_nested[i], 1e-15);

  GraphicsSystem g = unit_square();
  expect_error([&] { g.restore_transformation_3(); }, "no transformation saved");
  g.rotate_z_3(10);
  g.translate_3(0.3, 0.2, 0.1);
  for (std::size_t i = 0; i < GraphicsSystem::kMostSaved; ++i) g.save_transformation_3();
  expect_error([&] { g.save_transformation_3(); }, "1024 transformations are saved");
  EXPECT_EQ(g.transformations_saved(), GraphicsSystem::kMostSaved);
  g.open_segment(1);
  g.move_abs_3(0.1, 0.2, 0.3);
  g.line_abs_3(0.2, 0.2, 0.4);
  expect_error([&] { g.translate_3(std::numeric_limits<double>::quiet_NaN(), 0, 0); }, "nan");
  g.rotate_x_3(50);
  while (g.transformations_saved() > 0) g.restore_transformation_3();
  g.move_abs_3(0.1, 0.2, 0.3);
  g.line_abs_3(0.2, 0.2, 0.4);
  g.close_segment();
  const auto points = g.display_file().segment(1).entered()->stored_points();
  ASSERT_EQ(points.size(), 4u);
  EXPECT_EQ(points[0], points[2]);
  EXPECT_EQ(points[1], points[3]);
}

TEST(GraphicsSystem, OverflowInTheModellingTransformationIsAnError) {
  GraphicsSystem g = unit_square();
  g.open_segment(1);
  g.scale_3(1e60, 1, 1);
  expect_error([&] { g.move_abs_3(1e60, 0, 0); }, "out of range after the modelling");
}

TEST(GraphicsSystem, LineStyleNoneDrawsNoLines) {
  GraphicsSystem g = unit_square();
  g.set_line_style({LineStyle::Kind::none});
  g.open_segment(1);
  g.line_abs_2(1, 1);
  g.close_segment();
  EXPECT_EQ(g.display_file().segment(1).lines(), 0u);
}

// ---- Many polygons at once -------------------------------------------------------------------

/// Vertices, corners and sides of polygons that share vertices; some cross the window's sides, and
/// some are not flat.
struct SharedPolygons {
  std::vector<Point3> vertices;
  std::vector<std::uint32_t> corners, sides;

  explicit SharedPolygons(std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> grid(-8, 8);
    for (int i = 0; i < 40; ++i) {
      vertices.push_back(Point3(grid(random), grid(random), grid(random)) / 6.0);
    }
    for (int k = 0; k < 60; ++k) {
      sides.push_back(3 + static_cast<std::uint32_t>(random() % 3));
      for (std::uint32_t i = 0; i < sides.back(); ++i)
        corners.push_back(static_cast<std::uint32_t>(random() % 40));
    }
  }
  void enter_one_by_one(GraphicsSystem& g, std::span<const FillStyle> fills) const {
    std::size_t first = 0;
    for (std::size_t k = 0; k < sides.size(); ++k) {
      if (!fills.empty()) g.set_fill_style(fills[fills.size() == 1 ? 0 : k]);
      std::vector<Point3> polygon;
      for (std::size_t i = 0; i < sides[k]; ++i) polygon.push_back(vertices[corners[first++]]);
      g.polygon_abs_3(polygon);
    }
  }
};

TEST(ManyPolygons, AreEnteredAsOneByOne) {
  for (std::uint32_t seed = 0; seed < 32; ++seed) {
    const SharedPolygons polygons(seed);
    std::vector<FillStyle> fills;
    for (std::size_t k = 0; k < polygons.sides.size(); ++k) {
      fills.push_back(
          k % 7 == 0 ? FillStyle{FillStyle::Kind::hollow}
                     : FillStyle{FillStyle::Kind::solid, Colour(static_cast<double>(k % 5) / 4.0)});
    }
    if (seed % 3 == 1) fills.resize(1);
    if (seed % 3 == 2) fills.clear();
    std::string dumps[2], programs[2];
    for (const bool at_once : {false, true}) {
      std::ostringstream program;
      Recorder recorder(program);
      RetainedScene retained;
      GraphicsSystem g;
      if (seed % 2 == 0) g.set_perspective({0.5, 0.25, 3});
      if (seed % 4 < 2) g.set_light({1, 2, 3});
      if (seed % 8 == 3) g.retain(&retained);
      g.set_back_face_removal(seed % 5 == 0);
      g.rotate_y_3(10.0 * seed);
      g.open_segment(1);
      if (at_once) g.set_recorder(&recorder);
      if (at_once) {
        g.polygons_abs_3(polygons.vertices, polygons.corners, polygons.sides, fills);
      } else {
        polygons.enter_one_by_one(g, fills);
        if (!fills.empty()) g.set_fill_style({});
      }
      g.line_rel_3(0.1, 0.2, 0.3);
      g.polygon_abs_3({{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}});
      g.close_segment();
      dumps[at_once] = dump(g.display_file());
      if (seed % 8 == 3) {
        dumps[at_once] += dump(RetainedViews(retained, g.display_file(), {}).view(g.view()));
      }
    }
    EXPECT_EQ(dumps[0], dumps[1]) << "seed " << seed;
  }
}

/// Two segments of polygons with shared vertices, one with own, and a line in each; retained.
struct RetainedPolygons {
  RetainedScene scene;
  GraphicsSystem system;

  explicit RetainedPolygons(bool at_once) {
    system.retain(&scene);
    system.set_light({1, 2, 3});
    for (const int name : {3, 1, 2}) {
      const SharedPolygons polygons(static_cast<std::uint32_t>(name));
      system.open_segment(name);
      system.line_rel_3(0.1, 0.2, 0.3);
      if (at_once && name != 1) {
        system.polygons_abs_3(polygons.vertices, polygons.corners, polygons.sides);
      } else {
        polygons.enter_one_by_one(system, {});
      }
      system.line_rel_3(-0.1, 0.1, 0.1);
      system.close_segment();
    }
  }
  std::string views() const {
    RetainedViews drawn(scene, system.display_file(), {});
    std::string text;
    View view = system.view();
    for (const Point3& eye : {Point3(0.5, 0.25, 3), Point3(-2, 1, 2), Point3(0, 0.5, 4)}) {
      view.set_perspective(eye);
      text += dump(drawn.view(view));
    }
    return text;
  }
};

TEST(ManyPolygons, AreRetainedWithTheirVerticesShared) {
  RetainedPolygons shared(true), own(false);
  const auto points = [](const RetainedPolygons& of, std::size_t segment) {
    return of.scene.points(of.scene.segments()[segment]).size();
  };
  EXPECT_LT(points(shared, 0), points(own, 0));
  EXPECT_EQ(points(shared, 1), points(own, 1));
  EXPECT_LT(points(shared, 2), points(own, 2));
  EXPECT_EQ(shared.views(), own.views());
  for (RetainedPolygons* of : {&shared, &own}) {
    of->system.delete_segment(3);
    of->system.set_visibility(1, false);
  }
  EXPECT_LT(points(shared, 1), points(own, 1));
  EXPECT_EQ(shared.views(), own.views());
}

TEST(ManyPolygons, OnlyVerticesInUseAreRetained) {
  RetainedScene scene;
  GraphicsSystem g;
  g.retain(&scene);
  g.open_segment(1);
  const std::vector<Point3> vertices{{9, 9, 9}, {0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}, {-9, 9, 9}};
  g.polygons_abs_3(vertices, std::vector<std::uint32_t>{3, 1, 2, 2, 3, 1});
  g.close_segment();
  const auto kept = scene.points(scene.segments()[0]);
  EXPECT_EQ(std::vector<Point3>(kept.begin(), kept.end()),
            (std::vector<Point3>{vertices[3], vertices[1], vertices[2]}));
}

TEST(ManyPolygons, ErrorsEnterNothing) {
  GraphicsSystem g;
  g.set_viewport(0, 1, 0, 1);
  const std::vector<Point3> vertices{{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}};
  using Indices = std::vector<std::uint32_t>;
  const Indices corners{0, 1, 2, 1, 2, 3};
  expect_error([&] { g.polygons_abs_3(vertices, corners); }, "no segment open");
  g.open_segment(1);
  expect_error([&] { g.polygons_abs_3(vertices, Indices{0, 1, 2, 3, 0, 4}); }, "vertex 4 of 4");
  expect_error([&] { g.polygons_abs_3(vertices, Indices{0, 1}); }, "2 corners");
  expect_error([&] { g.polygons_abs_3(vertices, corners, Indices{4, 2}); }, "polygon of 2 sides");
  expect_error(
      [&] {
        g.polygons_abs_3(vertices, corners, Indices{3, 4});
      },
      "6 corners: expected 7");
  const std::vector<FillStyle> three(3), outside{FillStyle{FillStyle::Kind::solid, {2, 0, 0}}};
  expect_error([&] { g.polygons_abs_3(vertices, corners, {}, three); }, "3 fill styles");
  expect_error([&] { g.polygons_abs_3(vertices, corners, {}, outside); }, "colour component");
  std::vector<Point3> far = vertices;
  far.back().x = std::numeric_limits<double>::infinity();
  expect_error([&] { g.polygons_abs_3(far, corners); }, "coordinates inf");
  EXPECT_EQ(g.display_file().polygons(), 0u);
  EXPECT_EQ(g.polygons_entered(), 0);
  g.polygons_abs_3(vertices, corners);
  EXPECT_EQ(g.display_file().polygons(), 2u);
  g.polygons_abs_3({}, {});
  EXPECT_EQ(g.display_file().polygons(), 2u);
}

}  // namespace
}  // namespace displayfile
