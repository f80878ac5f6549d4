// Meshes as their authors made them: the colours of each format that is read here, against the
// file's own numbers.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "clip/base/error.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/mesh/obj_materials.h"
#include "tests/import_library_leaks.h"
#include "tests/mesh_colours.h"

namespace displayfile {
namespace {

using namespace test;

// ---- OBJ and its material library ------------------------------------------------------

TEST_F(MeshColours, ObjFacesHaveTheColoursOfTheirMaterials) {
  file("two.mtl",
       "# a library\r\nnewmtl red\r\nNs 10\r\nKd 0.8 0.1 0.05\r\nd 1.0\r\n\r\n"
       "newmtl Hard Shiny Plastic\nKd .5\n\nnewmtl no colour\nKa 1 1 1\nKd spectral a.rfl\n");
  const std::string text = "mtllib two.mtl\n" + std::string(kFourCorners) + kFourFaces[0] +
                           "usemtl red\n" + kFourFaces[1] + "usemtl  Hard Shiny Plastic \n" +
                           kFourFaces[2] + "usemtl no colour\n" + kFourFaces[3];
  const Mesh mesh = read("a.obj", text);
  expect_colours(mesh, {std::nullopt, Colour(0.8, 0.1, 0.05), Colour(0.5), std::nullopt});
  EXPECT_EQ(said_of(mesh), "0 textured, 0 transparent\n");
}

TEST_F(MeshColours, ObjLibrariesMayComeAfterwardsAndBeSeveral) {
  file("a.mtl", "newmtl a\nKd 1 0 0\n");
  file("b c.mtl", "newmtl b\nKd 0 1 0\n");
  file("d.mtl", "newmtl d\nKd 0 0 1\n");
  const std::string faces = std::string(kFourCorners) + "usemtl a\n" + kFourFaces[0] +
                            "usemtl b\n" + kFourFaces[1] + "usemtl d\n" + kFourFaces[2];
  const Colours expected = {Colour(1, 0, 0), Colour(0, 1, 0), Colour(0, 0, 1)};
  expect_colours(read("x.obj", faces + "mtllib a.mtl d.mtl\nmtllib b c.mtl\n"), expected);
  expect_colours(
      read("x.obj", "mtllib .\\a.mtl\nmtllib C:\\somewhere\\b c.mtl\nmtllib d.mtl\n" + faces),
      expected);
}

TEST_F(MeshColours, ObjLibrariesElsewhereAreNotRead) {
  const std::string faces = std::string(kFourCorners) + "usemtl a\n" + kFourFaces[0];
  const std::filesystem::path elsewhere = file("elsewhere.mtl", "newmtl a\nKd 1 0 0\n");
  const auto folder = elsewhere.parent_path() / "within";
  std::filesystem::create_directories(folder / "below");
  std::filesystem::create_symlink(elsewhere, folder / "link.mtl");
  std::filesystem::copy_file(elsewhere, folder / "below/own.mtl");
  const auto expect = [&](const std::string& library, const std::optional<Colour>& colour) {
    expect_colours(read("within/x.obj", "mtllib " + library + "\n" + faces), {colour});
  };
  expect("below/own.mtl", Colour(1, 0, 0));
  expect("../elsewhere.mtl", std::nullopt);
  expect(elsewhere.string(), std::nullopt);
  expect("link.mtl", std::nullopt);
}

/// The libraries named by an OBJ file and its faces' materials, where they are missing.
TEST_F(MeshColours, ObjSaysOnceWhatIsMissing) {
  const std::string faces = std::string(kFourCorners) + "usemtl a\n" + kFourFaces[0] +
                            "usemtl b\n" + kFourFaces[1] + "usemtl a\n" + kFourFaces[2];
  Mesh mesh = read("x.obj", "mtllib gone.mtl\nmtllib gone.mtl\n" + faces);
  expect_colours(mesh, {std::nullopt, std::nullopt, std::nullopt});
  EXPECT_TRUE(mesh.face_materials.empty()) << "it takes no memory";
  EXPECT_EQ(said_of(mesh), "0 textured, 0 transparent\nno material library 'gone.mtl' beside it\n");
  EXPECT_EQ(said_of(read("x.obj", faces)),
            "0 textured, 0 transparent\nno library has its material 'a' and 1 more\n");
  EXPECT_EQ(said_of(read("x.obj", "mtllib gone.mtl\n" + std::string(kFourCorners) + kFourFaces[0])),
            "0 textured, 0 transparent\n")
      << "no face has a material";
  file("x.mtl", "newmtl b\nKd 0 1 0\n");
  mesh = read("x.obj", "mtllib gone.mtl\n" + faces);
  expect_colours(mesh, {std::nullopt, Colour(0, 1, 0), std::nullopt});
  EXPECT_EQ(said_of(mesh), "0 textured, 0 transparent\nno library has its material 'a'\n")
      << "a renamed pair";
}

TEST_F(MeshColours, TexturesAndTransparencyAreCounted) {
  file("a.mtl",
       "newmtl a\nKd 1 0 0\nmap_Kd -s 1 1 1 wood.png\nnewmtl b\nd 0.5\nKd 0 1 0\n"
       "newmtl c\nTr 0.25\nnewmtl d\nd 1\nTr 1\nmap_Bump b.png\nnewmtl halo\nd -halo 0.5\n");
  std::string text = "mtllib a.mtl\n" + std::string(kFourCorners);
  for (const char* material : {"a", "b", "c", "d", "halo", "a"}) {
    text += fmt::format("usemtl {}\nf 1 2 3\nf 1 2\nf 1 1 2\n", material);
  }
  const Mesh mesh = read("a.obj", text);
  EXPECT_EQ(said_of(mesh), "2 textured, 3 transparent\n") << "of faces that are drawn";
  const Colour red(1, 0, 0);
  expect_colours(mesh, {red, Colour(0, 1, 0), std::nullopt, std::nullopt, std::nullopt, red});
}

TEST_F(MeshColours, ObjectsThatGoOnKeepTheirFacesColours) {
  file("a.mtl", "newmtl r\nKd 1 0 0\nnewmtl g\nKd 0 1 0\n");
  const Mesh mesh = read("a.obj", "mtllib a.mtl\n" + std::string(kFourCorners) +
                                      "o one\nusemtl r\nf 1 2 3\no two\nf 1 2 4\nf 1 1 2\n"
                                      "usemtl g\nf 2 3 4\no one\nf 1 3 4\n");
  const Colour red(1, 0, 0), green(0, 1, 0);
  expect_colours(mesh, {red, green, red, green});
}

TEST_F(MeshColours, BadMaterialLibrariesAreRefused) {
  const auto refused = [&](const std::string& library, const std::string& expected) {
    file("bad.mtl", library);
    expect_refused(file("a.obj", "mtllib bad.mtl\n" + std::string(kFourCorners) + kFourFaces[0]),
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

/// Colours beyond the range are clamped; statements outside a material are ignored.
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
  const std::string text = std::string(kFourCorners) + kFourFaces[0] + kFourFaces[1];
  const Mesh mesh = read("a.obj", text);
  EXPECT_EQ(mesh.materials.capacity(), 0u);
  EXPECT_EQ(mesh.face_materials.capacity(), 0u);
}

}  // namespace
}  // namespace displayfile
