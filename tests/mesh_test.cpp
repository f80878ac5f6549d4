// What a user may expect of meshes: faces come through as they are in the file, bad files are
// refused with their name and place, and the fitted view shows the whole mesh.

#include "displayfile/mesh/mesh.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <vector>

#include "clip/error.h"
#include "displayfile/mesh/fitted_view.h"
#include "displayfile/mesh/import_library.h"
#include "displayfile/text/drawing_program.h"
#include "displayfile/text/dump.h"
#include "tests/temporary_folder.h"

/// The import library does not free all that it took for a file that it refuses.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libassimp"; }

namespace displayfile {
namespace {

class MeshTest : public test::TemporaryFolder {
 protected:
  std::string file(const std::string& name, const std::string& text) const {
    return TemporaryFolder::file(name, text).string();
  }
};

// ---- Mesh files ------------------------------------------------------------------------

/// The corners of a cube from (x, 0, 0) to (x + 1, 1, 1): bit k of the index is coordinate k.
std::string cube_vertices(double x) {
  std::string text;
  for (int i = 0; i < 8; ++i) text += fmt::format("v {} {} {}\n", x + (i & 1), i >> 1 & 1, i >> 2);
  return text;
}

constexpr int kCubeFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                  {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

/// Its faces, the light ones out; `first` is the OBJ index of its first vertex.
std::string cube_faces(int first = 1, int faces = 6, int flipped = -1, bool inside_out = false) {
  std::string text;
  for (int f = 0; f < faces; ++f) {
    std::vector<int> face(kCubeFaces[f], kCubeFaces[f] + 4);
    if (inside_out != (f == flipped)) std::ranges::reverse(face);
    text += fmt::format("f {} {} {} {}\n", face[0] + first, face[1] + first, face[2] + first,
                        face[3] + first);
  }
  return text;
}

std::string cube() { return cube_vertices(0) + cube_faces(); }

std::string two_cubes(double distance) {
  return "o near\n" + cube_vertices(0) + cube_faces() + "o far\n" + cube_vertices(distance) +
         cube_faces(9);
}

std::string bytes(auto value) {
  const auto array = std::bit_cast<std::array<char, sizeof(value)>>(value);
  return {array.begin(), array.end()};
}

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
  EXPECT_EQ(system.polygons_entered(), 12);
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

// ---- Precision -------------------------------------------------------------------------

/// A survey: national coordinates, heights in millimetres, which single precision loses.
constexpr double kSurvey[4][3] = {{512345.678, 4212345.671, 123.456},
                                  {512345.679, 4212345.671, 123.457},
                                  {512345.679, 4212345.672, 123.455},
                                  {512345.678, 4212345.672, 123.4565}};

std::string survey_lines(const std::string& before) {
  std::string text;
  for (const auto& p : kSurvey) text += fmt::format("{}{} {} {}\n", before, p[0], p[1], p[2]);
  return text;
}

/// As the bytes stand on this machine, or turned round.
std::string ordered(std::string value, bool turned) {
  if (turned) std::ranges::reverse(value);
  return value;
}

std::string survey_ply(const std::string& format) {
  std::string text = fmt::format(
      "ply\nformat {} 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
      "property double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n",
      format);
  if (format == "ascii") return text + survey_lines("") + "4 0 1 2 3\n";
  const bool turned = (format == "binary_big_endian") != (std::endian::native == std::endian::big);
  for (const auto& p : kSurvey) {
    for (const double c : p) text += ordered(bytes(c), turned);
  }
  text += '\4';
  for (const int i : {0, 1, 2, 3}) text += ordered(bytes(i), turned);
  return text;
}

TEST_F(MeshTest, CoordinatesAreReadInDoublePrecision) {
  const std::string paths[] = {
      file("survey.obj", survey_lines("v ") + "f 1 2 3 4\n"),
      file("survey.off", "OFF\n4 1 4\n" + survey_lines("") + "4 0 1 2 3\n"),
      file("ascii.ply", survey_ply("ascii")),
      file("little.ply", survey_ply("binary_little_endian")),
      file("big.ply", survey_ply("binary_big_endian"))};
  for (const std::string& path : paths) {
    const Mesh mesh = read_mesh(path);
    ASSERT_EQ(mesh.faces(), 1u) << path;
    ASSERT_EQ(mesh.face(0).size(), 4u) << path;
    for (std::size_t k = 0; k < 4; ++k) {
      const double* const p = kSurvey[k];
      EXPECT_EQ(mesh.vertices[mesh.face(0)[k]], Point3(p[0], p[1], p[2])) << path;
    }
  }
  std::string stl = "solid survey\nfacet normal 0 0 1\nouter loop\n";
  stl += survey_lines("vertex ").substr(0, survey_lines("vertex ").rfind("vertex"));
  const Mesh facet = read_mesh(file("survey.stl", stl + "endloop\nendfacet\nendsolid survey\n"));
  ASSERT_EQ(facet.vertices.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(facet.vertices[k], Point3(kSurvey[k][0], kSurvey[k][1], kSurvey[k][2]));
  }
}

/// What reaches the display file: the drawing program of an imported mesh has the file's numbers.
TEST_F(MeshTest, AnImportedSurveyKeepsItsMillimetres) {
  GraphicsSystem system;
  std::ostringstream program;
  Recorder recorder(program);
  system.set_recorder(&recorder);
  import_mesh(file("survey.obj", survey_lines("v ") + "f 1 2 3 4\n"), system);
  EXPECT_NE(program.str().find("512345.678 4212345.671 123.456  512345.679 4212345.671 123.457"),
            std::string::npos)
      << program.str();
}

TEST_F(MeshTest, NumbersAreRoundedCorrectly) {
  const Mesh mesh = read_mesh(file("a.obj",
                                   "v 0.1 +0.2 -.3\nv 1e-3 2E2 3.\n"
                                   "v 9007199254740993 0.30000000000000004 5e-300\nf 1 2 3\n"));
  EXPECT_EQ(mesh.vertices[0], Point3(0.1, 0.2, -0.3));
  EXPECT_EQ(mesh.vertices[1], Point3(1e-3, 200, 3));
  EXPECT_EQ(mesh.vertices[2], Point3(9007199254740992.0, 0.1 + 0.2, 5e-300));
}

// ---- What each format may hold ---------------------------------------------------------

constexpr const char* kFourCorners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

/// The faces' vertices, in words.
std::string faces_of(const Mesh& mesh) {
  std::string text;
  for (const Mesh::Object& object : mesh.objects) {
    text += object.name + ":";
    for (std::size_t i = object.first_face; i < object.first_face + object.faces; ++i) {
      for (const std::uint32_t v : mesh.face(i)) text += fmt::format(" {}", v);
      text += ";";
    }
  }
  return text;
}

TEST_F(MeshTest, ObjVerticesMayHaveAWeightOrAColour) {
  const Mesh mesh = read_mesh(file("a.obj",
                                   "v 2 4 6 2\nv 1 0 0 1 0.5 0\nv 0 1 0 # no weight\n"
                                   "f 1 2 3 # a face\n"));
  EXPECT_EQ(mesh.vertices[0], Point3(1, 2, 3));
  EXPECT_EQ(mesh.vertices[1], Point3(1, 0, 0));
  EXPECT_EQ(mesh.vertices[2], Point3(0, 1, 0));
  EXPECT_EQ(faces_of(mesh), ": 0 1 2;");
}

TEST_F(MeshTest, ObjCornersMayNameTexturesAndNormals) {
  const Mesh mesh =
      read_mesh(file("a.obj", std::string(kFourCorners) + "vt 0 0\nvn 0 0 1\nvn 0 1 0\nvn nan 0 0\n"
                                                          "f 1/1/1 2//2 3/1\nf 1//-2 3//3 4//1\n"),
                true);
  const Point3 expected[] = {{0, 0, 1}, {0, 1, 0}, {0, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 0, 1}};
  ASSERT_EQ(mesh.corner_normals.size(), 6u);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(mesh.normal(k), expected[k]) << k;
}

/// A group begins an object each time that its name changes; an object that is named again goes on.
TEST_F(MeshTest, ObjObjectsAndGroups) {
  const auto faces = [&](const std::string& text) {
    return faces_of(read_mesh(file("a.obj", kFourCorners + text)));
  };
  EXPECT_EQ(faces("f 1 2 3\ng a b\nf 1 2 4\ng a b\nf 1 3 4\ng\nf 2 3 4\n"),
            ": 0 1 2;a b: 0 1 3; 0 2 3;: 1 2 3;");
  EXPECT_EQ(faces("g a\nf 1 2 3\ng b\nf 1 2 4\ng a\nf 1 3 4\n"), "a: 0 1 2;b: 0 1 3;a: 0 2 3;");
  EXPECT_EQ(faces("o a\nf 1 2 3\no b\nf 1 2 4\no a\nf 1 3 4\n"), "a: 0 1 2; 0 2 3;b: 0 1 3;");
  EXPECT_EQ(faces("o a\nusemtl red\nf 1 2 3\nusemtl blue\ns 1\nf 1 2 4\no none\n"),
            "a: 0 1 2; 0 1 3;");
}

TEST_F(MeshTest, OffHeadersAndVertices) {
  const std::string face = "3 0 1 2 255 0 0\n";
  const auto vertices = [&](const std::string& text) {
    const Mesh mesh = read_mesh(file("a.off", text + face));
    EXPECT_EQ(faces_of(mesh), ": 0 1 2;") << text;
    return mesh.vertices;
  };
  const std::vector<Point3> expected = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(vertices("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n"), expected);
  EXPECT_EQ(vertices("3 1 0\n0 0 0\n1 0 0\n0 1 0\n"), expected) << "no header";
  EXPECT_EQ(vertices("OFF 3 1\n# three\n\n0 0 0\n1 0 0 # one\r\n0 1 0\n"), expected);
  EXPECT_EQ(vertices("COFF\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 255 0 0\n0 1 0 7\n"), expected);
  EXPECT_EQ(vertices("4OFF\n3 1 0\n0 0 0 2\n2 0 0 2\n0 4 0 4\n"), expected);
  EXPECT_EQ(vertices("nOFF 2\n3 1 0\n0 0\n1 0\n0 1\n"), expected);
  const std::string path = file("n.off",
                                "STCNOFF\n3 1 0\n0 0 0 0 0 1 1 0 0 0.5 0.5\n1 0 0 0 1 0 1 0 0 0 0\n"
                                "0 1 0 1 0 0 1 0 0 0 0\n" +
                                    face);
  const Mesh mesh = read_mesh(path, true);
  EXPECT_EQ(mesh.vertices, expected);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(mesh.normal(static_cast<std::size_t>(k))[2 - k], 1.0);
}

/// Every type, lists among them, elements that are not known, and faces before their vertices.
TEST_F(MeshTest, PlyMayHoldMoreThanAMesh) {
  const std::string header =
      "ply\r\nformat {} 1.0\r\ncomment junk\nobj_info junk\nelement face 2\nproperty char k\n"
      "property list short uint vertex_index\nproperty list uint8 double weights\n"
      "element other 2\nproperty float64 a\nproperty list int ushort b\nelement vertex 4\n"
      "property float nz\nproperty uint16 x\nproperty list uchar int8 junk\nproperty int32 y\n"
      "property float32 z\nproperty float nx\nproperty float ny\nelement empty 7\nend_header\n";
  const int x[] = {0, 60000, 0, 0}, y[] = {0, 0, -70000, 0};
  const float z[] = {0, 0, 0, 0.25f};
  const auto check = [&](const std::string& path) {
    const Mesh mesh = read_mesh(path, true);
    EXPECT_EQ(faces_of(mesh), ": 0 1 2; 3 2 1 0;") << path;
    for (std::size_t k = 0; k < mesh.corners.size(); ++k) {
      const std::uint32_t v = mesh.corners[k];
      EXPECT_EQ(mesh.vertices[v], Point3(x[v], y[v], z[v])) << path;
      EXPECT_EQ(mesh.normal(k), Point3(0.5, v, 1)) << path;
    }
  };
  std::string ascii = fmt::format(fmt::runtime(header), "ascii") +
                      "1 3 0 1 2 0\n2 4 3 2 1 0 1 nan\n0.5 2 1 2\n7 0\n";
  for (int v = 0; v < 4; ++v)
    ascii += fmt::format("1 {} 2 1 2 {} {} 0.5 {}\n", x[v], y[v], z[v], v);
  check(file("ascii.ply", ascii));
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const auto put = [&](auto value) {
      return ordered(bytes(value), order != std::endian::native);
    };
    std::string data =
        fmt::format(fmt::runtime(header),
                    order == std::endian::little ? "binary_little_endian" : "binary_big_endian");
    data += '\1' + put(std::int16_t{3}) + put(0u) + put(1u) + put(2u) + '\0';
    data += '\2' + put(std::int16_t{4}) + put(3u) + put(2u) + put(1u) + put(0u) + '\1' + put(0.5);
    data += put(0.5) + put(2) + put(std::uint16_t{1}) + put(std::uint16_t{2}) + put(7.0) + put(0);
    for (int v = 0; v < 4; ++v) {
      data += put(1.0f) + put(static_cast<std::uint16_t>(x[v])) + "\2ab" + put(y[v]) + put(z[v]) +
              put(0.5f) + put(static_cast<float>(v));
    }
    check(file("binary.ply", data));
  }
}

TEST_F(MeshTest, PlyStripsAreTriangles) {
  const Mesh mesh =
      read_mesh(file("a.ply",
                     "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
                     "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
                     "0 0\n1 0\n0 1\n1 1\n0 2\n9 0 1 2 3 4 -1 2 3 4\n"));
  EXPECT_EQ(faces_of(mesh), ": 0 1 2; 2 1 3; 2 3 4; 2 3 4;");
}

TEST_F(MeshTest, StlOfTextAndBytes) {
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
      "endfacet\n";
  const std::string text = "solid a b\n" + facet + facet + "endsolid a b\nsolid none\nendsolid\n" +
                           "solid c\r\n" + facet + "endsolid";
  EXPECT_EQ(faces_of(read_mesh(file("a.stl", text))), "a: 0 1 2; 3 4 5;c: 6 7 8;");

  std::string binary = "solid as some name it though it is none";
  binary.resize(80);
  binary += bytes(std::uint32_t{2});
  for (int i = 0; i < 2; ++i) {
    for (const float c : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.1f}) {
      binary += bytes(c);
    }
    binary += "xx";
  }
  const Mesh mesh = read_mesh(file("b.STL", binary));
  EXPECT_EQ(faces_of(mesh), ": 0 1 2; 3 4 5;");
  EXPECT_EQ(mesh.vertices[5], Point3(0, 1, 0.1f));
}

TEST_F(MeshTest, AFileTellsItsFormatByItsBeginning) {
  EXPECT_EQ(read_mesh(file("mesh.dat", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")).faces(), 1u);
  EXPECT_EQ(read_mesh(file("mesh.obj", survey_ply("ascii"))).faces(), 1u);
  EXPECT_EQ(read_mesh(file("MESH.OBJ", cube())).faces(), 6u);
}

// ---- Bad files -------------------------------------------------------------------------

/// Importing the file is refused with a message that starts with its path and holds `expected`;
/// the system is what it was.
void expect_refused(const std::string& path, const std::string& expected) {
  GraphicsSystem system;
  std::ostringstream record;
  Recorder recorder(record);
  system.set_recorder(&recorder);
  const auto start = std::chrono::steady_clock::now();
  try {
    import_mesh(path, system);
    ADD_FAILURE() << path << " was accepted";
  } catch (const Error& e) {
    EXPECT_TRUE(std::string(e.what()).starts_with(path)) << e.what();
    EXPECT_NE(std::string(e.what()).find(expected), std::string::npos)
        << e.what() << "\ndoes not say: " << expected;
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5)) << path;
  EXPECT_TRUE(system.display_file().segments().empty());
  EXPECT_FALSE(system.view_was_set());
  EXPECT_EQ(record.str(), "");
}

TEST_F(MeshTest, IndexOutOfRange) {
  expect_refused(file("a.obj", cube_vertices(0) + "f 1 2 3\nf 1 2 99 3\n"),
                 ":10:7: vertex index 99 out of range: expected 1 to 8 or -8 to -1");
  expect_refused(file("b.obj", cube_vertices(0) + "f 1 2 0\n"), ":9:7: vertex index 0");
  expect_refused(file("c.obj", cube_vertices(0) + "f 1 2 -9\n"), ":9:7: vertex index -9");
  expect_refused(file("d.obj", cube_vertices(0) + "f 1//1 2//1 3//1\n"), "no normal was given");
  expect_refused(file("e.obj", cube_vertices(0) + "f 1 2 three\n"), ":9:7: 'three': expected");
  expect_refused(file("f.obj", cube_vertices(0) + "f 1 2 99999999999999999999\n"), ":9:7:");
  expect_refused(file("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
                 ":6:7: vertex index 3 out of range: expected 0 to 2");
  expect_refused(file("a.ply",
                      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                      "property float y\nproperty float z\nelement face 1\n"
                      "property list uchar int vertex_indices\nend_header\n"
                      "0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n"),
                 ":13:7: vertex index 7 out of range: expected 0 to 2");
}

TEST_F(MeshTest, CoordinatesThatAreNotFinite) {
  const std::string face = "v 1 0 0\nv 0 1 0\nf 1 2 3\n";
  expect_refused(file("nan.obj", "v 0 nan 0\n" + face), ":1:5: coordinate nan: expected a finite");
  expect_refused(file("inf.obj", "v 0 0 -inf\n" + face), ":1:7: coordinate -inf");
  expect_refused(file("large.obj", "v 1e39 0 0\n" + face), ":1:3: coordinate 1e39");
  expect_refused(file("word.obj", "v 0 0 x\n" + face), ":1:7: 'x': expected a coordinate");
  expect_refused(file("weight.obj", "v 0 0 1 0\n" + face), ":1:9: weight 0");
  const std::string off = "0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  expect_refused(file("nan.off", "OFF\n3 1 0\nnan " + off), ":3:1: coordinate nan");
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
      "property double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  expect_refused(file("inf.ply", ply + "inf " + off), ":10:1: coordinate inf");
  std::string binary = ply;
  binary.replace(binary.find("ascii"), 5, "binary_little_endian");
  for (const double c : {0., 0., 0., 1., std::nan(""), 0., 0., 1., 0.}) binary += bytes(c);
  binary += '\3' + bytes(0) + bytes(1) + bytes(2);
  expect_refused(file("nan.ply", binary), "vertex 1: coordinate nan: expected a finite");
  expect_refused(file("nan_text.stl", "solid\nfacet normal 0 0 1\nvertex 0 0 nan\n"),
                 ":3:12: coordinate nan");
  std::string stl(80, ' ');
  stl += bytes(std::uint32_t{1});
  for (int i = 0; i < 12; ++i) stl += bytes(i == 7 ? std::nanf("") : static_cast<float>(i * i % 7));
  expect_refused(file("nan.stl", stl + std::string(2, '\0')), "expected finite coordinates");
}

TEST_F(MeshTest, TruncatedFiles) {
  expect_refused(file("a.obj", cube_vertices(0) + "v 1 2"), ":9:6: end of line: expected");
  expect_refused(file("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n"), "end of file: expected vertex 2");
  expect_refused(file("a.ply", "ply\nformat ascii 1.0\nelement vertex 0\n"), "expected end_header");
  const std::string header =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\n"
      "property float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n";
  std::string data;
  for (const float c : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) data += bytes(c);
  data += '\3';
  for (const int i : {0, 1, 2}) data += bytes(i);
  EXPECT_EQ(read_mesh(file("whole.ply", header + data)).faces(), 1u);
  for (std::size_t n = 0; n < data.size(); ++n) {
    expect_refused(file("cut.ply", header + data.substr(0, n)), "announced");
  }
  const std::string facet = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n";
  expect_refused(file("b.stl", facet), "expected endsolid");
  expect_refused(file("c.stl", facet + "endloop\nendfacet\nendsolid\n"),
                 ":7:1: a facet of 2 vertices: expected 3");
  expect_refused(file("d.stl", facet + "facet normal 0 0 1\n"), ":6:1: facet: expected endfacet");
  std::string stl(80, ' ');
  stl += bytes(std::uint32_t{2}) + std::string(50, '\0');
  expect_refused(file("a.stl", stl), "announces 2 facets: expected 184 bytes");
}

TEST_F(MeshTest, FilesThatAnnounceTooMuch) {
  expect_refused(file("vertices.off", "OFF\n1000000000 1 0\n0 0 0\n"), ":2:1: 1000000000 vertices");
  expect_refused(file("faces.off", "OFF\n1 1000000000 0\n0 0 0\n"), ":2:3: 1000000000 faces");
  expect_refused(
      file("keyword.ply", "ply\nformat ascii 1.0\nelement face 0\nproprety x\nend_header\n"),
      ":4:1:");
  expect_refused(file("no_corners.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n0\n"), ":6:1:");
  expect_refused(file("few_corners.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2\n"), ":6:8:");
  expect_refused(file("corners.off", "OFF\n1 1 0\n0 0 0\n1000000000 0 0 0\n"), ":4:1:");
  const std::string count = "4000000000 0 1 2\n", binary_count("\xFF\xFF\xFF\xFF\0\0\0\1", 8);
  for (const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    const std::string start = fmt::format("ply\nformat {} 1.0\n", format);
    expect_refused(file("vertices.ply", start + "element vertex 1000000000\nproperty float x\n"
                                                "end_header\n0 0 0\n"),
                   ":3:16: 1000000000 vertex announced");
    expect_refused(file("list.ply", start +
                                        "element face 1\n"
                                        "property list uint int vertex_indices\nend_header\n" +
                                        (format == "ascii" ? count : binary_count)),
                   "announced");
  }
  std::string stl(80, ' ');
  expect_refused(file("a.stl", stl + bytes(std::uint32_t{1000000000})), "1000000000 facets");
}

TEST_F(MeshTest, FilesThatAreNoMesh) {
  for (const char* extension : {"obj", "ply", "off", "stl", "3ds", "gltf", "dae", "fbx"}) {
    const std::string name = fmt::format("a.{}", extension);
    expect_refused(file(name, ""), "empty file");
    std::string garbage;
    for (unsigned i = 0, x = 1; i < 4096; ++i) {
      x = x * 1664525u + 1013904223u;
      garbage += static_cast<char>(x >> 24);
    }
    expect_refused(file(name, garbage), "");
    expect_refused((folder_ / ("missing-" + name)).string(), "no such file");
  }
  expect_refused(folder_.string(), "not a regular file");
  expect_refused(file("mesh.xyz", "1 2 3\n"), "xyz");
  expect_refused(file("points.obj", "v 0 0 0\nv 1 0 0\np 1 2\n"), "no faces");
  expect_refused(file("line.obj", "v 0 0 0\nv 1 0 0\nf 1 2 1\n"), "no faces");
}

TEST_F(MeshTest, NothingIsEnteredWhenAnotherFileIsBad) {
  GraphicsSystem system;
  const std::vector<std::string> paths = {file("a.obj", cube()), file("b.obj", "f 1 2 3\n")};
  EXPECT_THROW(import_meshes(paths, system), Error);
  EXPECT_TRUE(system.display_file().segments().empty());
  EXPECT_FALSE(system.view_was_set());
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
  EXPECT_FALSE(system.view_was_set());
}

TEST_F(MeshTest, BackFacesGoOnlyFromClosedMeshes) {
  GraphicsSystem closed, open;
  import_mesh(file("closed.obj", cube()), closed);
  EXPECT_TRUE(closed.back_face_removal());
  EXPECT_EQ(closed.display_file().polygons(), 3u) << "three faces of a cube are seen";
  import_mesh(file("open.obj", cube_vertices(0) + cube_faces(1, 5)), open);
  EXPECT_FALSE(open.back_face_removal());
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
    EXPECT_EQ(imported.hidden_line_removal(), replayed.hidden_line_removal());
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

}  // namespace
}  // namespace displayfile
