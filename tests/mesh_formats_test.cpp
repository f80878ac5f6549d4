// The possible contents of files of each format, to the last bit of their numbers.

#include "displayfile/mesh/mesh.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "tests/mesh_files.h"

namespace displayfile {
namespace {

using test::bytes;
using test::cube;
using test::kFourCorners;
using test::MeshTest;

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

/// Numbers in the display file: the drawing program of an imported mesh has the file's.
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

// ---- Contents of each format -----------------------------------------------------------

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
  EXPECT_EQ(faces_of(mesh), "a: 0 1 2;");
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

/// A group begins an object each time that its name changes; an object that is named again
/// continues.
TEST_F(MeshTest, ObjObjectsAndGroups) {
  const auto faces = [&](const std::string& text) {
    return faces_of(read_mesh(file("a.obj", kFourCorners + text)));
  };
  EXPECT_EQ(faces("f 1 2 3\ng a b\nf 1 2 4\ng a b\nf 1 3 4\ng\nf 2 3 4\n"),
            "a: 0 1 2;a b: 0 1 3; 0 2 3;a 2: 1 2 3;");
  EXPECT_EQ(faces("g a\nf 1 2 3\ng b\nf 1 2 4\ng a\nf 1 3 4\n"), "a: 0 1 2;b: 0 1 3;a: 0 2 3;");
  EXPECT_EQ(faces("o a\nf 1 2 3\no b\nf 1 2 4\no a\nf 1 3 4\n"), "a: 0 1 2; 0 2 3;b: 0 1 3;");
  EXPECT_EQ(faces("o a\nusemtl red\nf 1 2 3\nusemtl blue\ns 1\nf 1 2 4\no none\n"),
            "a: 0 1 2; 0 1 3;");
}

TEST_F(MeshTest, OffHeadersAndVertices) {
  const std::string face = "3 0 1 2 255 0 0\n";
  const auto vertices = [&](const std::string& text) {
    const Mesh mesh = read_mesh(file("a.off", text + face));
    EXPECT_EQ(faces_of(mesh), "a: 0 1 2;") << text;
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

// As many as there may be, each of as many as may be, and nothing to read of any.
TEST_F(MeshTest, PlyMayAnnounceManyElementsWithoutProperties) {
  std::string ply = "ply\nformat ascii 1.0\n";
  for (int k = 0; k < 50000; ++k) ply += fmt::format("element e{} 500000\n", k);
  ply +=
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const Mesh mesh = read_mesh(file("many.ply", ply + std::string(500000, '\n')));
  EXPECT_EQ(mesh.vertices.size(), 3u);
  EXPECT_EQ(mesh.faces(), 1u);
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
    EXPECT_EQ(faces_of(mesh), std::filesystem::path(path).stem().string() + ": 0 1 2; 3 2 1 0;")
        << path;
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
  EXPECT_EQ(faces_of(mesh), "a: 0 1 2; 2 1 3; 2 3 4; 2 3 4;");
}

TEST_F(MeshTest, StlOfTextAndBytes) {
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
      "endfacet\n";
  const std::string text = "solid a b\n" + facet + facet + "endsolid a b\nsolid none\nendsolid\n" +
                           "solid c\r\n" + facet + "endsolid";
  EXPECT_EQ(faces_of(read_mesh(file("a.stl", text))), "a b: 0 1 2; 3 4 5;c: 6 7 8;");

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
  EXPECT_EQ(faces_of(mesh), "b: 0 1 2; 3 4 5;");
  EXPECT_EQ(mesh.vertices[5], Point3(0, 1, 0.1f));
}

TEST_F(MeshTest, StlTextsMayBeginWithBlanksAndBeInCapitals) {
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
      "endfacet\n";
  const std::string text = "solid Part\n" + facet + "endsolid\n";
  for (const std::string before : {"\xEF\xBB\xBF", " ", "\n", "\r\n\t", "\xEF\xBB\xBF\n"}) {
    EXPECT_EQ(faces_of(read_mesh(file("a.stl", before + text))), "Part: 0 1 2;") << before;
  }
  std::string capitals = text;
  std::ranges::transform(capitals, capitals.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  EXPECT_EQ(faces_of(read_mesh(file("b.stl", capitals))), "PART: 0 1 2;");
}

std::string binary_stl(std::uint32_t announced, int facets) {
  std::string binary(80, ' ');
  binary += bytes(announced);
  for (int i = 0; i < facets; ++i) {
    for (const float c : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.1f}) {
      binary += bytes(c);
    }
    binary += std::string(2, '\0');
  }
  return binary;
}

/// Contents after all that a file announces are not dropped silently.
TEST_F(MeshTest, FacesThatAreNotAnnouncedAreTold) {
  const auto expect = [&](const std::string& name, const std::string& text, std::size_t faces,
                          const std::vector<std::string>& warnings) {
    const Mesh mesh = read_mesh(file(name, text));
    EXPECT_EQ(mesh.faces(), faces) << name;
    EXPECT_EQ(mesh.skipped.warnings, warnings) << name;
  };
  const std::string corners = "0 0 0\n1 0 0\n0 1 0\n", face = "3 0 1 2\n";
  expect("all.stl", binary_stl(3, 3), 3, {});
  expect("few.stl", binary_stl(2, 5), 2, {"3 facets follow those that it announces: left out"});
  expect("one.stl", binary_stl(2, 3), 2, {"1 facet follows those that it announces: left out"});
  expect("padded.stl", binary_stl(2, 2) + "any bytes", 2, {});
  expect("all.off", "OFF\n3 2 0\n" + corners + face + face + "\n# the end\n", 2, {});
  expect("few.off", "OFF\n3 1 0\n" + corners + face + "\n# more\n" + face + face, 1,
         {"2 lines follow what it announces: left out"});
  const auto ply = [&](int announced, const std::string& lines) {
    return fmt::format(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n{}",
        announced, corners + lines);
  };
  expect("all.ply", ply(2, face + face + "\n"), 2, {});
  expect("few.ply", ply(2, face + face + face), 2, {"1 line follows what it announces: left out"});
}

TEST_F(MeshTest, AFileTellsItsFormatByItsBeginning) {
  EXPECT_EQ(read_mesh(file("mesh.dat", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")).faces(), 1u);
  EXPECT_EQ(read_mesh(file("mesh.obj", survey_ply("ascii"))).faces(), 1u);
  EXPECT_EQ(read_mesh(file("MESH.OBJ", cube())).faces(), 6u);
}

}  // namespace
}  // namespace displayfile
