// Files by programs that deviate from their formats, or from the letter of them: line ends of one
// CR, bytes behind a binary STL, names in quotation marks, colours that no keyword announces,
// indices of missing elements. And formats that are not read are named.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/mesh/cad_format.h"
#include "displayfile/mesh/cad_import.h"
#include "displayfile/mesh/mesh.h"
#include "tests/error_of.h"
#include "tests/mesh_files.h"

namespace displayfile {
namespace {

using test::bytes;
using test::expect_error;
using Sentences = std::vector<std::string>;

class MeshDialects : public test::MeshFiles {};

constexpr const char* kTriangle = "0 0 0\n1 0 0\n0 1 0\n";

/// The colour of each face, as bytes; "-" for one without.
std::string colours_of(const Mesh& mesh) {
  std::string text;
  for (std::size_t i = 0; i < mesh.faces(); ++i) {
    const auto c = mesh.colour(i);
    text += c ? fmt::format("{:.0f},{:.0f},{:.0f} ", 255 * c->r, 255 * c->g, 255 * c->b) : "- ";
  }
  return text;
}

// ---- Statements of OBJ that are not read ------------------------------------------------

TEST_F(MeshDialects, StatementsOfObjThatAreNotReadAreNamed) {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
  const auto warnings = [&](const std::string& text) {
    return read("a.obj", text).skipped.warnings;
  };
  EXPECT_EQ(warnings(corners + "# F\n\ns off\nvp 0.5\nlod 3\nf 1 2 3\nend\n"), Sentences{});
  EXPECT_EQ(warnings(corners + "f 1 2 3\nF 1 3 4\n"),
            Sentences{"6:1: 'F': not read: the line is left out"});
  EXPECT_EQ(warnings(corners + "call b.obj\nf 1 2 3\nF 1 3 4\n"),
            Sentences{"5:1: 'call': not read: 2 such lines are left out"});
  EXPECT_EQ(warnings(corners + "f 1 2 3\ncurv 0 1 1 2\n"),
            Sentences{"left out: 1 curve or surface"});
  EXPECT_EQ(warnings(corners + "f 1 2 3\nsurf 0 1 0 1 1\ncurv2 1 2\n"),
            Sentences{"left out: 2 curves and surfaces"});
}

TEST_F(MeshDialects, WordsBehindAVertexAreNamed) {
  const auto warnings = [&](const std::string& words) {
    return read("a.obj", "v 0 0 0 " + words + "\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").skipped.warnings;
  };
  EXPECT_EQ(warnings("# origin"), Sentences{});
  EXPECT_EQ(warnings("1"), Sentences{});
  EXPECT_EQ(warnings("0.5 0.5 0.5"), Sentences{});
  const std::string expected = "expected a weight or a colour after a vertex: left out";
  EXPECT_EQ(warnings("words of mine"), Sentences{"1:9: 'words': " + expected});
  EXPECT_EQ(warnings("\rv 9 9 9"), Sentences{"1:10: 'v': " + expected});
}

TEST_F(MeshDialects, AGroupAfterAnObjectIsNotThatObject) {
  const Mesh mesh =
      read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\ng a\nf 1 2 3\no b\nf 1 2 3\ng a\nf 1 2 3\n");
  ASSERT_EQ(mesh.objects.size(), 3u);
  EXPECT_EQ(mesh.objects[1].name, "b");
}

// ---- Line ends -------------------------------------------------------------------------

std::string with_line_ends(std::string text, const std::string& end) {
  std::string all;
  for (const char c : text) all += c == '\n' ? end : std::string(1, c);
  return all;
}

const std::string kPlyHeader =
    "element vertex 3\ncomment made here\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";

TEST_F(MeshDialects, LinesMayEndInOneCr) {
  const std::vector<std::pair<std::string, std::string>> files{
      {"a.obj", "# a \\\nmtllib m.mtl\nv 0 0 0\nv 1 \\\n0 0\n\nv 0 1 0\nusemtl red one\nf 1 2 3\n"},
      {"a.off", "OFF # of Geomview\n\n3 1 0\n# corners\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n"},
      {"a.ply", "ply\nformat ascii 1.0\n" + kPlyHeader + kTriangle + "3 0 1 2\n"},
      {"a.stl",
       "solid a b\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
       "vertex 0 1 0\nendloop\nendfacet\nendsolid a b\n"}};
  const std::string library = "# red\nnewmtl red one\nKd 1 0 0\n";
  for (const char* end : {"\n", "\r\n", "\r", "\r\r\n"}) {
    file("m.mtl", with_line_ends(library, end));
    for (const auto& [name, text] : files) {
      const Mesh mesh = read_mesh(file(name, with_line_ends(text, end)));
      ASSERT_EQ(mesh.faces(), 1u) << name;
      EXPECT_EQ(mesh.vertices, (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})) << name;
      EXPECT_EQ(mesh.skipped.warnings, Sentences{}) << name;
      EXPECT_EQ(mesh.objects[0].name, name == "a.stl" ? "a b" : "a");
      const bool coloured = name == "a.obj" || name == "a.off";
      EXPECT_EQ(colours_of(mesh), coloured ? "255,0,0 " : "- ") << name;
    }
  }
}

TEST_F(MeshDialects, LinesThatEndInCrAreCounted) {
  expect_error([&] { read("a.obj", "v 0 0 0\rv 1 0 0\rv 0 x 0\rf 1 2 3\r"); }, "a.obj:3:5: 'x'");
}

/// One CR among lines that end otherwise ends none.
TEST_F(MeshDialects, MostLineEndsAreTheLineEnds) {
  const std::string rest = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  EXPECT_EQ(read("a.obj", "# a comment\rv 9 9 9\n" + rest).vertices.size(), 3u);
  EXPECT_EQ(read("b.obj", with_line_ends("# a comment\n" + rest, "\r") + "\n").vertices.size(), 3u);
}

/// The data after the header may hold more bytes of LF than the header has CR, and begin with one.
TEST_F(MeshDialects, ABinaryPlyHeaderMayEndItsLinesInCr) {
  for (const char* end : {"\n", "\r\n", "\r"}) {
    const std::string header =
        with_line_ends("ply\nformat binary_little_endian 1.0\n" + kPlyHeader, end);
    const std::string a = "\n\n\n\x3F", b = "\n\n\n\x40", c = "\n\n\n\x41";  // floats
    const std::string data =
        a + b + c + b + c + a + c + a + b + '\3' + bytes(0) + bytes(1) + bytes(2);
    const Mesh mesh = read("a.ply", header + data);
    EXPECT_EQ(mesh.faces(), 1u);
    EXPECT_EQ(mesh.vertices[0].x, std::bit_cast<float>(0x3F0A0A0Au));
    EXPECT_EQ(mesh.vertices[1].z, mesh.vertices[0].x);
  }
}

// ---- STL -------------------------------------------------------------------------------

std::string binary_stl(const std::string& header, int facets) {
  std::string stl = header;
  stl.resize(80, ' ');
  stl += bytes(static_cast<std::uint32_t>(facets));
  for (int i = 0; i < facets; ++i) {
    for (const float c : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) {
      stl += bytes(c);
    }
    stl += std::string(2, '\0');
  }
  return stl;
}

TEST_F(MeshDialects, ABinaryStlMayBeginWithSolidAndBeFollowedByBytes) {
  for (const std::string& more : {std::string(), std::string(1, '\0'), std::string("\n"),
                                  std::string(49, 'x'), std::string(3000, '\0')}) {
    for (const char* header : {"solid part one exported", "SOLID", "made here"}) {
      const Mesh mesh = read("a.stl", binary_stl(header, 12) + more);
      EXPECT_EQ(mesh.faces(), 12u) << header << more.size();
    }
  }
  EXPECT_EQ(read("b.stl", binary_stl("solid", 2) + std::string(50, '\0')).skipped.warnings,
            Sentences{"1 facet follows those that it announces: left out"});
}

TEST_F(MeshDialects, AnStlTextStaysOne) {
  std::string text = "solid " + std::string(60, 'n') + "\n";
  for (int i = 0; i < 3; ++i) {
    text +=
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
        "endfacet\n";
  }
  EXPECT_EQ(read("a.stl", text + "endsolid\n").faces(), 3u);
  expect_error([&] { read("b.stl", text); }, "end of file: expected endsolid");
  expect_error([&] { read("c.stl", binary_stl("solid", 2).substr(0, 150)); }, "c.stl");
}

constexpr const char* kFacet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
    "endfacet\n";

TEST_F(MeshDialects, SolidsOfStlHaveTheirWholeNames) {
  const Mesh mesh = read("a.stl", fmt::format("solid  Left half, 2 mm \n{0}endsolid\nSOLID b\n{0}"
                                              "endsolid b\nsolid\n{0}endsolid\n",
                                              kFacet));
  ASSERT_EQ(mesh.objects.size(), 3u);
  EXPECT_EQ(mesh.objects[0].name, "Left half, 2 mm");
  EXPECT_EQ(mesh.objects[1].name, "b");
  EXPECT_EQ(mesh.objects[2].name, "a");
}

/// In every format, and where a program writes one name for all solids.
TEST_F(MeshDialects, ObjectsWithoutANameHaveThatOfTheFile) {
  const auto names = [&](const std::string& name, const std::string& text) {
    std::vector<std::string> all;
    for (const Mesh::Object& object : read(name, text).objects) all.push_back(object.name);
    return all;
  };
  const auto solid = [](const std::string& name) {
    return "solid " + name +
           "\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
           "vertex 0 1 0\nendloop\nendfacet\nendsolid\n";
  };
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  EXPECT_EQ(names("base plate.stl", binary_stl("", 2)), Sentences{"base plate"});
  EXPECT_EQ(names("lid.stl", solid("OpenSCAD_Model")), Sentences{"lid"});
  EXPECT_EQ(names("lid.stl", solid("Exported from Blender-3.4.1")), Sentences{"lid"});
  EXPECT_EQ(names("lid.stl", solid("cover")), Sentences{"cover"});
  EXPECT_EQ(names("two.stl", solid("") + solid("pin") + solid("")),
            (Sentences{"two", "pin", "two 2"}));
  EXPECT_EQ(names("a.obj", obj), Sentences{"a"});
  EXPECT_EQ(names("a.obj", "o model\n" + obj), Sentences{"model"});
}

TEST_F(MeshDialects, WordsOfStlThatAreNotReadAreNamed) {
  const auto warnings = [&](const std::string& words) {
    return read("a.stl", "solid a\n" + words + kFacet + "endsolid a\n").skipped.warnings;
  };
  EXPECT_EQ(warnings(""), Sentences{});
  EXPECT_EQ(warnings("color 1 0 0\n"), Sentences{"2:1: 'color': not read: the word is left out"});
  EXPECT_EQ(warnings("\ncolor 1 0 0\nmaterial 3\n"),
            Sentences{"3:1: 'color': not read: 2 such words are left out"});
  std::string odd = kFacet;
  odd.replace(odd.find("0 0 1"), 5, "-nan(ind) NaN inf");
  EXPECT_EQ(warnings(odd), Sentences{}) << "a normal is not read";
}

TEST_F(MeshDialects, ColoursOfBinaryStlAreNamed) {
  std::string stl = binary_stl("made here", 3);
  EXPECT_EQ(read("a.stl", stl).skipped.warnings, Sentences{});
  stl[84 + 2 * 50 - 1] = '\x80';
  EXPECT_EQ(read("a.stl", stl).skipped.warnings,
            Sentences{"left out: the two bytes behind 1 facet, perhaps its colour"});
  stl[84 + 50 - 2] = '\1';
  EXPECT_EQ(read("a.stl", stl).skipped.warnings,
            Sentences{"left out: the two bytes behind 2 facets, perhaps their colours"});
  EXPECT_EQ(read("a.stl", binary_stl("COLOR=\1\2\3\4", 1)).skipped.warnings,
            Sentences{"left out: the colour in the header"});
}

// ---- PLY -------------------------------------------------------------------------------

TEST_F(MeshDialects, WhatPlyHasThatIsNotReadIsNamed) {
  const auto warnings = [&](const std::string& of_vertex, const std::string& of_face,
                            const std::string& elements, const std::string& data,
                            const std::string& comment = "made here") {
    return read("a.ply", fmt::format("ply\nformat ascii 1.0\ncomment {}\nelement vertex 3\n"
                                     "property float x\nproperty float y\nproperty float z\n{}"
                                     "element face 1\nproperty list uchar int vertex_index\n{}{}"
                                     "end_header\n{}",
                                     comment, of_vertex, of_face, elements, data))
        .skipped.warnings;
  };
  const std::string corners = "0 0 0\n1 0 0\n0 1 0\n", face = "3 0 1 2\n";
  EXPECT_EQ(warnings("", "", "", corners + face), Sentences{});
  EXPECT_EQ(warnings("property float quality\nproperty float nx\nproperty int odd name\n", "", "",
                     "0 0 0 7 0 7\n1 0 0 7 0 7\n0 1 0 7 0 7\n" + face),
            Sentences{"left out: of each vertex: 'quality', 'odd'"});
  EXPECT_EQ(warnings("property float s\nproperty float t\n", "", "",
                     "0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n" + face),
            Sentences{})
      << "without a texture, these are of none";
  EXPECT_EQ(warnings("", "property int material_index\nproperty float nx\n", "",
                     corners + "3 0 1 2 5 0\n"),
            Sentences{"left out: of each face: 'material_index'"});
  EXPECT_EQ(warnings("", "", "element edge 2\nproperty int vertex1\nproperty int vertex2\n",
                     corners + face + "0 1\n1 2\n"),
            Sentences{"left out: the element 'edge', of which there are 2"});
  EXPECT_EQ(warnings("", "", "element edge 0\nproperty int vertex1\n", corners + face),
            Sentences{});
  EXPECT_EQ(warnings("", "", "", corners + face, "TextureFile wood.png"),
            Sentences{"left out: 1 texture"});
  EXPECT_EQ(warnings("property uchar red\nproperty uchar green\n", "", "",
                     "0 0 0 1 2\n1 0 0 1 2\n0 1 0 1 2\n" + face),
            Sentences{"left out: of each vertex: 'red', 'green'"})
      << "two parts are no colour";
}

TEST_F(MeshDialects, APlyHeaderMayBeginWithWordsOfItsProgram) {
  const auto ply = [&](const std::string& before, const std::string& among) {
    return read("a.ply", "ply\nformat ascii 1.0\n" + before +
                             "element vertex 3\nproperty float x\n" + among +
                             "property float y\nproperty float z\nelement face 1\n"
                             "property list uchar int vertex_index\nend_header\n" +
                             kTriangle + "3 0 1 2\n");
  };
  EXPECT_EQ(ply("Created by a program\n", "").skipped.warnings,
            Sentences{"3:1: 'Created': not read: the line is left out"});
  EXPECT_EQ(ply("\nCreated by\na program\n", "").skipped.warnings,
            Sentences{"4:1: 'Created': not read: 2 such lines are left out"});
  expect_error([&] { ply("", "propery float w\n"); },
               "a.ply:5:1: 'propery': expected format, element, property, comment or end_header");
  expect_error([&] { ply("property float w\n", ""); }, "a.ply:3:1: property before any element");
}

TEST_F(MeshDialects, PlyColoursAreFloatsOrBytesWithOpacity) {
  const auto mesh = [&](const std::string& type, const std::string& colour) {
    std::string text =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\n";
    for (const char* part : {"red", "green", "blue", "alpha"}) {
      text += fmt::format("property {} {}\n", type, part);
    }
    text += "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    for (const char* p : {"0 0 0", "1 0 0", "0 1 0"}) text += fmt::format("{} {}\n", p, colour);
    return read("a.ply", text + "3 0 1 2\n");
  };
  struct Case {
    const char *type, *colour, *expected;
    std::size_t transparent;
  };
  for (const auto& [type, colour, expected, transparent] :
       {Case{"float", "1 0 0.2 1", "255,0,51 ", 0},
        {"float", "1 0 0.2 0.5", "255,0,51 ", 1},
        {"float", "255 0 51 255", "255,0,51 ", 0},
        {"float", "255 0 51 128", "255,0,51 ", 1},
        {"double", "1 0 0.2 0", "255,0,51 ", 1},
        {"uchar", "255 0 51 255", "255,0,51 ", 0},
        {"uchar", "255 0 51 254", "255,0,51 ", 1},
        {"ushort", "65535 0 13107 65535", "255,0,51 ", 0},
        {"int", "255 0 51 255", "255,0,51 ", 0}}) {
    const Mesh read = mesh(type, colour);
    EXPECT_EQ(colours_of(read), expected) << type << colour;
    EXPECT_EQ(read.skipped.transparent_faces, transparent) << type << colour;
    EXPECT_EQ(read.skipped.warnings, Sentences{}) << type << colour;
  }
}

// ---- Points, and colours that differ ---------------------------------------------------

TEST_F(MeshDialects, PointsWithoutFacesAreRefusedByName) {
  const std::string words = ": 3 points and no faces: points are not drawn";
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nend_header\n";
  expect_error([&] { read("a.ply", ply + kTriangle); }, "a.ply" + words);
  expect_error([&] { read("a.off", "OFF\n3 0 0\n" + std::string(kTriangle)); }, "a.off" + words);
  expect_error([&] { read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"); }, "a.obj" + words);
  expect_error([&] { read("b.obj", "v 0 0 0\nv 1 0 0\nl 1 2\np 1\n"); },
               "no faces: expected polygons (found 2 points and lines, ");
}

TEST_F(MeshDialects, ColoursThatDifferBetweenCornersAreTold) {
  const auto warnings = [&](const std::string& second) {
    return read("a.obj", "v 0 0 0 1 0 0\nv 1 0 0 " + second +
                             "\nv 0 1 0 1 0 0\nv 1 1 0\nf 1 2 3\nf 3 2 1\nf 1 3 4\n")
        .skipped.warnings;
  };
  EXPECT_EQ(warnings("1 0 0"), Sentences{});
  EXPECT_EQ(warnings(""), Sentences{}) << "a colour that is not known";
  EXPECT_EQ(warnings("1 0 0.5"),
            Sentences{"left out: the different colours of the corners of 2 faces: their mean is "
                      "drawn"});
}

// ---- OBJ -------------------------------------------------------------------------------

TEST_F(MeshDialects, BlackUnderATextureIsNoColour) {
  file("a.mtl",
       "newmtl wood\nKd 0 0 0\nmap_Kd wood.png\nnewmtl ink\nKd 0 0 0\n"
       "newmtl oak\nmap_Kd oak.png\nKd 0 0 0\nnewmtl red\nKd 1 0 0\nmap_Kd r.png\n");
  const Mesh mesh = read("a.obj",
                         "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl wood\nf 1 2 3\n"
                         "usemtl ink\nf 1 2 3\nusemtl oak\nf 1 2 3\nusemtl red\nf 1 2 3\n");
  EXPECT_EQ(colours_of(mesh), "- 0,0,0 - 255,0,0 ");
  EXPECT_EQ(mesh.skipped.textured_faces, 3u);
}

TEST_F(MeshDialects, NamesOfObjMayStandInQuotationMarks) {
  file("my materials.mtl", "newmtl Warm Red\nKd 1 0 0\nnewmtl \"cold blue\"\nKd 0 0 1\n");
  file("other.mtl", "newmtl green\nKd 0 1 0\n");
  const auto colours = [&](const std::string& libraries, const std::string& red) {
    const Mesh mesh = read("a.obj", libraries + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl " + red +
                                        "\nf 1 2 3\nusemtl cold blue\nf 1 2 3\nusemtl green\n"
                                        "f 1 2 3\n");
    EXPECT_EQ(mesh.skipped.warnings, Sentences{}) << libraries;
    return colours_of(mesh);
  };
  for (const char* libraries :
       {"mtllib \"my materials.mtl\" other.mtl", "mtllib other.mtl \"my materials.mtl\"",
        "mtllib \"my materials.mtl\" \"other.mtl\"", "mtllib my materials.mtl other.mtl",
        "mtllib other.mtl my materials.mtl", "mtllib my materials.mtl\nmtllib other.mtl",
        "mtllib \"my materials.mtl\"\nmtllib \"other.mtl\"",
        "mtllib \"C:\\parts\\my materials.mtl\" other.mtl"}) {
    for (const char* red : {"Warm Red", "\"Warm Red\""}) {
      EXPECT_EQ(colours(libraries, red), "255,0,0 0,0,255 0,255,0 ") << libraries << red;
    }
  }
  const Mesh mesh = read("b.obj",
                         "mtllib \"no such.mtl\" \"other.mtl\"\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"
                         "usemtl red\nf 1 2 3\n");
  EXPECT_EQ(mesh.skipped.warnings, Sentences{"no material library 'no such.mtl' beside it"});
}

TEST_F(MeshDialects, TextureCoordinatesThatAreNotThereAreAWarning) {
  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  const auto warnings = [&](const std::string& faces) {
    const Mesh mesh = read("a.obj", square + faces);
    EXPECT_EQ(mesh.face(0).size(), 4u);
    return mesh.skipped.warnings;
  };
  const std::string end = ": the face is drawn without";
  EXPECT_EQ(
      warnings("f 1/5 2/6 3/7 4/8\n"),
      Sentences{"5:5: texture coordinate index 5 out of range: no texture coordinate was given" +
                end});
  EXPECT_EQ(warnings("vt 0 0\nvt 1 1\nf 1/1 2/2 3/3 4/4\nf 1/9 2/9 3/9\n"),
            Sentences{"7:13: texture coordinate index 3 out of range: expected 1 to 2 or -2 to -1" +
                      end});
  EXPECT_EQ(
      warnings("f 1/0 2/9 3/0 4/0\n"),
      Sentences{"5:5: texture coordinate index 0 out of range: no texture coordinate was given" +
                end});
  EXPECT_EQ(warnings("vt 0 0\nf 1/-2 2/-1 3/-1 4/-1\n").size(), 1u);
  EXPECT_EQ(warnings("f 1/1 2/2 3/3 4/4\nvt 0 0\nvt 1 1\nvt 0 0\nvt 0 0\n"), Sentences{})
      << "they may follow";
  expect_error([&] { read("b.obj", square + "f 1/x 2/6 3/7\n"); }, ":5:5: 'x'");
  expect_error([&] { read("c.obj", square + "f 1/1/1 2/1/2 3/1/3\n"); }, "normal index 1");
  expect_error([&] { read("d.obj", square + "f 1/5 2/6 9/7\n"); }, "vertex index 9");
}

// ---- OFF -------------------------------------------------------------------------------

TEST_F(MeshDialects, OffColoursOfVerticesNeedNoKeyword) {
  const auto colours = [&](const std::string& text) {
    const Mesh mesh = read("a.off", text + "3 0 1 2\n");
    EXPECT_EQ(mesh.skipped.warnings, Sentences{}) << text;
    return colours_of(mesh);
  };
  EXPECT_EQ(colours("OFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 255 0 0 255\n0 1 0 255 0 0 255\n"),
            "255,0,0 ");
  EXPECT_EQ(colours("3 1 0\n0 0 0 255 0 0\n1 0 0 255 0 0 # red\n0 1 0 255 0 0\n"), "255,0,0 ");
  EXPECT_EQ(colours("OFF\n3 1 0\n0 0 0 .2 .4 .6 1\n1 0 0 .2 .4 .6 1\n0 1 0 .2 .4 .6 1\n"),
            "51,102,153 ");
  EXPECT_EQ(colours("OFF\n3 1 0\n0 0 0 .2 .4 .6\n1 0 0 .2 .4 .6\n0 1 0 .2 .4 .6\n"), "51,102,153 ");
  EXPECT_EQ(colours("NOFF\n3 1 0\n0 0 0 0 0 1 255 0 0\n1 0 0 0 0 1 255 0 0\n0 1 0 0 0 1 255 0 0\n"),
            "255,0,0 ");
  EXPECT_EQ(colours("STOFF\n3 1 0\n0 0 0 255 0 0 1 1\n1 0 0 255 0 0 1 1\n0 1 0 255 0 0 1 1\n"),
            "255,0,0 ");
  EXPECT_EQ(colours("4OFF\n3 1 0\n0 0 0 1 255 0 0\n1 0 0 1 255 0 0\n0 1 0 1 255 0 0\n"),
            "255,0,0 ");
}

TEST_F(MeshDialects, OffNumbersThatAreNoColoursAreTold) {
  const auto read_off = [&](const std::string& keyword, const std::string& behind_vertices,
                            const std::string& behind_face) {
    std::string text = keyword + "\n3 1 0\n";
    for (const char* p : {"0 0 0", "1 0 0", "0 1 0"}) text += p + (" " + behind_vertices) + "\n";
    return read("a.off", text + "3 0 1 2 " + behind_face + "\n");
  };
  const auto losses = [&](const std::string& keyword, const std::string& behind_vertices,
                          const std::string& behind_face) {
    const Mesh mesh = read_off(keyword, behind_vertices, behind_face);
    EXPECT_EQ(colours_of(mesh), "- ") << keyword << behind_vertices << behind_face;
    return mesh.skipped.warnings;
  };
  const Sentences behind{
      "left out: the numbers after 3 vertices, which the keyword does not announce"};
  EXPECT_EQ(losses("OFF", "0 0 1", ""), behind) << "perhaps normals";
  EXPECT_EQ(losses("OFF", "0.6 0 0.8", ""), behind);
  EXPECT_EQ(losses("OFF", "-0.5 0 0", ""), behind);
  EXPECT_EQ(losses("OFF", "0.5 0.5", ""), behind) << "perhaps texture coordinates";
  EXPECT_EQ(losses("OFF", "7", ""), behind);
  EXPECT_EQ(losses("OFF", "0 0 1 255 0 0", ""), behind);
  EXPECT_EQ(losses("OFF", "nan 0 0", ""), behind);
  EXPECT_EQ(losses("NOFF", "0 0 1 2 3", ""), behind);
  EXPECT_EQ(losses("COFF", "7", ""),
            Sentences{"left out: the colours of 3 vertices, which are not three or four numbers"});
  EXPECT_EQ(losses("OFF", "", "7"),
            Sentences{"left out: the colour of 1 face, which is an index into a map"});
  EXPECT_EQ(losses("OFF", "", "red"),
            Sentences{"left out: the colour of 1 face, which is not three or four numbers"});
  EXPECT_EQ(losses("OFF", "", "1 2"),
            Sentences{"left out: the colour of 1 face, which is not three or four numbers"});
  for (const char* keyword : {"OFF", "NOFF 0 0 1", "STOFF .5 .5", "STNOFF 0 0 1 .5 .5"}) {
    const std::string words = keyword;
    const auto blank = std::min(words.find(' '), words.size());
    EXPECT_EQ(losses(words.substr(0, blank), words.substr(blank), ""), Sentences{}) << keyword;
  }
  const Mesh mixed = read("b.off", "OFF\n3 1 0\n0 0 0 255 0 0\n1 0 0\n0 1 0 255 0 0\n3 0 1 2\n");
  EXPECT_EQ(
      mixed.skipped.warnings,
      Sentences{"left out: the numbers after 2 vertices, which the keyword does not announce"});
}

// ---- Formats that are not read ---------------------------------------------------------

TEST_F(MeshDialects, FormatsThatAreNotReadAreNamed) {
  const std::string advice = ", which is not read: export it as STL, OBJ, PLY or glTF";
  for (const auto& [extension, format] :
       {std::pair("dwg", "a DWG drawing"), std::pair("SLDPRT", "a SOLIDWORKS part"),
        std::pair("f3d", "a Fusion design"), std::pair("3dm", "a Rhino model")}) {
    const std::string name = fmt::format("a.{}", extension);
    expect_error([&] { read(name, "something\n"); }, name + ": " + format + advice);
  }
  // A file that is recognisably a mesh of another format is read.
  EXPECT_EQ(read("a.dwg", "OFF\n3 1 0\n" + std::string(kTriangle) + "3 0 1 2\n").faces(), 1u);
}

/// By their beginnings or their names.
TEST_F(MeshDialects, FilesOfCadProgramsAreRecognised) {
  const std::string step = "ISO-10303-21;\nHEADER;\nENDSEC;\n";
  for (const char* name : {"a.step", "a.STP", "a.p21", "a.weird", "a"}) {
    EXPECT_EQ(cad_format(file(name, step)), CadFormat::step) << name;
  }
  const std::string iges = std::string(72, ' ') + "S      1\n";
  for (const char* name : {"a.iges", "a.IGS", "a.weird", "a"}) {
    EXPECT_EQ(cad_format(file(name, iges)), CadFormat::iges) << name;
  }
  EXPECT_EQ(cad_format(file("b.igs", "something\n")), CadFormat::iges);
  for (const std::string& text :
       {std::string("something\n"), std::string(72, ' ') + "S      2\n",
        std::string(72, ' ') + "G      1\n",
        std::string(40, ' ') + "\n" + std::string(31, ' ') + "S      1\n"}) {
    EXPECT_EQ(cad_format(file("b.weird", text)), std::nullopt) << text;
  }
}

TEST_F(MeshDialects, CadFilesThatCannotBeReadAreNamed) {
  const bool has_library = !cad_extensions_read().empty();
  expect_error([&] { read("a.step", "ISO-10303-21;\n"); },
               has_library ? "a.step: not a STEP file that can be read: it ends too early"
                           : "a.step: a STEP file, which this build does not read: it has no "
                             "OpenCASCADE");
  expect_error([&] { read("a.igs", "x\n"); },
               has_library ? "a.igs: not an IGES file that can be read: it ends too early"
                           : "a.igs: an IGES file, which this build does not read: it has no "
                             "OpenCASCADE");
}

/// A building in the same notation is left to the import library.
TEST_F(MeshDialects, IfcIsNotTakenForStep) {
  const std::string ifc =
      "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_SCHEMA(('IFC2X3'));\nENDSEC;\n"
      "DATA;\nENDSEC;\nEND-ISO-10303-21;\n";
  for (const char* name : {"a.ifc", "a.step"}) {
    const std::string message = test::error_of([&] { read(name, ifc); });
    EXPECT_NE(message, "") << name;
    EXPECT_EQ(message.find("STEP"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace displayfile
