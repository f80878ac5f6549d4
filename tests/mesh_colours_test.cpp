// Meshes as their authors made them: the colours of each format against the file's own numbers,
// what becomes of them in a display file, and detail that must not be lost.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "clip/error.h"
#include "displayfile/mesh/import_library.h"
#include "displayfile/mesh/lost_detail.h"
#include "displayfile/mesh/material_library.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/text/drawing_program.h"
#include "displayfile/text/dump.h"
#include "interp/raster/software.h"
#include "tests/temporary_folder.h"

/// The import library does not free all that it took for a file that it refuses.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libassimp"; }

namespace displayfile {
namespace {

using Colours = std::vector<std::optional<Colour>>;
constexpr std::nullopt_t kNone = std::nullopt;

Colours colours_of(const Mesh& mesh) {
  Colours colours;
  for (std::size_t i = 0; i < mesh.faces(); ++i) colours.push_back(mesh.colour(i));
  return colours;
}

std::string text_of(const Colours& colours) {
  std::string text;
  for (const auto& c : colours) text += c ? fmt::format("({} {} {})", c->r, c->g, c->b) : "(none)";
  return text;
}

class MeshColours : public test::TemporaryFolder {
 protected:
  std::string file(const std::string& name, const std::string& text) const {
    return TemporaryFolder::file(name, text).string();
  }

  Mesh read(const std::string& name, const std::string& text) const {
    return read_mesh(file(name, text));
  }

  void expect_colours(const Mesh& mesh, const Colours& expected) const {
    EXPECT_EQ(text_of(colours_of(mesh)), text_of(expected));
  }

  void expect_refused(const std::string& path, const std::string& expected) const {
    try {
      read_mesh(path);
      ADD_FAILURE() << path << " was accepted";
    } catch (const Error& e) {
      EXPECT_NE(std::string(e.what()).find(expected), std::string::npos)
          << e.what() << "\ndoes not say: " << expected;
    }
  }
};

constexpr const char* kFour = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
constexpr const char* kFourFaces[] = {"f 1 3 2\n", "f 1 2 4\n", "f 1 4 3\n", "f 2 3 4\n"};

/// What reading says beside faces: one line each.
std::string said_of(const Mesh& mesh) {
  std::string text = fmt::format("{} textured, {} transparent\n", mesh.skipped.textured_faces,
                                 mesh.skipped.transparent_faces);
  for (const std::string& warning : mesh.skipped.warnings) text += warning + "\n";
  return text;
}

// ---- OBJ and its material library ------------------------------------------------------

TEST_F(MeshColours, ObjFacesHaveTheColoursOfTheirMaterials) {
  file("two.mtl",
       "# a library\r\nnewmtl red\r\nNs 10\r\nKd 0.8 0.1 0.05\r\nd 1.0\r\n\r\n"
       "newmtl Hard Shiny Plastic\nKd .5\n\nnewmtl no colour\nKa 1 1 1\nKd spectral a.rfl\n");
  const std::string text = "mtllib two.mtl\n" + std::string(kFour) + kFourFaces[0] +
                           "usemtl red\n" + kFourFaces[1] + "usemtl  Hard Shiny Plastic \n" +
                           kFourFaces[2] + "usemtl no colour\n" + kFourFaces[3];
  const Mesh mesh = read("a.obj", text);
  expect_colours(mesh, {kNone, Colour(0.8, 0.1, 0.05), Colour(0.5), kNone});
  EXPECT_EQ(said_of(mesh), "0 textured, 0 transparent\n");
}

TEST_F(MeshColours, ObjLibrariesMayComeAfterwardsAndBeSeveral) {
  file("a.mtl", "newmtl a\nKd 1 0 0\n");
  file("b c.mtl", "newmtl b\nKd 0 1 0\n");
  file("d.mtl", "newmtl d\nKd 0 0 1\n");
  const std::string faces = std::string(kFour) + "usemtl a\n" + kFourFaces[0] + "usemtl b\n" +
                            kFourFaces[1] + "usemtl d\n" + kFourFaces[2];
  const Colours expected = {Colour(1, 0, 0), Colour(0, 1, 0), Colour(0, 0, 1)};
  expect_colours(read("x.obj", faces + "mtllib a.mtl d.mtl\nmtllib b c.mtl\n"), expected);
  expect_colours(
      read("x.obj", "mtllib .\\a.mtl\nmtllib C:\\somewhere\\b c.mtl\nmtllib d.mtl\n" + faces),
      expected);
}

/// The libraries that an OBJ file's name and its faces' materials say, where they are not there.
TEST_F(MeshColours, ObjSaysOnceWhatIsMissing) {
  const std::string faces = std::string(kFour) + "usemtl a\n" + kFourFaces[0] + "usemtl b\n" +
                            kFourFaces[1] + "usemtl a\n" + kFourFaces[2];
  Mesh mesh = read("x.obj", "mtllib gone.mtl\nmtllib gone.mtl\n" + faces);
  expect_colours(mesh, {kNone, kNone, kNone});
  EXPECT_TRUE(mesh.face_materials.empty()) << "it takes no memory";
  EXPECT_EQ(said_of(mesh), "0 textured, 0 transparent\nno material library 'gone.mtl' beside it\n");
  EXPECT_EQ(said_of(read("x.obj", faces)),
            "0 textured, 0 transparent\nno library has its material 'a' and 1 more\n");
  EXPECT_EQ(said_of(read("x.obj", "mtllib gone.mtl\n" + std::string(kFour) + kFourFaces[0])),
            "0 textured, 0 transparent\n")
      << "no face has a material";
  file("x.mtl", "newmtl b\nKd 0 1 0\n");
  mesh = read("x.obj", "mtllib gone.mtl\n" + faces);
  expect_colours(mesh, {kNone, Colour(0, 1, 0), kNone});
  EXPECT_EQ(said_of(mesh), "0 textured, 0 transparent\nno library has its material 'a'\n")
      << "a renamed pair";
}

TEST_F(MeshColours, TexturesAndTransparencyAreCounted) {
  file("a.mtl",
       "newmtl a\nKd 1 0 0\nmap_Kd -s 1 1 1 wood.png\nnewmtl b\nd 0.5\nKd 0 1 0\n"
       "newmtl c\nTr 0.25\nnewmtl d\nd 1\nTr 1\nmap_Bump b.png\nnewmtl halo\nd -halo 0.5\n");
  std::string text = "mtllib a.mtl\n" + std::string(kFour);
  for (const char* material : {"a", "b", "c", "d", "halo", "a"}) {
    text += fmt::format("usemtl {}\nf 1 2 3\nf 1 2\nf 1 1 2\n", material);
  }
  const Mesh mesh = read("a.obj", text);
  EXPECT_EQ(said_of(mesh), "2 textured, 3 transparent\n") << "of faces that are drawn";
  const Colour red(1, 0, 0);
  expect_colours(mesh, {red, Colour(0, 1, 0), kNone, kNone, kNone, red});
}

TEST_F(MeshColours, ObjectsThatGoOnKeepTheirFacesColours) {
  file("a.mtl", "newmtl r\nKd 1 0 0\nnewmtl g\nKd 0 1 0\n");
  const Mesh mesh = read("a.obj", "mtllib a.mtl\n" + std::string(kFour) +
                                      "o one\nusemtl r\nf 1 2 3\no two\nf 1 2 4\nf 1 1 2\n"
                                      "usemtl g\nf 2 3 4\no one\nf 1 3 4\n");
  const Colour red(1, 0, 0), green(0, 1, 0);
  expect_colours(mesh, {red, green, red, green});
}

TEST_F(MeshColours, BadMaterialLibrariesAreRefused) {
  const auto refused = [&](const std::string& library, const std::string& expected) {
    file("bad.mtl", library);
    expect_refused(file("a.obj", "mtllib bad.mtl\n" + std::string(kFour) + kFourFaces[0]),
                   expected);
  };
  refused("newmtl a\nKd 0.5 nan 0\n", "bad.mtl:2:8: 'nan': expected a part of a colour, finite");
  refused("newmtl a\nKd 0.5 0.5 inf\n", "bad.mtl:2:12: 'inf'");
  refused("newmtl a\nKd 1e999 0 0\n", "bad.mtl:2:4: '1e999': expected a part of a colour");
  refused("newmtl a\nKd 0.5 0.5", "bad.mtl:2:11: end of line: expected a part of a colour");
  refused("newmtl a\nKd", "bad.mtl:2:3: end of line");
  refused("newmtl a\nKd 1 0.", "bad.mtl:2:8: end of line");
  refused("newmtl a\nd\n", "bad.mtl:2:2: end of line");
  refused("newmtl a\nTr x\n", "bad.mtl:2:4: 'x'");
  refused("newmtl a\nKd red 0 0\n", "bad.mtl:2:4: 'red'");
  refused("newmtl a\nK" + std::string(1, '\0') + "d 1 0 0\n", "bad.mtl:2:2: binary data");
}

/// Colours beyond the range are brought into it; statements of no material say nothing.
TEST_F(MeshColours, OddMaterialLibrariesAreRead) {
  const auto read = [&](const std::string& text) {
    return read_material_library({"a.mtl", text, false});
  };
  EXPECT_TRUE(read("").empty());
  EXPECT_TRUE(read("Kd nan\nd x\n\xFF\n").empty());
  EXPECT_EQ(read("newmtl\nKd 1 0 0").at("").colour, Colour(1, 0, 0));
  EXPECT_EQ(read("newmtl a\nKd 1.5 -1 1e300\n").at("a").colour, Colour(1, 0, 1));
  EXPECT_FALSE(std::signbit(read("newmtl a\nKd -0 0 0\n").at("a").colour->r));
  EXPECT_EQ(read("newmtl a\nKd 1 0 0\nnewmtl b\nnewmtl a\nKd 0 0 1 # blue\n").at("a").colour,
            Colour(0, 0, 1));
  std::string many;
  for (int i = 0; i < 100000; ++i) many += fmt::format("newmtl m{}\nKd {}\n", i, i / 1e5);
  const MaterialLibrary library = read(many);
  EXPECT_EQ(library.size(), 100000u);
  EXPECT_EQ(library.at("m25000").colour, Colour(0.25));
  EXPECT_EQ(read("newmtl " + std::string(1000000, 'x') + "\nKd 1\n").size(), 1u);
}

// ---- Colours of vertices and of faces --------------------------------------------------

TEST_F(MeshColours, ObjVerticesMayHaveColours) {
  const auto colours = [&](const std::string& vertices, const std::string& faces = "f 1 2 3\n") {
    return text_of(colours_of(read("a.obj", vertices + faces)));
  };
  EXPECT_EQ(colours("v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0.5 0.5 0\n"), "(0.5 0.5 0)");
  EXPECT_EQ(colours("v 0 0 0 255 0 51\nv 1 0 0 255 0 51\nv 0 1 0 255 0 51\n"), "(1 0 0.2)");
  EXPECT_EQ(colours("v 0 0 0 .1 .2 .3\nv 1 0 0 .1 .2 .3\nv 0 1 0 .1 .2 .3\n"), "(0.1 0.2 0.3)");
  EXPECT_EQ(colours("v 0 0 0\nv 1 0 0 0 0.5 0\nv 0 1 0\nv 0 0 1\n", "f 1 2 3\nf 1 3 4\n"),
            "(0 0.5 0)(none)")
      << "the mean of those that have one";
  EXPECT_EQ(colours("v 0 0 0 1\nv 1 0 0 1 a b\nv 0 1 0 1 1\n"), "(none)");
  expect_refused(file("b.obj", "v 0 0 0 1 nan 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), ":1:11: 'nan'");
}

TEST_F(MeshColours, AMaterialMultipliesTheColoursOfVertices) {
  file("a.mtl", "newmtl half\nKd 0.5 0.5 1\nmap_Kd a.png\n");
  const Mesh mesh = read("a.obj",
                         "mtllib a.mtl\nv 0 0 0 1 0 1\nv 1 0 0 1 0 1\nv 0 1 0 1 0 1\nv 0 0 1\n"
                         "v 1 0 1\nv 1 1 1\nf 1 2 3\nusemtl half\nf 1 2 3\nf 4 5 6\n");
  expect_colours(mesh, {Colour(1, 0, 1), Colour(0.5, 0, 1), Colour(0.5, 0.5, 1)});
  EXPECT_EQ(mesh.skipped.textured_faces, 2u);
}

TEST_F(MeshColours, OffFacesAndVertices) {
  const auto colours = [&](const std::string& text) {
    return text_of(colours_of(read("a.off", text)));
  };
  const std::string corners = "3 3 0\n0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(colours("OFF\n" + corners + "3 0 1 2 255 0 51\n3 0 1 2\n3 0 1 2 0 255 0 128 # half\n"),
            "(1 0 0.2)(none)(0 1 0)");
  EXPECT_EQ(read("a.off", "OFF\n" + corners + "3 0 1 2 255 0 51\n3 0 1 2\n3 0 1 2 0 255 0 128\n")
                .skipped.transparent_faces,
            1u);
  EXPECT_EQ(colours("OFF\n" + corners + "3 0 1 2 0.8 0.1 0.2\n3 0 1 2 1 0 0 1\n3 0 1 2 7\n"),
            "(0.8 0.1 0.2)(1 0 0)(none)")
      << "one number is of a map of colours";
  EXPECT_EQ(colours("OFF\n" + corners + "3 0 1 2 red green blue\n3 0 1 2 1 2\n3 0 1 2\n"),
            "(none)(none)(none)");
  const std::string face = "3 0 1 2\n";
  EXPECT_EQ(colours("COFF\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 0 1 0 1\n0 1 0 0.5 0.5 0 1\n" + face),
            "(0.5 0.5 0)");
  EXPECT_EQ(
      colours("COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 255 0 0 255\n0 1 0 255 0 0 255\n" + face),
      "(1 0 0)");
  EXPECT_EQ(colours("STCNOFF\n3 1 0\n0 0 0 0 0 1 1 0 0 1 0 0\n1 0 0 0 0 1 1 0 0 1 0 0\n"
                    "0 1 0 0 0 1 1 0 0 1 0 0\n" +
                    face),
            "(1 0 0)");
  EXPECT_EQ(colours("COFF\n3 2 0\n0 0 0 0 0 1 1\n1 0 0 0 0 1 1\n0 1 0 0 0 1 1\n" + face +
                    "3 0 1 2 255 0 0\n"),
            "(0 0 1)(1 0 0)")
      << "a face's own colour holds";
  expect_refused(file("b.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 1 nan 0\n"), ":6:11:");
}

std::string bytes(auto value) {
  const auto array = std::bit_cast<std::array<char, sizeof(value)>>(value);
  return {array.begin(), array.end()};
}

TEST_F(MeshColours, PlyVerticesAndFaces) {
  const auto ply = [&](const std::string& vertex, const std::string& face,
                       const std::string& data) {
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\n" +
        vertex + "element face 2\nproperty list uchar int vertex_indices\n" + face +
        "end_header\n" + data;
    return read_mesh(file("a.ply", text));
  };
  const auto parts = [](const std::string& type, const std::string& before = "") {
    return fmt::format("property {0} {1}red\nproperty {0} {1}green\nproperty {0} {1}blue\n", type,
                       before);
  };
  const auto colours = [](const Mesh& mesh) { return text_of(colours_of(mesh)); };
  const std::string faces = "3 0 1 2\n3 2 1 0\n";
  EXPECT_EQ(
      colours(ply(parts("uchar"), "", "0 0 0 255 0 51\n1 0 0 255 0 51\n0 1 0 255 0 51\n" + faces)),
      "(1 0 0.2)(1 0 0.2)");
  EXPECT_EQ(colours(ply(parts("float", "diffuse_"), "",
                        "0 0 0 1 0 .5\n1 0 0 0 0 .5\n0 1 0 .5 0 .5\n" + faces)),
            "(0.5 0 0.5)(0.5 0 0.5)");
  EXPECT_EQ(colours(ply(parts("ushort"), "",
                        "0 0 0 65535 0 0\n1 0 0 65535 0 0\n0 1 0 65535 0 0\n" + faces)),
            "(1 0 0)(1 0 0)");
  EXPECT_EQ(
      colours(ply("", parts("int"), "0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n3 2 1 0 0 51 0\n")),
      "(1 0 0)(0 0.2 0)");
  const Mesh both = ply(parts("uchar"), parts("uchar") + "property uchar alpha\n",
                        "0 0 0 255 0 0\n1 0 0 255 0 0\n0 1 0 255 0 0\n"
                        "3 0 1 2 0 255 0 255\n3 2 1 0 0 0 255 0\n");
  EXPECT_EQ(colours(both), "(0 1 0)(0 0 1)");
  EXPECT_EQ(both.skipped.transparent_faces, 1u);
  EXPECT_EQ(colours(ply("property uchar red\nproperty uchar green\n", "",
                        "0 0 0 255 0\n1 0 0 255 0\n0 1 0 255 0\n" + faces)),
            "(none)(none)")
      << "two parts are no colour";
  const auto bad = [&](const std::string& data) { return ply(parts("float"), "", data); };
  EXPECT_THROW(bad("0 0 0 nan 0 0\n1 0 0 1 0 0\n0 1 0 1 0 0\n" + faces), Error);

  std::string binary =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\n"
      "property float y\nproperty float z\n" +
      parts("uchar") +
      "property uchar alpha\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  for (int v = 0; v < 3; ++v) {
    binary += bytes(v == 1 ? 1.0f : 0.0f) + bytes(v == 2 ? 1.0f : 0.0f) + bytes(0.0f);
    binary += bytes(std::uint8_t{102}) + bytes(std::uint8_t{51}) + '\0' + bytes(std::uint8_t{255});
  }
  binary += '\3' + bytes(0) + bytes(1) + bytes(2);
  if constexpr (std::endian::native == std::endian::little) {
    EXPECT_EQ(colours(read("b.ply", binary)), "(0.4 0.2 0)");
  }
}

/// However many colours there are, a face's is its own: more than a palette remembers.
TEST_F(MeshColours, EveryFaceMayHaveAColourOfItsOwn) {
  constexpr int kFaces = 20000;
  std::string text = fmt::format("OFF\n3 {} 0\n0 0 0\n1 0 0\n0 1 0\n", 2 * kFaces);
  for (int i = 0; i < 2 * kFaces; ++i) {
    const int k = i % kFaces;
    text += fmt::format("3 0 1 2 {} {} 255\n", k % 256, k / 256);
  }
  const Mesh mesh = read("a.off", text);
  for (std::size_t i = 0; i < mesh.faces(); ++i) {
    const int k = static_cast<int>(i) % kFaces;
    ASSERT_EQ(mesh.colour(i), Colour(k % 256 / 255.0, k / 256 / 255.0, 1.0)) << i;
  }
  std::string few = fmt::format("OFF\n3 {} 0\n0 0 0\n1 0 0\n0 1 0\n", kFaces);
  for (int i = 0; i < kFaces; ++i) few += fmt::format("3 0 1 2 {} 0 255\n", i % 5 * 50);
  EXPECT_EQ(read("b.off", few).materials.size(), 5u);
}

TEST_F(MeshColours, MeshesWithoutColoursHaveNoTable) {
  const std::string text = std::string(kFour) + kFourFaces[0] + kFourFaces[1];
  const Mesh mesh = read("a.obj", text);
  EXPECT_EQ(mesh.materials.capacity(), 0u);
  EXPECT_EQ(mesh.face_materials.capacity(), 0u);
}

// ---- Through the import library --------------------------------------------------------

/// One triangle a material; its buffer holds positions, and colours of vertices.
std::string gltf(const std::string& materials, const std::vector<std::string>& primitives) {
  std::string all;
  for (const std::string& p : primitives) {
    all += fmt::format("{}{{\"attributes\":{{\"POSITION\":0{}", all.empty() ? "" : ",", p);
  }
  return fmt::format(R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],
      "nodes":[{{"mesh":0,"name":"part"}}],"meshes":[{{"primitives":[{}]}}],"materials":[{}],
      "accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",
                     "min":[0,0,0],"max":[1,1,0]}},
                   {{"bufferView":1,"componentType":5126,"count":3,"type":"VEC3"}}],
      "bufferViews":[{{"buffer":0,"byteLength":36}},
                     {{"buffer":0,"byteOffset":36,"byteLength":36}}],
      "buffers":[{{"uri":"a.bin","byteLength":72}}]}})",
                     all, materials);
}

/// A primitive without a material is white, as the format says.
TEST_F(MeshColours, GltfBaseColours) {
  if (!import_library_version()) GTEST_SKIP() << "no import library";
  std::string buffer;
  for (const float c : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) buffer += bytes(c);
  for (int i = 0; i < 3; ++i) buffer += bytes(0.5f) + bytes(1.0f) + bytes(0.0f);
  file("a.bin", buffer);
  const Mesh mesh =
      read("a.gltf",
           gltf(R"({"name":"red","pbrMetallicRoughness":{"baseColorFactor":[0.75,0.125,0.5,1]}},
              {"pbrMetallicRoughness":{"baseColorFactor":[0,1,0,0.5]},"alphaMode":"BLEND"},
              {"pbrMetallicRoughness":{"baseColorFactor":[0,0,1,0.5]}},
              {"name":"white","doubleSided":true})",
                {"},\"material\":0}", "},\"material\":1}", "},\"material\":2}", "},\"material\":3}",
                 "}}", ",\"COLOR_0\":1},\"material\":0}", ",\"COLOR_0\":1}}"}));
  expect_colours(mesh, {Colour(0.75, 0.125, 0.5), Colour(0, 1, 0), Colour(0, 0, 1), Colour(1.0),
                        Colour(1.0), Colour(0.375, 0.125, 0), Colour(0.5, 1, 0)});
  EXPECT_EQ(said_of(mesh), "0 textured, 1 transparent\n");
}

std::string ac3d(const std::string& vertices) {
  return "AC3Db\nMATERIAL \"tiles\" rgb 0.75 0.25 0.125  amb 0.2 0.2 0.2  emis 0 0 0  "
         "spec 0.2 0.2 0.2  shi 10  trans 0\nOBJECT world\nkids 1\nOBJECT poly\nname \"roof\"\n"
         "numvert 4\n" +
         vertices +
         "numsurf 2\nSURF 0x20\nmat 0\nrefs 3\n0 0 0\n1 0 0\n2 0 0\nSURF 0x20\nmat 0\nrefs 3\n"
         "0 0 0\n2 0 0\n3 0 0\nkids 0\n";
}

TEST_F(MeshColours, OtherFormatsBringTheirMaterials) {
  if (!import_library_version()) GTEST_SKIP() << "no import library";
  const Mesh mesh = read("a.ac", ac3d("0 0 0\n1 0 0\n1 1 0\n0 1 0\n"));
  expect_colours(mesh, {Colour(0.75, 0.25, 0.125), Colour(0.75, 0.25, 0.125)});
  EXPECT_EQ(said_of(mesh), "0 textured, 0 transparent\n");
}

// ---- Models of the Debian package assimp-testmodels ------------------------------------

const std::filesystem::path kModels = "/usr/share/assimp/models";

/// How many faces have which colour, in the shortest form of three decimals.
std::map<std::string, int> counted(const Mesh& mesh) {
  std::map<std::string, int> counts;
  for (const auto& c : colours_of(mesh)) {
    ++counts[c ? fmt::format("{:.3f} {:.3f} {:.3f}", c->r, c->g, c->b) : "none"];
  }
  return counts;
}

TEST_F(MeshColours, OfModelsAreThoseOfTheirFiles) {
  if (!std::filesystem::exists(kModels)) GTEST_SKIP() << "no models in " << kModels;
  struct Model {
    const char* path;
    std::map<std::string, int> faces;
    std::size_t textured;
  };
  const Model models[] = {
      {"OBJ/spider.obj",
       {{"0.827 0.792 0.773", 260}, {"0.800 0.800 0.800", 972}, {"0.690 0.639 0.616", 80}},
       1312},
      {"OBJ/space_in_material_name.obj", {{"0.141 0.184 0.412", 1}}, 0},
      {"PLY/float-color.ply", {{"0.000 0.000 1.000", 1}}, 0},
      {"glTF/TwoBoxes/TwoBoxes.gltf", {{"0.800 0.000 0.000", 24}}, 0},
      {"glTF2/glTF-Sample-Models/AnimatedMorphCube-glTF/AnimatedMorphCube.gltf",
       {{"0.604 0.604 0.604", 12}},
       0},
      {"Collada/cube_triangulate.dae", {{"0.137 0.404 0.871", 12}}, 0},
      {"AC/Wuson.ac", {{"1.000 1.000 1.000", 0}}, 0},
  };
  for (const Model& model : models) {
    if (!std::filesystem::exists(kModels / model.path)) continue;
    const Mesh mesh = [&] {
      try {
        return read_mesh((kModels / model.path).string());
      } catch (const Error& e) {
        EXPECT_FALSE(import_library_version()) << e.what();
        return Mesh{};
      }
    }();
    if (mesh.faces() == 0) continue;
    std::map<std::string, int> found = counted(mesh);
    EXPECT_EQ(found.size(), model.faces.size()) << model.path;
    for (const auto& [colour, faces] : model.faces) {
      EXPECT_TRUE(found.contains(colour)) << model.path << ": " << colour;
      if (faces == 0) continue;  // however many
      EXPECT_EQ(found[colour], faces) << model.path << ": " << colour;
    }
    EXPECT_EQ(mesh.skipped.textured_faces, model.textured) << model.path;
  }
}

// ---- Entering --------------------------------------------------------------------------

/// The colour of each polygon, lines between them where segments begin.
std::string fills_of(const DisplayFile& file) {
  struct Fills {
    std::string text, now = "unset";
    void fill(const FillStyle& style) {
      const Colour& c = style.colour;
      now =
          style.kind == FillStyle::Kind::hollow ? "hollow" : fmt::format("{} {} {}", c.r, c.g, c.b);
    }
    void line_style(const LineStyle&) {}
    void pick(int) {}
    void move(const Point3&) {}
    void line(const Point3&) {}
    void polygon(std::span<const Point3>, std::span<const std::int32_t>) { text += now + ";"; }
  };
  std::string text;
  for (const Segment& segment : file.segments()) {
    Fills fills;
    segment.walk_drawn(fills);
    text += fills.text + "|";
  }
  return text;
}

class EnteredColours : public MeshColours {
 protected:
  EnteredColours() {
    file("a.mtl", "newmtl r\nKd 1 0 0\nnewmtl g\nKd 0 1 0\n");
    path_ = file("a.obj", "mtllib a.mtl\n" + std::string(kFour) +
                              "o mixed\nf 1 3 2\nusemtl r\nf 1 2 4\nusemtl g\nf 1 4 3\n"
                              "o green\nf 2 3 4\no \xC3\xA4 none\xFF\nusemtl none\nf 1 2 3\n");
  }

  /// In the default view, where all is seen, in light that is the same everywhere.
  std::string fills(const std::string& program, const MeshOptions& options = {}) const {
    GraphicsSystem system;
    replay("set-window -9 9 -9 9\nset-light 0 0 1 1\n" + program, "program", system);
    import_mesh(path_, system, options);
    system.open_segment(99);
    system.polygon_abs_3({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    system.close_segment();
    return fills_of(system.display_file());
  }

  std::string path_;
};

TEST_F(EnteredColours, AreFillStylesOfFacesAlone) {
  EXPECT_EQ(fills(""), "0.87 0.85 0.81;1 0 0;0 1 0;|0 1 0;|0.87 0.85 0.81;|0.8 0.8 0.8;|");
  EXPECT_EQ(fills("set-shading gouraud\n"),
            "0.87 0.85 0.81;1 0 0;0 1 0;|0 1 0;|0.87 0.85 0.81;|0.8 0.8 0.8;|")
      << "with normals of vertices";
}

TEST_F(EnteredColours, GiveWayToTheProgramsFillStyleAndToTheOption) {
  EXPECT_EQ(fills("set-fill-style solid 0 0 1\n"), "0 0 1;0 0 1;0 0 1;|0 0 1;|0 0 1;|0 0 1;|");
  EXPECT_EQ(fills("set-fill-style hollow\n"), "hollow;hollow;hollow;|hollow;|hollow;|hollow;|");
  const MeshOptions purple{.camera = {}, .colour = Colour(0.5, 0, 0.5)};
  EXPECT_EQ(fills("", purple),
            "0.5 0 0.5;0.5 0 0.5;0.5 0 0.5;|0.5 0 0.5;|0.5 0 0.5;|0.8 0.8 0.8;|");
  EXPECT_EQ(fills("set-fill-style solid 0 0 1\n", purple),
            "0.5 0 0.5;0.5 0 0.5;0.5 0 0.5;|0.5 0 0.5;|0.5 0 0.5;|0 0 1;|");
}

/// What a bare mesh sets for itself is not what a program set.
TEST_F(EnteredColours, OfASecondMeshHoldToo) {
  GraphicsSystem system;
  import_mesh(path_, system);
  EXPECT_FALSE(system.said().contains(Setting::fill_style));
  import_mesh(path_, system);
  EXPECT_FALSE(system.said().contains(Setting::fill_style));
  const std::string twice = fills_of(system.display_file());
  EXPECT_EQ(twice.substr(0, twice.size() / 2), twice.substr(twice.size() / 2)) << twice;
  system.set_fill_style({FillStyle::Kind::hollow});
  EXPECT_TRUE(system.said().contains(Setting::fill_style));
}

TEST_F(EnteredColours, AreRecordedWithTheNamesOfObjects) {
  for (const MeshOptions& options :
       {MeshOptions{}, MeshOptions{.camera = {}, .colour = Colour(0.5, 0.25, 0)}}) {
    for (const Shading shading : {Shading::flat, Shading::gouraud}) {
      GraphicsSystem imported, replayed;
      std::ostringstream program;
      Recorder recorder(program);
      imported.set_recorder(&recorder);
      imported.set_shading(shading);
      import_mesh(path_, imported, options);
      replay(program.str(), "recorded", replayed);
      EXPECT_EQ(dump(imported.display_file()), dump(replayed.display_file()));
      EXPECT_NE(program.str().find("# mixed\nopen-segment 1\n"), std::string::npos);
      EXPECT_NE(program.str().find("# green\nopen-segment 2\n"), std::string::npos);
      EXPECT_NE(program.str().find("# \xC3\xA4 none?\nopen-segment 3\n"), std::string::npos);
      EXPECT_EQ(imported.attributes().fill, replayed.attributes().fill);
    }
  }
}

TEST_F(EnteredColours, ThatAreBadChangeNothing) {
  for (const Colour& colour : {Colour(1.5, 0, 0), Colour(0, -1, 0), Colour(0, 0, std::nan(""))}) {
    GraphicsSystem system;
    EXPECT_THROW(import_mesh(path_, system, {.camera = {}, .colour = colour}), Error);
    EXPECT_FALSE(system.view_was_set());
    EXPECT_TRUE(system.display_file().segments().empty());
    system.set_window(-9, 9, -9, 9);
    EXPECT_THROW(enter_mesh(read_mesh(path_), system, 1, {.camera = {}, .colour = colour}), Error);
    EXPECT_TRUE(system.display_file().segments().empty());
  }
}

// ---- Detail far from the origin --------------------------------------------------------

constexpr int kCells = 40;

/// A terrain of quarter metres, so that its coordinates, moved or not, are exact in binary.
std::string terrain(double east, double north) {
  std::string text;
  for (int j = 0; j <= kCells; ++j) {
    for (int i = 0; i <= kCells; ++i) {
      const double height = std::round(4 * std::sin(0.3 * i) * std::cos(0.4 * j)) / 4;
      text += fmt::format("v {} {} {}\n", east + 0.25 * i, height, north + 0.25 * j);
    }
  }
  for (int j = 0; j < kCells; ++j) {
    for (int i = 0; i < kCells; ++i) {
      const int a = j * (kCells + 1) + i + 1, b = a + kCells + 1;
      text += fmt::format("f {} {} {}\nf {} {} {}\n", a, b, b + 1, a, b + 1, a + 1);
    }
  }
  return text;
}

/// A survey's coordinates are no worse than those of the same mesh at the origin: the view is
/// fitted to both, and all that differs is what viewing rounds.
TEST_F(MeshColours, ASurveyIsDrawnAsTheSameMeshAtTheOrigin) {
  const auto ids = [&](const std::string& text) {
    GraphicsSystem system;
    import_mesh(file("a.obj", text), system);
    const RasterRequest request{
        .width = 400, .height = 400, .method = HiddenMethod::z_buffer, .ids = true};
    return draw_with_software(system.display_file(), request).ids;
  };
  const auto at_origin = ids(terrain(0, 0)), survey = ids(terrain(500000.25, 4000000.5));
  EXPECT_GT(std::ranges::count_if(at_origin, [](int id) { return id >= 0; }), 20000);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < at_origin.size(); ++i) wrong += at_origin[i] != survey[i] ? 1 : 0;
  EXPECT_EQ(wrong, 0u);
}

TEST(LostDetail, IsThatOfEdgesTooShortForSinglePrecision) {
  const auto said = [](double offset, double edge, int edges, int slivers = 0) {
    LostDetail detail;
    for (int i = 0; i < edges; ++i) {
      const double length = i < slivers ? 1e-9 : edge;
      detail.add_edge({offset, 0, 0}, {offset + length, 0, 0});
    }
    return detail.sentence().has_value();
  };
  EXPECT_FALSE(LostDetail{}.sentence());
  EXPECT_FALSE(said(0, 1e-30, 10)) << "near the origin single precision has all that is needed";
  EXPECT_FALSE(said(1, 1e-4, 10));
  EXPECT_TRUE(said(4e6, 10, 10)) << "multiples of a quarter";
  EXPECT_FALSE(said(4e6, 100, 10));
  EXPECT_FALSE(said(1000, 1, 100, 10)) << "a few slivers";
  EXPECT_TRUE(said(1000, 1, 100, 11));
}

TEST_F(MeshColours, FormatsOfSinglePrecisionSayWhatTheyLose) {
  if (!import_library_version()) GTEST_SKIP() << "no import library";
  const std::string survey =
      "500000 4000000 1\n500010 4000000 2\n500010 4000010 1\n500000 4000010 2\n";
  const std::string expected =
      "its coordinates, up to 4.00001e+06, were read in single precision, which rounds them to "
      "multiples of 0.25: 6 of 6 edges are too short for that\n";
  EXPECT_EQ(said_of(read("a.ac", ac3d(survey))), "0 textured, 0 transparent\n" + expected);
  expect_refused(file("a.ac", ac3d("500000 4000000 1\n500000 4000000.1 1\n500000.01 4000000 1\n"
                                   "500000 4000000 1\n")),
                 "no faces: expected polygons (found 0 points and lines, and 2 faces of fewer than "
                 "3 different vertices); its coordinates, up to 4e+06, were read in single");
  EXPECT_EQ(said_of(read("a.ac", ac3d("0 0 1\n10 0 2\n10 10 1\n0 10 2\n"))),
            "0 textured, 0 transparent\n");
}

}  // namespace
}  // namespace displayfile
