// Colours from the import library, and detail far from the origin, which must not be lost.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/graphics_system.h"
#include "displayfile/mesh/import_library.h"
#include "displayfile/mesh/import_losses.h"
#include "displayfile/mesh/mesh.h"
#include "interp/device/raster_request.h"
#include "interp/raster/software.h"
#include "tests/mesh_colours.h"
#include "tests/truth_scenes.h"

namespace displayfile {
namespace {

using test::bytes;
using test::colours_of;
using test::MeshColours;
using test::said_of;

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

/// A primitive without a material is white, as the format specifies.
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

/// The number of faces of each colour, in the shortest form of three decimals.
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
  int there = 0;  // of them; a release may lack one
  for (const Model& model : models) {
    if (!std::filesystem::exists(kModels / model.path)) continue;
    ++there;
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
  EXPECT_GE(there, 6);
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
/// fitted to both, and only viewing's rounding differs.
TEST_F(MeshColours, ASurveyIsDrawnAsTheSameMeshAtTheOrigin) {
  const auto ids = [&](const std::string& text) {
    GraphicsSystem system;
    import_mesh(file("a.obj", text), system);
    const RasterRequest request{
        .width = 400, .height = 400, .surfaces = {.method = HiddenMethod::z_buffer}, .ids = true};
    return draw_with_software(system.display_file(), request).ids;
  };
  const auto at_origin = ids(terrain(0, 0)), survey = ids(terrain(500000.25, 4000000.5));
  EXPECT_GT(std::ranges::count_if(at_origin, [](int id) { return id >= 0; }), 20000);
  EXPECT_EQ(test::different(at_origin, survey), 0u);
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
