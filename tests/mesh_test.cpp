// The guarantees for meshes: faces are as in the file, and the fitted view shows the whole mesh.

#include "displayfile/mesh/mesh.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/mesh/fitted_view.h"
#include "displayfile/mesh/import_library.h"
#include "displayfile/segments/display_file.h"
#include "interp/draw/draw.h"
#include "tests/import_library_leaks.h"
#include "tests/mesh_files.h"

namespace displayfile {
namespace {

using namespace test;

// ---- Reading ---------------------------------------------------------------------------

TEST_F(MeshTest, QuadrilateralsStayQuadrilaterals) {
  const Mesh mesh = read_mesh(file("cube.obj", cube()));
  ASSERT_EQ(mesh.objects.size(), 1u);
  ASSERT_EQ(mesh.faces(), 6u);
  EXPECT_EQ(mesh.vertices.size(), 8u) << "faces share them";
  for (std::size_t i = 0; i < mesh.faces(); ++i) {
    ASSERT_EQ(mesh.face(i).size(), 4u);
    for (int k = 0; k < 4; ++k) {
      const int v = kCubeFaces[i][k];
      EXPECT_EQ(mesh.vertices[mesh.face(i)[static_cast<std::size_t>(k)]],
                Point3(v & 1, v >> 1 & 1, v >> 2));
    }
  }
}

TEST_F(MeshTest, FacesMayHaveManySides) {
  std::string lines, obj = "f", face = "100";
  for (int i = 0; i < 100; ++i) {
    lines += fmt::format("v {} {} 0\n", std::cos(0.0628 * i), std::sin(0.0628 * i));
    obj += fmt::format(" {}", i + 1);
    face += fmt::format(" {}", i);
  }
  std::string positions = lines;
  std::erase(positions, 'v');
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 100\nproperty double x\nproperty double y\n"
      "property double z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n";
  const std::string paths[] = {file("disc.obj", lines + obj + "\n"),
                               file("disc.off", "OFF\n100 1 0\n" + positions + face),
                               file("disc.ply", ply + positions + face)};
  for (const std::string& path : paths) {
    const Mesh mesh = read_mesh(path);
    ASSERT_EQ(mesh.faces(), 1u) << path;
    ASSERT_EQ(mesh.face(0).size(), 100u) << path;
    for (std::uint32_t i = 0; i < 100; ++i) EXPECT_EQ(mesh.face(0)[i], i);
  }
}

TEST_F(MeshTest, EachObjectIsASegment) {
  const Mesh mesh = read_mesh(file("two.obj", two_cubes(3)));
  ASSERT_EQ(mesh.objects.size(), 2u);
  EXPECT_EQ(mesh.objects[0].name, "near");
  EXPECT_EQ(mesh.objects[1].name, "far");
  EXPECT_EQ(mesh.objects[1].first_face, 6u);
  EXPECT_EQ(mesh.objects[1].faces, 6u);

  GraphicsSystem system;
  enter_mesh(mesh, system, 5);
  ASSERT_EQ(system.display_file().segments().size(), 2u);
  EXPECT_TRUE(system.display_file().contains(5));
  EXPECT_TRUE(system.display_file().contains(6));
  EXPECT_EQ(system.counts().polygons, 12);
}

/// A node's transformation is applied, and one that mirrors leaves the light faces outside.
TEST_F(MeshTest, TransformationsOfNodesAreApplied) {
  if (!import_library_version()) GTEST_SKIP() << "no import library";
  const std::string triangles = [] {
    std::string buffer;
    const float corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    for (const auto& face : faces) {
      for (const int corner : face) {
        for (const float c : corners[corner]) buffer += bytes(c);
      }
    }
    return buffer;
  }();
  file("tetrahedron.bin", triangles);
  const Mesh mesh = read_mesh(file("tetrahedron.gltf", R"({"asset":{"version":"2.0"},"scene":0,
      "scenes":[{"nodes":[0]}],
      "nodes":[{"children":[1],"translation":[10,20,30]},{"mesh":0,"scale":[-1,1,1]}],
      "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
      "accessors":[{"bufferView":0,"componentType":5126,"count":12,"type":"VEC3",
                    "min":[0,0,0],"max":[1,1,1]}],
      "bufferViews":[{"buffer":0,"byteLength":144}],
      "buffers":[{"uri":"tetrahedron.bin","byteLength":144}]})"));
  ASSERT_EQ(mesh.faces(), 4u);
  for (const Point3& p : mesh.vertices) {
    EXPECT_TRUE(p.x >= 9 && p.x <= 10 && p.y >= 20 && p.y <= 21 && p.z >= 30 && p.z <= 31);
  }
  EXPECT_TRUE(std::ranges::count(mesh.vertices, Point3(9, 20, 30)) > 0);
  EXPECT_TRUE(closed_and_consistently_oriented(mesh));
}

/// Faces that are turned outward stay so, also those with normals of their own.
TEST_F(MeshTest, AModellingTransformationThatMirrorsLeavesTheLightFacesOutside) {
  const std::string path = file("cube.obj", cube());
  for (const Shading shading : {Shading::flat, Shading::gouraud}) {
    Picture pictures[2];
    for (const bool mirrored : {false, true}) {
      GraphicsSystem system;
      system.set_shading(shading);
      system.set_light({1, 2, 3});
      if (mirrored) {
        system.translate_3(-0.5, 0, 0);  // the cube's middle is where it was
        system.scale_3(-1, 1, 1);
        system.translate_3(0.5, 0, 0);
      }
      import_mesh(path, system, 1.0);
      EXPECT_TRUE(system.looks().attributes.back_face_removal);
      pictures[mirrored] =
          draw(system, {.width = 60, .height = 60, .samples = 1, .with_depth = true});
    }
    // Gouraud's triangles are mirrored, too.
    EXPECT_TRUE(shading != Shading::flat || pictures[0].pixels == pictures[1].pixels);
    for (std::size_t k = 0; k < pictures[0].depth.size(); ++k) {
      const double depth = pictures[0].depth[k], mirrored = pictures[1].depth[k];
      EXPECT_TRUE(depth == mirrored || std::abs(depth - mirrored) < 1e-12) << k;
    }
  }
}

TEST_F(MeshTest, WhatIsNoFaceIsCountedAndLeftOut) {
  const Mesh mesh = read_mesh(file("mixed.obj", cube() + "f 1 1 2\nf 1 2 1 2\nl 1 2 3\n"));
  EXPECT_EQ(mesh.faces(), 6u);
  EXPECT_EQ(mesh.skipped.degenerate_faces, 2u);
  EXPECT_GT(mesh.skipped.points_and_lines, 0u);
  EXPECT_TRUE(closed_and_consistently_oriented(mesh));
}

TEST_F(MeshTest, ObjIndicesMayBeNegativeOrAheadOrContinued) {
  const std::string ahead = cube_faces() + cube_vertices(0);
  EXPECT_EQ(read_mesh(file("ahead.obj", ahead)).faces(), 6u);
  const std::string corner = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_EQ(read_mesh(file("negative.obj", corner + "f -3 -2 -1\n")).faces(), 1u);
  EXPECT_EQ(read_mesh(file("continued.obj", corner + "f 1 2 \\\n3\n")).faces(), 1u);
  EXPECT_EQ(read_mesh(file("windows.obj", "# 1\r\n" + corner + "f 1 2 3 \r\n")).faces(), 1u);
}

// ---- Topology --------------------------------------------------------------------------

TEST_F(MeshTest, ClosedAndConsistentlyOriented) {
  const auto closed = [&](const std::string& obj) {
    return closed_and_consistently_oriented(read_mesh(file("a.obj", obj)));
  };
  const std::string corners = cube_vertices(0);
  EXPECT_TRUE(closed(cube()));
  EXPECT_FALSE(closed(corners + cube_faces(1, 5))) << "open";
  EXPECT_FALSE(closed(corners + cube_faces(1, 6, 3))) << "a face flipped";
  EXPECT_FALSE(closed(corners + cube_faces(1, 6, -1, true))) << "inside out";
  EXPECT_FALSE(closed(cube() + "f 1 2 6 5\n")) << "a face twice";
  EXPECT_TRUE(closed(two_cubes(3)));
  EXPECT_TRUE(closed(two_cubes(1))) << "two objects that touch";
  EXPECT_FALSE(closed(two_cubes(3) + cube_vertices(6) + cube_faces(17, 6, -1, true)))
      << "one part inside out";
}

TEST_F(MeshTest, APartMayBeClosedByAnother) {
  const std::string box = "o box\n" + cube_vertices(0) + cube_faces(1, 5);
  const std::string lid = "o lid\n" + cube_vertices(0) + "f 10 12 16 14\n";
  EXPECT_FALSE(closed_and_consistently_oriented(read_mesh(file("box.obj", box))));
  EXPECT_TRUE(closed_and_consistently_oriented(read_mesh(file("both.obj", box + lid))));
}

/// Minus zero is zero, and vertices that the file lists twice are one.
TEST_F(MeshTest, VerticesOfEqualPositionAreTheSame) {
  std::string text;
  for (int f = 0; f < 6; ++f) {
    for (const int v : kCubeFaces[f]) {
      const auto c = [&](int bit) { return v & bit ? "1" : f % 2 == 0 ? "0" : "-0"; };
      text += fmt::format("v {} {} {}\n", c(1), c(2), c(4));
    }
    text += "f -4 -3 -2 -1\n";
  }
  EXPECT_TRUE(closed_and_consistently_oriented(read_mesh(file("a.obj", text))));
}

// ---- Entering --------------------------------------------------------------------------

struct CollectedPoints {
  std::vector<Point3> points;
  void fill(const FillStyle&) {}
  void line_style(const LineStyle&) {}
  void pick(int) {}
  void move(const Point3& p) { points.push_back(p); }
  void line(const Point3& p) { points.push_back(p); }
  void polygon(std::span<const Point3> vertices, std::span<const std::int32_t>) {
    points.insert(points.end(), vertices.begin(), vertices.end());
  }
};

TEST_F(MeshTest, FittedViewShowsTheWholeMesh) {
  const std::string needle = "v 0 0 0\nv 1000 0.001 0\nv 1000 0 0.001\nf 1 2 3\n";
  const std::string far = "v 1e6 1e6 1e6\nv 1000001 1e6 1e6\nv 1e6 1000001 1e6\nf 1 2 3\n";
  const std::string tiny = "v 0 0 0\nv 1e-30 0 0\nv 0 1e-30 0\nf 1 2 3\n";
  const std::string huge = "v -3e38 -3e38 -3e38\nv 3e38 0 0\nv 0 3e38 3e38\nf 1 2 3\n";
  for (const std::string& obj : {cube(), two_cubes(40), needle, far, tiny, huge}) {
    const Mesh mesh = read_mesh(file("a.obj", obj));
    for (const double aspect : {1.0, 16.0 / 9.0, 0.5, 10.0, 0.1}) {
      GraphicsSystem system;
      system.set_aspect_ratio(aspect);
      fit_view(std::span(&mesh, 1), system);
      enter_mesh(mesh, system, 1);
      CollectedPoints seen;
      for (const Segment& s : system.display_file().segments()) s.walk_drawn(seen);
      ASSERT_EQ(seen.points.size(), mesh.corners.size()) << "something was clipped";
      double x_min = 1, x_max = 0, y_min = 1, y_max = 0;
      for (const Point3& p : seen.points) {
        for (int axis = 0; axis < 3; ++axis) {
          EXPECT_GT(p[axis], 0.0);
          EXPECT_LT(p[axis], 1.0);
        }
        x_min = std::min(x_min, p.x);
        x_max = std::max(x_max, p.x);
        y_min = std::min(y_min, p.y);
        y_max = std::max(y_max, p.y);
      }
      EXPECT_NEAR(std::max(x_max - x_min, y_max - y_min), 0.9, 1e-3) << "it fills the window";
      EXPECT_NEAR(x_min + x_max, 1.0, 1e-3) << "it is in the middle";
      EXPECT_NEAR(y_min + y_max, 1.0, 1e-3);
      const Rectangle& window = system.view().window;
      const double ratio = (window.x_max - window.x_min) / (window.y_max - window.y_min);
      EXPECT_NEAR(ratio / aspect, 1.0, 1e-12) << "it is not stretched";
    }
  }
}

TEST_F(MeshTest, FittedViewRefusesWhatItCannotFit) {
  GraphicsSystem system;
  const std::string path = file("a.obj", cube());
  for (const double aspect : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    EXPECT_THROW(import_mesh(path, system, aspect), Error);
    EXPECT_EQ(system.aspect_ratio(), 1.0);
  }
  EXPECT_THROW(import_mesh("missing.obj", system, 2.0), Error);
  EXPECT_EQ(system.aspect_ratio(), 1.0);
  EXPECT_THROW(fit_view(std::span<const Mesh>(), system), Error);
  EXPECT_FALSE(system.explicit_settings().contains_view());
}

TEST_F(MeshTest, BackFacesGoOnlyFromClosedMeshes) {
  GraphicsSystem closed, open;
  import_mesh(file("closed.obj", cube()), closed);
  EXPECT_TRUE(closed.looks().attributes.back_face_removal);
  EXPECT_EQ(closed.display_file().polygons(), 3u) << "three faces of a cube are seen";
  import_mesh(file("open.obj", cube_vertices(0) + cube_faces(1, 5)), open);
  EXPECT_FALSE(open.looks().attributes.back_face_removal);
  EXPECT_EQ(open.display_file().polygons(), 5u);
}

TEST_F(MeshTest, AViewThatWasSetHolds) {
  GraphicsSystem system;
  replay(
      "set-window -9 9 -9 9\nset-view-depth -9 9\nset-fill-style solid 1 0 0\n"
      "set-light 0 0 1 1\nset-back-face-removal off\n"
      "open-segment 7\nclose-segment\n",
      "program", system);
  import_mesh(file("a.obj", cube()), system);
  EXPECT_EQ(system.view().window, (Rectangle{-9, 9, -9, 9}));
  EXPECT_TRUE(system.display_file().contains(8)) << "named after the segments in use";
  EXPECT_EQ(system.display_file().polygons(), 6u) << "back faces as the program has them";
  EXPECT_NE(dump(system.display_file()).find("fill solid 1 0 0"), std::string::npos);
}

/// Callers that turn the meshes turn them about the up axis of the fitted camera.
TEST_F(MeshTest, ImportTellsWhatIsUpInTheFittedCamera) {
  const std::vector<std::string> paths{file("a.obj", cube())};
  const auto fitted = [&](GraphicsSystem& system, const Camera& camera) {
    return import_meshes(paths, system, {.camera = camera}).fitted;
  };
  GraphicsSystem plain, z_up, said_camera, said_window;
  EXPECT_EQ(fitted(plain, {}), Upright{});
  EXPECT_EQ(fitted(plain, {}), std::nullopt) << "the window is that of the first";
  EXPECT_EQ(fitted(z_up, {.upright = upright("z")}), upright("z"));
  said_camera.set_perspective({0, 0, 20});
  EXPECT_EQ(fitted(said_camera, {}), std::nullopt);
  said_window.set_window(-1, 1, -1, 1);
  EXPECT_EQ(fitted(said_window, {}), std::nullopt);
}

TEST_F(MeshTest, RecordedImportReplaysToTheSameDisplayFile) {
  const std::string both = two_cubes(2.7) + "f 1 3 16\n";  // not closed
  for (const std::string& obj : {cube(), both}) {
    GraphicsSystem imported, replayed;
    std::ostringstream program;
    Recorder recorder(program);
    imported.set_recorder(&recorder);
    import_mesh(file("a.obj", obj), imported, 1.5);
    replay(program.str(), "recorded", replayed);
    EXPECT_EQ(dump(imported.display_file()), dump(replayed.display_file()));
    EXPECT_EQ(imported.hidden_surfaces().removal, replayed.hidden_surfaces().removal);
    EXPECT_GT(imported.display_file().polygons(), 0u);
  }
}

TEST_F(MeshTest, EnteringIsAllOrNothing) {
  GraphicsSystem system;
  const Mesh mesh = read_mesh(file("a.obj", two_cubes(3)));
  replay("open-segment 2\nclose-segment\n", "program", system);
  EXPECT_THROW(enter_mesh(mesh, system, 1), Error) << "segment 2 is in use";
  EXPECT_THROW(enter_mesh(mesh, system, 0), Error);
  EXPECT_THROW(enter_mesh(mesh, system, 2147483647), Error);
  EXPECT_EQ(system.display_file().segments().size(), 1u);
  system.scale_3(1e99, 1e99, 1e99);
  system.translate_3(9e99, 0, 0);
  EXPECT_THROW(enter_mesh(mesh, system, 5), Error) << "out of range after the transformation";
  EXPECT_EQ(system.display_file().segments().size(), 1u);
  EXPECT_FALSE(system.open_segment_name());
  system.create_transformation_3();
  system.open_segment(9);
  EXPECT_THROW(enter_mesh(mesh, system, 10), Error) << "a segment is open";
  EXPECT_THROW(import_mesh(file("b.obj", cube()), system), Error);
}

/// By the light that meshes have where none was set, from in front of three faces of a cube: each
/// is more than a third as light as its colour, and no two are alike.
TEST(Meshes, FacesOfACubeAreLightAndDiffer) {
  Mesh cube;
  cube.objects = {{"cube", 0, 6}};
  for (int k = 0; k < 8; ++k) cube.vertices.emplace_back(k & 1, k >> 1 & 1, k >> 2);
  cube.corners = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
  cube.first_corner = {0, 4, 8, 12, 16, 20, 24};
  for (const Point3 eye : {Point3(1, 1, 1), Point3(-2, 1, 2), Point3(1, 2, -1), Point3(-1, 1.5, -2),
                           Point3(2, 1, 3), Point3(-3, 2, -2)}) {
    GraphicsSystem g;
    g.set_view_plane_normal(eye);
    g.set_parallel(-eye);
    g.set_window(-3, 3, -3, 3);
    enter_meshes(std::span(&cube, 1), g, {});
    const Picture picture = draw(g, {.width = 60, .height = 60, .samples = 1, .with_ids = true});
    std::set<std::uint32_t> greens;
    for (std::size_t k = 0; k < picture.ids.size(); ++k) {
      if (picture.ids[k] >= 0) greens.insert(picture.pixels[k] >> 8 & 255);
    }
    EXPECT_EQ(greens.size(), 3u) << eye.x << ' ' << eye.y << ' ' << eye.z;
    EXPECT_GT(*greens.begin(), 85u) << eye.x << ' ' << eye.y << ' ' << eye.z;
  }
}

}  // namespace
}  // namespace displayfile
