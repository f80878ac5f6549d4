// Cameras of bare meshes, and settings before a mesh.

#include "displayfile/mesh/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <sstream>

#include "clip/base/error.h"
#include "clip/view/view_volume.h"
#include "clip/view/window_fit.h"
#include "displayfile/files.h"
#include "displayfile/mesh/fitted_view.h"
#include "displayfile/segments/display_file.h"
#include "interp/draw/draw.h"
#include "tests/mesh_files.h"

namespace displayfile {
namespace {

using test::cube;

/// A ball of quadrilaterals, as a file.
std::string ball() {
  std::ostringstream text;
  constexpr int kRings = 16, kSides = 32;
  for (int i = 0; i <= kRings; ++i) {
    const double polar = std::numbers::pi * i / kRings;
    for (int k = 0; k < kSides; ++k) {
      const double turn = 2.0 * std::numbers::pi * k / kSides;
      text << "v " << 3 + std::sin(polar) * std::cos(turn) << ' ' << 2 + std::cos(polar) << ' '
           << std::sin(polar) * std::sin(turn) - 7 << '\n';
    }
  }
  for (int i = 0; i < kRings; ++i) {
    for (int k = 0; k < kSides; ++k) {
      const int a = i * kSides + k + 1, b = i * kSides + (k + 1) % kSides + 1;
      text << "f " << a << ' ' << b << ' ' << b + kSides << ' ' << a + kSides << '\n';
    }
  }
  return text.str();
}

/// A box with a notch of an outline of its own from each side; closed, light faces out. `z_up` is
/// the same, turned so that y becomes z.
std::string wedge(bool z_up) {
  std::ostringstream text;
  const auto vertex = [&](int x, int y, int z) {
    text << "v " << x << ' ' << (z_up ? -z : y) << ' ' << (z_up ? y : z) << '\n';
  };
  vertex(0, 0, 0);
  vertex(5, 0, 0);
  vertex(5, 0, 3);
  vertex(0, 0, 3);
  vertex(1, 4, 1);
  vertex(2, 4, 1);
  text << "f 1 2 3 4\nf 4 3 6 5\nf 2 1 5 6\nf 1 4 5\nf 3 2 6\n";
  return text.str();
}

class CameraTest : public test::MeshFiles {
 protected:
  Mesh mesh_of(const std::string& obj) { return read("a.obj", obj); }

  /// The picture of a mesh by a camera.
  Picture drawn(const std::string& obj, const Camera& camera, int width, int height) {
    GraphicsSystem g;
    g.set_aspect_ratio(static_cast<double>(width) / height);
    import_mesh(file("a.obj", obj), g, MeshOptions{.camera = camera});
    DrawOptions options{.samples = 1};
    options.width = width;
    options.height = height;
    options.with_ids = true;
    return draw(g, options);
  }

  struct Seen {
    int left, right, top, bottom;  ///< the first and last columns and rows
    int width() const { return right - left + 1; }
    int height() const { return bottom - top + 1; }
  };
  static Seen seen_in(const Picture& picture) {
    Seen seen{picture.width, -1, picture.height, -1};
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) {
        if (picture.ids[static_cast<std::size_t>(y * picture.width + x)] < 0) continue;
        seen = {std::min(seen.left, x), std::max(seen.right, x), std::min(seen.top, y),
                std::max(seen.bottom, y)};
      }
    }
    return seen;
  }
};

/// Cameras of all kinds that show a mesh whole.
std::vector<Camera> cameras() {
  std::vector<Camera> all(8);
  all[1].parallel = true;
  all[2].angle_of_view = 40.0;
  all[3].eye = EyeDirection{-70.0, -35.0};
  all[4].eye = EyeDirection{10.0, 90.0};
  all[5].eye = Point3(9, 8, 7);
  all[6].angle_of_view = 120.0;
  all[6].eye = EyeDirection{200.0, 45.0};
  all[7].look_at = Point3(3, 2, -7);
  return all;
}

TEST_F(CameraTest, ABallIsAsHighAsWideAndFillsThePicture) {
  for (const Camera& camera : cameras()) {
    for (const auto& [width, height] : {std::pair(160, 120), std::pair(60, 130)}) {
      const Seen seen = seen_in(drawn(ball(), camera, width, height));
      EXPECT_NEAR(seen.width(), seen.height(), 2.0);
      EXPECT_NEAR(std::max(1.0 * seen.width() / width, 1.0 * seen.height() / height), 0.9, 0.03);
      EXPECT_NEAR(seen.left + seen.right + 1, width, 2.0) << "it is in the middle";
      EXPECT_NEAR(seen.top + seen.bottom + 1, height, 2.0);
    }
  }
}

TEST_F(CameraTest, UpAxisShowsAMeshAsIfItWereTurned) {
  for (Camera camera : cameras()) {
    if (std::holds_alternative<Point3>(camera.eye) || camera.look_at) continue;
    const Picture standing = drawn(wedge(false), camera, 120, 90);
    camera.upright = upright("z");
    EXPECT_EQ(drawn(wedge(true), camera, 120, 90).ids, standing.ids);
    EXPECT_EQ(drawn(wedge(true), camera, 120, 90).pixels, standing.pixels);
  }
}

TEST_F(CameraTest, EveryUprightIsATurnOfTheFirst) {
  for (const char* axis : {"x", "y", "z", "-x", "-y", "-z"}) {
    const Upright u = upright(axis);
    EXPECT_EQ(glm::cross(u.right, u.up), u.front) << axis;
    const double sign = axis[0] == '-' ? -1.0 : 1.0;
    EXPECT_EQ(u.up[axis[sign < 0 ? 1 : 0] - 'x'], sign) << axis;
  }
  EXPECT_EQ(upright("y"), Upright{});
  EXPECT_EQ(upright("z").front, Point3(0, -1, 0));
  for (const char* axis : {"", "w", "X", "+z", "--z", "zz"}) EXPECT_THROW(upright(axis), Error);
}

/// The view that a camera has of the wedge.
View view_of(const Mesh& mesh, const Camera& camera, double aspect = 1.0) {
  GraphicsSystem g;
  g.set_aspect_ratio(aspect);
  fit_view(std::span(&mesh, 1), g, camera);
  return g.view();
}

TEST_F(CameraTest, EyeIsWhereItIsSaid) {
  const Mesh mesh = mesh_of(wedge(false));
  const auto toward = [&](double azimuth, double elevation) {
    Camera camera;
    camera.eye = EyeDirection{azimuth, elevation};
    return -view_of(mesh, camera).plane_normal;
  };
  EXPECT_EQ(toward(0, 0), Point3(0, 0, 1)) << "from the front";
  EXPECT_EQ(toward(90, 0), Point3(1, 0, 0)) << "from the right";
  EXPECT_EQ(toward(0, 90), Point3(0, 1, 0)) << "from above";
  EXPECT_EQ(toward(180, 0), Point3(0, 0, -1));
  Camera camera;
  camera.eye = Point3(20, 10, 30);
  camera.look_at = Point3(1, 2, 3);
  const View view = view_of(mesh, camera, 1.5);
  EXPECT_NEAR(glm::length(view.centre_of_projection - Point3(20, 10, 30)), 0.0, 1e-12);
  EXPECT_EQ(view.reference_point, Point3(1, 2, 3));
  EXPECT_NEAR(view.window.x_min + view.window.x_max, 0.0, 1e-12) << "it is in the middle";
  EXPECT_NEAR(view.window.y_min + view.window.y_max, 0.0, 1e-12);
  camera.eye = Point3(1, 50, 3);  // above the target
  EXPECT_EQ(view_of(mesh, camera).up, Point3(0, 0, -1));
}

TEST_F(CameraTest, AngleOfViewIsThatFromBottomToTop) {
  const Mesh mesh = mesh_of(wedge(false));
  for (const double angle : {5.0, 60.0, 150.0}) {
    for (const bool at_a_point : {false, true}) {
      for (const bool fit : {false, true}) {
        Camera camera;
        camera.angle_of_view = angle;
        camera.fit = fit;
        if (at_a_point) camera.eye = Point3(2, 2, 2);  // inside of it
        const View view = view_of(mesh, camera, 1.5);
        const double distance = glm::length(view.centre_of_projection - view.reference_point);
        EXPECT_NEAR(view.window.y_max / distance, std::tan(angle * std::numbers::pi / 360), 1e-9);
        EXPECT_NEAR(view.window.x_max / view.window.y_max, 1.5, 1e-12);
        EXPECT_EQ(view.window.y_min, -view.window.y_max);
      }
    }
  }
}

TEST_F(CameraTest, AnAngleOfViewHoldsAMeshThatTurns) {
  const Mesh mesh = mesh_of(wedge(true));
  Camera camera;
  camera.upright = upright("z");
  camera.angle_of_view = 50.0;
  camera.turning = true;
  const View turning = view_of(mesh, camera, 1.5);
  const ViewVolume volume(turning);
  const Point3 middle(2.5, -1.5, 2.0);
  double nearest_to_a_side = 1.0;
  for (double turn = 0.0; turn < 6.28; turn += 0.01) {
    for (const Point3& vertex : mesh.vertices) {
      const double x = vertex.x - middle.x, y = vertex.y - middle.y;
      const Point3 turned(middle.x + x * std::cos(turn) - y * std::sin(turn),
                          middle.y + x * std::sin(turn) + y * std::cos(turn), vertex.z);
      const Point3 p = volume.to_device(volume.transform(turned));
      for (int axis = 0; axis < 2; ++axis) {
        nearest_to_a_side = std::min({nearest_to_a_side, p[axis], 1.0 - p[axis]});
      }
    }
  }
  EXPECT_NEAR(nearest_to_a_side, 0.05, 0.01);
  camera.turning = false;
  const View still = view_of(mesh, camera, 1.5);
  EXPECT_LT(glm::length(still.centre_of_projection - still.reference_point),
            glm::length(turning.centre_of_projection - turning.reference_point));
}

TEST_F(CameraTest, WithoutFitNothingDependsOnTheMesh) {
  for (Camera camera : cameras()) {
    camera.fit = false;
    View small = view_of(mesh_of(wedge(false)), camera), large = view_of(mesh_of(ball()), camera);
    EXPECT_NE(small.back, large.back) << "but for the depth";
    large.set_depth(small.front, small.back);
    EXPECT_EQ(small, large);
  }
  Camera camera;
  camera.fit = false;
  const View view = view_of(mesh_of(ball()), camera, 2.0);
  EXPECT_EQ(view.window, (Rectangle{-2, 2, -1, 1}));
  EXPECT_EQ(view.reference_point, Point3(0.0));
}

TEST_F(CameraTest, RefusesWhatCannotBeSeen) {
  const Mesh mesh = mesh_of(wedge(false));
  const auto refused = [&](const Camera& camera) {
    GraphicsSystem g;
    EXPECT_THROW(fit_view(std::span(&mesh, 1), g, camera), Error);
    EXPECT_FALSE(g.explicit_settings().contains_view());
  };
  for (const double angle : {0.0, -10.0, 180.0, std::nan(""), HUGE_VAL}) {
    Camera camera;
    camera.angle_of_view = angle;
    refused(camera);
  }
  Camera camera;
  camera.eye = Point3(2, 2, 2);
  refused(camera);  // among the mesh, and to be fitted
  camera.look_at = Point3(2, 2, 2);
  camera.angle_of_view = 30.0;
  refused(camera);
}

// ---- Settings before a mesh ------------------------------------------------------------

/// A system in which a program was carried out and then a cube imported.
class SettingsBeforeAMesh : public CameraTest {
 protected:
  void enter(const std::string& program, GraphicsSystem& g) {
    replay(program, "program", g);
    import_mesh(file("a.obj", cube()), g);
  }
  std::string dump_after(const std::string& program) {
    GraphicsSystem g;
    enter(program, g);
    return dump(g.display_file());
  }
  /// True if the dumps are the same except for lines that begin with the word.
  static bool differ_only_in(const std::string& word, const std::string& a, const std::string& b) {
    const auto rest = [&](const std::string& text) {
      std::istringstream lines(text);
      std::string kept;
      for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with(word)) kept += line + '\n';
      }
      return kept;
    };
    return a != b && rest(a) == rest(b);
  }
};

TEST_F(SettingsBeforeAMesh, FillStyle) {
  const std::string bare = dump_after("");
  EXPECT_TRUE(differ_only_in("fill", dump_after("set-fill-style solid 1 0 0\n"), bare));
  EXPECT_TRUE(
      dump_after("set-light 0 0 1 1\nset-fill-style solid 1 0 0\n").find("fill solid 1 0 0") !=
      std::string::npos);
  EXPECT_TRUE(differ_only_in("fill", dump_after("set-fill-style hollow\n"), bare));
}

TEST_F(SettingsBeforeAMesh, Light) {
  EXPECT_TRUE(differ_only_in("fill", dump_after("set-light 1 0 0 0.5\n"), dump_after("")));
}

TEST_F(SettingsBeforeAMesh, LineStyle) {
  EXPECT_TRUE(differ_only_in("line-style", dump_after("set-line-style solid 0 0 1 2\n"),
                             dump_after("set-line-style none\n")));
  EXPECT_EQ(dump_after("set-line-style none\n"), dump_after(""));
}

TEST_F(SettingsBeforeAMesh, Shading) {
  EXPECT_TRUE(dump_after("set-shading gouraud\n").find("intensities") != std::string::npos);
}

TEST_F(SettingsBeforeAMesh, ModellingTransformationAndTheViewFitsIt) {
  for (const char* program :
       {"scale-3 2 1 1\n", "rotate-x-3 50\n", "scale-3 9 9 9\ntranslate-3 99 9 9\n"}) {
    GraphicsSystem g;
    enter(program, g);
    const Mesh mesh = mesh_of(cube());
    EXPECT_NE(dump(g.display_file()), dump_after(""));
    const ViewVolume volume(g.view());
    for (const Point3& vertex : mesh.vertices) {
      const Point3 p =
          volume.to_device(volume.transform(g.modelling_transformation().apply(vertex)));
      for (int axis = 0; axis < 3; ++axis) EXPECT_TRUE(p[axis] > 0.0 && p[axis] < 1.0) << program;
    }
  }
}

TEST_F(SettingsBeforeAMesh, HiddenSurfaces) {
  GraphicsSystem bare, off, faces, method;
  enter("", bare);
  EXPECT_TRUE(bare.hidden_surfaces().removal);
  EXPECT_EQ(bare.display_file().polygons(), 3u) << "the cube is closed";
  enter("set-hidden-line-removal off\n", off);
  EXPECT_FALSE(off.hidden_surfaces().removal);
  EXPECT_EQ(off.display_file().polygons(), 6u);
  enter("set-back-face-removal off\n", faces);
  EXPECT_TRUE(faces.hidden_surfaces().removal);
  EXPECT_EQ(faces.display_file().polygons(), 6u);
  enter("set-hidden-method bsp\n", method);
  EXPECT_TRUE(method.hidden_surfaces().removal);
  EXPECT_NE(method.display_file().segments().front().sorted(), nullptr);
}

TEST_F(SettingsBeforeAMesh, OnlyTheCameraLeavesTheRestToTheMesh) {
  GraphicsSystem g;
  enter("set-window -3 3 -3 3\nset-perspective 3 2 6\n", g);
  EXPECT_EQ(g.view().window, (Rectangle{-3, 3, -3, 3}));
  EXPECT_TRUE(g.hidden_surfaces().removal);
  EXPECT_TRUE(g.looks().attributes.light.has_value());
  EXPECT_EQ(g.display_file().polygons(), 3u);
  const std::string text = dump(g.display_file());
  EXPECT_NE(text.find("line-style none"), std::string::npos);
  EXPECT_EQ(text.find("fill solid 0.8 0.8 0.8"), std::string::npos);
}

/// A setting of the view replaces only that: the mesh is shown whole, unless the window was set.
class ViewBeforeAMesh : public SettingsBeforeAMesh {
 protected:
  View view_after(const std::string& program) {
    GraphicsSystem g;
    enter(program, g);
    EXPECT_FALSE(g.counts().stretched_window) << program;
    return g.view();
  }
  /// The distance of the vertex nearest to a side of the viewport, in parts of the viewport.
  double nearest_to_a_side(const View& view) {
    const ViewVolume volume(view);
    const Rectangle& v = view.viewport;
    double nearest = 1.0;
    for (const Point3& vertex : mesh_of(cube()).vertices) {
      const Point3 p = volume.to_device(volume.transform(vertex));
      const double x = (p.x - v.x_min) / (v.x_max - v.x_min);
      const double y = (p.y - v.y_min) / (v.y_max - v.y_min);
      nearest = std::min({nearest, x, 1.0 - x, y, 1.0 - y});
      EXPECT_TRUE(p.z > 0.0 && p.z < 1.0) << "the depth encloses it";
    }
    return nearest;
  }
};

TEST_F(ViewBeforeAMesh, ViewportDepthAndClippingStayAndTheRestIsFitted) {
  const View bare = view_after("");
  View wide = view_after("set-viewport 0 1 0.25 0.75\n");
  EXPECT_EQ(wide.viewport, (Rectangle{0, 1, 0.25, 0.75}));
  EXPECT_NEAR(shape_of(wide.window), 2.0, 1e-12);
  EXPECT_NEAR(nearest_to_a_side(wide), 0.05, 1e-9);
  wide.viewport = bare.viewport;
  wide.window = bare.window;
  EXPECT_EQ(wide, bare);
  View clipped = bare;
  clipped.front_clipping = true;
  EXPECT_EQ(view_after("set-front-plane-clipping on\n"), clipped);
  clipped.back_clipping = true;
  EXPECT_EQ(view_after("set-front-plane-clipping on\nset-back-plane-clipping on\n"), clipped);
  View deep = bare;
  deep.set_depth(-0.5, 0.25);
  EXPECT_EQ(view_after("set-view-depth -0.5 0.25\n"), deep);
}

TEST_F(ViewBeforeAMesh, OfACameraTheWindowIsFitted) {
  for (const char* program :
       {"set-perspective 3 2 6\n", "set-perspective 3 2 60\nset-view-distance 2\n",
        "set-parallel 0.3 0.2 -1\n", "set-parallel 0 0 4\n", "set-view-plane-normal -1 -2 -3\n",
        "set-view-reference-point 50 0 0\n", "set-view-up 1 0.5 0\n",
        "set-view-reference-point 1 2 3\nset-view-plane-normal 0.5 -1 -2\nset-view-up 1 1 1\n"
        "set-view-distance -4\nset-perspective -7 12 25\n",
        "set-perspective 3 2 6\nset-viewport 0 0.5 0 1\n"}) {
    GraphicsSystem only_said;
    replay(program, "program", only_said);
    const View view = view_after(program);
    EXPECT_NEAR(nearest_to_a_side(view), 0.05, 1e-9) << program;
    View said = only_said.view();
    said.window = view.window;
    said.set_depth(view.front, view.back);
    EXPECT_EQ(view, said) << program;
  }
}

TEST_F(ViewBeforeAMesh, AWindowThatWasSaidIsThatOfTheSaidView) {
  for (const char* program :
       {"set-window -3 3 -3 3\n", "set-window 0 2 0 2\nset-view-up 1 0 0\n"}) {
    GraphicsSystem only_said;
    replay(program, "program", only_said);
    EXPECT_EQ(view_after(program), only_said.view());
  }
}

TEST_F(ViewBeforeAMesh, AMeshThatIsNotBeforeTheSaidEyeIsRefused) {
  GraphicsSystem g;
  EXPECT_THROW(enter("set-perspective 0.5 0.5 0.5\n", g), Error);
  EXPECT_TRUE(g.display_file().segments().empty());
  EXPECT_FALSE(g.explicit_settings().contains(Setting::window));
}

TEST_F(SettingsBeforeAMesh, StylesAreThenWhatTheyWere) {
  GraphicsSystem g;
  enter("", g);
  EXPECT_EQ(g.looks().attributes.fill, FillStyle{});
  EXPECT_EQ(g.looks().attributes.line, LineStyle{});
  EXPECT_FALSE(g.explicit_settings().contains(Setting::fill_style));
  EXPECT_FALSE(g.explicit_settings().contains(Setting::light));
  EXPECT_FALSE(g.explicit_settings().contains(Setting::hidden_line_removal));
  GraphicsSystem red;
  enter("set-fill-style solid 1 0 0\nset-line-style dashed 0 1 0\n", red);
  EXPECT_EQ(red.looks().attributes.fill.colour, Colour(1, 0, 0));
  EXPECT_EQ(red.looks().attributes.line.kind, LineStyle::Kind::dashed);
}

TEST_F(SettingsBeforeAMesh, ManyPolygonsWithStylesOfTheirOwnSayNoStyle) {
  GraphicsSystem g;
  const std::vector<Point3> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<std::uint32_t> corners{0, 1, 2};
  const std::vector<FillStyle> fills{{FillStyle::Kind::solid, {1, 0, 0}}};
  g.open_segment(1);
  g.polygons_abs_3({vertices, corners, {}, fills});
  EXPECT_FALSE(g.explicit_settings().contains(Setting::fill_style));
  g.set_fill_style(fills[0]);
  EXPECT_TRUE(g.explicit_settings().contains(Setting::fill_style));
}

}  // namespace
}  // namespace displayfile
