// What the import library passes over without a word is refused or told by name: extensions, skins
// and morph targets of glTF, extensions and colours of triangles of 3MF. Names in glTF are decoded.

#include "displayfile/mesh/import_losses.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/mesh/import_library.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/mesh/percent_encoding.h"
#include "displayfile/mesh/xml_tags.h"
#include "tests/archive.h"
#include "tests/error_of.h"
#include "tests/fuzz/mutated_bytes.h"
#include "tests/mesh_files.h"

namespace displayfile {
namespace {

using Json = nlohmann::ordered_json;
using test::bytes;
using test::expect_error;
using Sentences = std::vector<std::string>;

class ImportLosses : public test::MeshFiles {
 protected:
  void SetUp() override {
    if (!import_library_version()) GTEST_SKIP() << "no import library";
  }

  static std::string model(const std::string& name) {
    return DISPLAYFILE_SOURCE_DIR "/tests/meshes/" + name;
  }
};

/// The faces that a file gives each colour.
std::size_t faces_in(const Colour& colour, const Mesh& mesh) {
  std::size_t faces = 0;
  for (std::size_t i = 0; i < mesh.faces(); ++i) faces += mesh.colour(i) == colour ? 1 : 0;
  return faces;
}

// ---- glTF ------------------------------------------------------------------------------

/// A file of one triangle and its buffer, to which more is added.
struct Gltf {
  Json file = Json::parse(R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
      "nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
      "accessors":[],"bufferViews":[],"buffers":[{}]})");
  std::string buffer;

  Gltf() {
    std::string corners;
    for (const float c : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) corners += bytes(c);
    add(corners, 5126, 3, "VEC3");
  }

  /// Returns the index of a new accessor of these bytes.
  std::size_t add(const std::string& data, int component_type, int count, const char* type) {
    file["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", data.size()}});
    file["accessors"].push_back({{"bufferView", file["bufferViews"].size() - 1},
                                 {"componentType", component_type},
                                 {"count", count},
                                 {"type", type}});
    buffer += data;
    buffer.resize((buffer.size() + 3) / 4 * 4);
    return file["accessors"].size() - 1;
  }
  Json& primitive() { return file["meshes"][0]["primitives"][0]; }

  /// The text of the file, with its buffer under this name.
  std::string text(const std::string& uri) {
    file["buffers"][0] = {{"byteLength", buffer.size()}, {"uri", uri}};
    return file.dump();
  }
  std::string binary() {
    file["buffers"][0] = {{"byteLength", buffer.size()}};
    std::string json = file.dump();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const auto four = [](std::size_t n) { return bytes(static_cast<std::uint32_t>(n)); };
    return "glTF" + four(2) + four(28 + json.size() + buffer.size()) + four(json.size()) + "JSON" +
           json + four(buffer.size()) + std::string("BIN\0", 4) + buffer;
  }
};

class GltfLosses : public ImportLosses {
 protected:
  /// The file as JSON with a buffer beside it, and as a binary one.
  std::vector<std::string> both(Gltf gltf) const {
    file("b.bin", gltf.buffer);
    return {file("a.gltf", gltf.text("b.bin")), file("a.glb", gltf.binary())};
  }
  void expect_losses(const Gltf& gltf, const Sentences& losses) const {
    for (const std::string& path : both(gltf)) {
      EXPECT_EQ(read_mesh(path).skipped.warnings, losses) << path;
    }
  }
  void expect_refused(const Gltf& gltf, const std::string& words) const {
    for (const std::string& path : both(gltf)) {
      expect_error([&] { read_mesh(path); }, path + ": " + words);
    }
  }
};

TEST_F(GltfLosses, AFileWithoutAnyIsRead) {
  for (const std::string& path : both({})) {
    const Mesh mesh = read_mesh(path);
    EXPECT_EQ(mesh.faces(), 1u) << path;
    EXPECT_EQ(mesh.vertices[1], Point3(1, 0, 0)) << path;
    EXPECT_EQ(mesh.skipped.warnings, Sentences{}) << path;
  }
}

TEST_F(GltfLosses, ExtensionsThatAreRequiredAndNotReadAreRefusedByName) {
  expect_error([&] { read_mesh(model("gltf-quantized.gltf")); },
               "requires the glTF extension KHR_mesh_quantization, which is not read");
  for (const char* name : {"EXT_meshopt_compression", "KHR_mesh_quantization", "KHR_texture_basisu",
                           "EXT_mesh_gpu_instancing", "ACME_of_our_own"}) {
    Gltf gltf;
    gltf.file["extensionsRequired"] = {"KHR_materials_unlit", name};
    expect_refused(gltf, fmt::format("requires the glTF extension {}, which is not read", name));
  }
  Gltf two;
  two.file["extensionsRequired"] = {"A", "KHR_texture_transform", "B"};
  expect_refused(two, "requires the glTF extensions A, B, which are not read");
}

TEST_F(GltfLosses, ExtensionsThatAreUsedAndNotRequiredAreNoReason) {
  Gltf gltf;
  gltf.file["extensionsUsed"] = {"ACME_of_our_own", "KHR_materials_unlit"};
  gltf.file["extensionsRequired"] = {"KHR_materials_unlit"};
  expect_losses(gltf, {});
}

/// As KHR_mesh_quantization allows them, in a file that does not say that it requires it.
TEST_F(GltfLosses, PositionsAndNormalsOfIntegersAreRefused) {
  for (const char* attribute : {"POSITION", "NORMAL"}) {
    for (const int type : {5120, 5121, 5122, 5123}) {
      Gltf gltf;
      gltf.primitive()["attributes"][attribute] = gltf.add(std::string(36, '\1'), type, 3, "VEC3");
      expect_refused(gltf, fmt::format("{} of component type {}", attribute, type));
    }
  }
}

/// One joint and weights for it; the joint's node is placed, and was bound at this height.
Gltf skinned(const Json& joint, const Json& body = {{"mesh", 0}, {"skin", 0}}, float bound_z = 0) {
  Gltf gltf;
  std::string inverse_bind, weights;
  for (int i = 0; i < 16; ++i) inverse_bind += bytes(i % 5 == 0 ? 1.f : i == 14 ? -bound_z : 0.f);
  for (int i = 0; i < 12; ++i) weights += bytes(i % 4 == 0 ? 1.f : 0.f);
  gltf.primitive()["attributes"]["JOINTS_0"] = gltf.add(std::string(12, '\0'), 5121, 3, "VEC4");
  gltf.primitive()["attributes"]["WEIGHTS_0"] = gltf.add(weights, 5126, 3, "VEC4");
  const std::size_t inverse = gltf.add(inverse_bind, 5126, 1, "MAT4");
  gltf.file["skins"] =
      Json::parse(fmt::format(R"([{{"joints":[1],"inverseBindMatrices":{}}}])", inverse));
  gltf.file["nodes"] = {body, joint};
  gltf.file["scenes"][0]["nodes"] = {0, 1};
  return gltf;
}

TEST_F(GltfLosses, ASkinThatMovesWhatItIsOnIsTold) {
  const Sentences one{"left out: the skin of 1 object"};
  EXPECT_EQ(read_mesh(model("gltf-skin.gltf")).skipped.warnings, one);
  expect_losses(skinned({{"name", "j"}, {"translation", {0, 0, 2}}}), one);
  expect_losses(skinned({{"name", "j"}, {"scale", {1, 1.5, 1}}}), one);
  // A skin has nothing of its own node's place.
  expect_losses(skinned({{"name", "j"}}, {{"mesh", 0}, {"skin", 0}, {"translation", {3, 0, 0}}}),
                one);
  Gltf two = skinned({{"name", "j"}, {"translation", {0, 0, 2}}});
  two.file["nodes"].push_back({{"mesh", 0}, {"skin", 0}});
  two.file["scenes"][0]["nodes"] = {0, 1, 2};
  expect_losses(two, {"left out: the skins of 2 objects"});
}

TEST_F(GltfLosses, ASkinThatMovesNothingIsNoLoss) {
  expect_losses(skinned({{"name", "j"}}), {});
  expect_losses(skinned({{"name", "j"}, {"translation", {0, 0, 2}}}, {{"mesh", 0}, {"skin", 0}}, 2),
                {});
  expect_losses(skinned({{"name", "j"}, {"translation", {3, 0, 0}}},
                        {{"mesh", 0}, {"skin", 0}, {"translation", {3, 0, 0}}}),
                {});
}

TEST_F(GltfLosses, MorphTargetsThatMoveVerticesAreTold) {
  const auto with_target = [] {
    Gltf gltf;
    gltf.primitive()["targets"] =
        Json::array({{{"POSITION", gltf.add(std::string(36, '\0'), 5126, 3, "VEC3")}}});
    return gltf;
  };
  const Sentences one{"left out: the morph targets of 1 object"};
  Gltf by_mesh = with_target(), by_node = with_target(), at_rest = with_target(),
       two = with_target();
  by_mesh.file["meshes"][0]["weights"] = {0.25};
  expect_losses(by_mesh, one);
  by_node.file["nodes"][0]["weights"] = {-1};
  expect_losses(by_node, one);
  expect_losses(at_rest, {});
  at_rest.file["meshes"][0]["weights"] = {0.25};
  at_rest.file["nodes"][0]["weights"] = {0.0};
  expect_losses(at_rest, {});
  two.file["meshes"][0]["weights"] = {1};
  two.file["nodes"].push_back({{"mesh", 0}, {"translation", {5, 0, 0}}});
  two.file["scenes"][0]["nodes"] = {0, 1};
  expect_losses(two, {"left out: the morph targets of 2 objects"});
}

TEST_F(GltfLosses, InstancesAreTold) {
  Gltf gltf;
  gltf.file["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] =
      gltf.add(std::string(24, '\0'), 5126, 2, "VEC3");
  gltf.file["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
  expect_losses(gltf, {"left out: the instances of 1 object (EXT_mesh_gpu_instancing)"});
}

/// Positions that are 0 but where the file gives others.
TEST_F(GltfLosses, SparseAccessorsAreRead) {
  Gltf gltf;
  const std::string index = "\2", corner = bytes(0.f) + bytes(2.f) + bytes(0.5f);
  const std::size_t indices = gltf.add(index, 5121, 1, "SCALAR");
  const std::size_t values = gltf.add(corner, 5126, 1, "VEC3");
  const auto& accessors = gltf.file["accessors"];
  gltf.file["accessors"][0]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", accessors[indices]["bufferView"]}, {"componentType", 5121}}},
      {"values", {{"bufferView", accessors[values]["bufferView"]}}}};
  for (const std::string& path : both(gltf)) {
    const Mesh mesh = read_mesh(path);
    ASSERT_EQ(mesh.vertices.size(), 3u);
    EXPECT_EQ(mesh.vertices[1], Point3(1, 0, 0));
    EXPECT_EQ(mesh.vertices[2], Point3(0, 2, 0.5));
  }
}

TEST_F(GltfLosses, BadJsonIsRefusedWithItsPlace) {
  const std::string path = file("a.gltf", "{\"asset\": {\"version\": \"2.0\"}, nodes: []}");
  expect_error([&] { read_mesh(path); }, path + ": not a mesh that can be read: glTF: bad JSON at");
}

// ---- Names in glTF ---------------------------------------------------------------------

TEST_F(GltfLosses, NamesArePercentEncoded) {
  const Mesh mesh = read_mesh(model("gltf-percent-name.gltf"));
  EXPECT_EQ(mesh.faces(), 12u);
  EXPECT_EQ(faces_in(Colour(1, 0, 0), mesh), 12u);
  namespace fs = std::filesystem;
  fs::create_directories(folder_ / "in" / "sub");
  Gltf gltf;
  file("outside.bin", gltf.buffer);
  for (const char* name : {"in/my buffer.bin", "in/sub/b.bin", "in/\xC3\xA9.bin", "in/100%25.bin",
                           "in/a b%20c.bin", "in/plus+.bin"}) {
    file(name, gltf.buffer);
  }
  const auto read_with = [&](const std::string& uri) {
    return read_mesh(file("in/a.gltf", gltf.text(uri))).faces();
  };
  for (const char* uri :
       {"my%20buffer.bin", "m%79%20buffer%2Ebin", "sub%2Fb.bin", "%2e/sub/b.bin",
        "sub/%2E%2e/my%20buffer.bin", "%C3%A9.bin", "\xC3\xA9.bin", "100%2525.bin", "plus+.bin"}) {
    EXPECT_EQ(read_with(uri), 1u) << uri;
  }
  EXPECT_EQ(read_with("100%25.bin"), 1u) << "as it is written, where nothing has the name meant";
  for (const char* uri : {"%2e%2e/outside.bin", "..%2Foutside.bin", "%2E%2E%2Foutside.bin",
                          "sub/..%2f..%2foutside.bin", "my%2520buffer.bin"}) {
    EXPECT_THROW(read_with(uri), Error) << uri;
  }
  for (const char* uri : {"b%.bin", "b%2", "b%", "b%2g.bin", "b%00.bin", "%-1.bin", "%+1.bin",
                          "% 1.bin", "100%.bin"}) {
    expect_error([&] { read_with(uri); }, "expected two hexadecimal digits");
  }
}

TEST(PercentEncoding, IsDecoded) {
  EXPECT_EQ(percent_decoded(""), "");
  EXPECT_EQ(percent_decoded("a%20b%2Fc%2fd%25%C3%A9"), "a b/c/d%\xC3\xA9");
  for (const char* bad : {"%", "a%2", "%zz", "%2%20", "%00", "%0x"}) {
    EXPECT_EQ(percent_decoded(bad), std::nullopt) << bad;
  }
}

// ---- 3MF -------------------------------------------------------------------------------

/// A tetrahedron, with attributes of its triangles.
std::string tetrahedron(const std::vector<std::string>& triangles = {"", "", "", ""},
                        const std::string& more = "") {
  return fmt::format(
      "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/>"
      "<vertex x=\"0\" y=\"1\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"1\"/></vertices><triangles>"
      "<triangle v1=\"0\" v2=\"2\" v3=\"1\" {}/><triangle v1=\"0\" v2=\"1\" v3=\"3\" {}/>"
      "<triangle v1=\"0\" v2=\"3\" v3=\"2\" {}/><triangle v1=\"1\" v2=\"2\" v3=\"3\" {}/>"
      "</triangles>{}</mesh>",
      triangles[0], triangles[1], triangles[2], triangles[3], more);
}

constexpr const char* kItem = "<item objectid=\"9\"/>";
constexpr const char* kMaterials =
    "<basematerials id=\"1\"><base name=\"r\" displaycolor=\"#FF0000\"/>"
    "<base name=\"b\" displaycolor=\"#0000FF\"/></basematerials>"
    "<m:colorgroup id=\"2\"><m:color color=\"#00FF00\"/><m:color "
    "color=\"#FF0000\"/></m:colorgroup>";

std::string object(const std::string& content, const std::string& attributes = "", int id = 9) {
  return fmt::format("<object id=\"{}\" type=\"model\" {}>{}</object>", id, attributes, content);
}

std::string model_of(const std::string& objects, const std::string& attributes = "",
                     const std::string& items = kItem) {
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"millimeter\" "
      "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
      "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\" "
      "xmlns:p='http://schemas.microsoft.com/3dmanufacturing/production/2015/06' "
      "xmlns:b=\"http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02\" {}>"
      "<resources>{}{}</resources><build>{}</build></model>",
      attributes, kMaterials, objects, items);
}

class ThreeMfLosses : public ImportLosses {
 protected:
  Mesh read_3mf(const std::string& model) const {
    return read_mesh(file("a.3mf", test::file_of_3mf(model)));
  }
  Sentences losses_of_model(const std::string& model) const {
    return read_3mf(model).skipped.warnings;
  }
};

TEST_F(ThreeMfLosses, ColoursThatDifferWithinAnObjectAreTold) {
  EXPECT_EQ(read_mesh(model("3mf-triangle-colours.3mf")).skipped.warnings,
            Sentences{"left out: the colours of 12 triangles that differ within an object"});
  const Sentences four{"left out: the colours of 4 triangles that differ within an object"};
  const std::string r = "pid=\"1\" p1=\"0\"", b = "pid=\"1\" p1=\"1\"";
  EXPECT_EQ(losses_of_model(model_of(object(tetrahedron({r, r, b, r})))), four);
  EXPECT_EQ(losses_of_model(model_of(object(tetrahedron({r, r, r, ""}), "pid='1' pindex='1'"))),
            four);
  EXPECT_EQ(losses_of_model(model_of(object(tetrahedron({"", "", "p1=\"0\"", ""}), b))), four);
  EXPECT_EQ(losses_of_model(model_of(object(tetrahedron({r, r + " p2='0' p3='1'", r, r})))), four)
      << "a colour for each corner";
  const std::string p1 = "p1=\"1\"";  // which the library takes for none
  EXPECT_EQ(losses_of_model(model_of(object(tetrahedron({p1, p1, p1, p1}), "pid='1' pindex='0'"))),
            four);
}

TEST_F(ThreeMfLosses, OneColourOfAnObjectIsDrawn) {
  const std::string b = "pid=\"1\" p1=\"1\"";
  for (const std::string& objects :
       {object(tetrahedron({b, b, b, b})), object(tetrahedron(), "pid=\"1\" pindex=\"1\""),
        object(tetrahedron({b, b, b + " p2=\"1\" p3=\"1\"", b}), "pid=\"1\" pindex=\"1\"")}) {
    const Mesh mesh = read_3mf(model_of(objects));
    EXPECT_EQ(mesh.skipped.warnings, Sentences{});
    EXPECT_EQ(faces_in(Colour(0, 0, 1), mesh), 4u);
  }
  EXPECT_EQ(losses_of_model(model_of(object(tetrahedron()))), Sentences{});
}

TEST_F(ThreeMfLosses, GroupsOfOtherThanMaterialsAreNamed) {
  EXPECT_EQ(losses_of_model(model_of(object(tetrahedron(), "pid=\"2\" pindex=\"1\""))),
            Sentences{"left out: the colours of 4 triangles (colorgroup)"});
}

TEST_F(ThreeMfLosses, ComponentsArePlaced) {
  const std::string turned = "0 1 0 -1 0 0 0 0 1 0 7 0", larger = "2 0 0 0 2 0 0 0 2 5 0 0";
  const Mesh mesh = read_3mf(model_of(
      object(tetrahedron(), "", 2) +
          object(
              "<components><component objectid=\"2\" transform=\"" + larger + "\"/></components>",
              "", 3) +
          object("<components><component objectid=\"2\"/><component objectid=\"3\" transform=\"" +
                 turned + "\"/></components>"),
      "", "<item objectid=\"9\" transform=\"1 0 0 0 1 0 0 0 1 100 0 0\"/>"));
  EXPECT_EQ(mesh.faces(), 8u);
  EXPECT_EQ(mesh.skipped.warnings, Sentences{});
  Point3 low(1e9), high(-1e9);
  for (std::size_t i = 4; i < 8; ++i) {
    for (const std::uint32_t v : mesh.face(i)) {
      low = glm::min(low, mesh.vertices[v]);
      high = glm::max(high, mesh.vertices[v]);
    }
  }
  // x from 5 to 7 and y from 0 to 2, turned by a right angle to y and -x, and moved.
  EXPECT_EQ(low, Point3(98, 12, 0));
  EXPECT_EQ(high, Point3(100, 14, 2));
}

TEST_F(ThreeMfLosses, ExtensionsThatAreRequiredAndNotReadAreRefusedByName) {
  expect_error([&] { read_mesh(model("3mf-production.3mf")); },
               "requires the 3MF extension http://schemas.microsoft.com/3dmanufacturing/"
               "production/2015/06, which is not read");
  const auto requires_ = [&](const std::string& prefixes) {
    return model_of(object(tetrahedron()), "requiredextensions=\"" + prefixes + "\"");
  };
  for (const char* prefixes : {"m", " m ", "p m", "m b"}) {
    expect_error([&] { read_3mf(requires_(prefixes)); }, "3dmanufacturing/material/2015/02");
  }
  expect_error([&] { read_3mf(requires_("b")); }, "3dmanufacturing/beamlattice/2017/02");
  expect_error([&] { read_3mf(requires_("unheard-of")); }, "requires the 3MF extension unheard-of");
  EXPECT_EQ(losses_of_model(requires_("")), Sentences{});
  EXPECT_EQ(losses_of_model(requires_("p")), Sentences{}) << "nothing is in another part";
}

TEST_F(ThreeMfLosses, WhatIsElsewhereAndNotRequiredIsTold) {
  const std::string elsewhere =
      "<components><component p:path=\"/3D/other.model\" objectid=\"2\"/></components>";
  const std::string objects = object(elsewhere, "", 5) + object(tetrahedron());
  EXPECT_EQ(
      losses_of_model(model_of(objects, "", kItem + std::string("<item objectid=\"5\"/>"))),
      Sentences{"left out: 1 component in another part of the file (the production extension)"});
  expect_error([&] { read_3mf(model_of(object(elsewhere))); },
               "left out: 1 component in another part of the file (the production extension)");
  EXPECT_EQ(losses_of_model(model_of(object(tetrahedron({"", "", "", ""}, "<b:beamlattice/>")))),
            Sentences{"left out: 1 beam lattice"});
}

TEST_F(ThreeMfLosses, WhatIsNoTagIsNoTag) {
  const std::string r = "pid=\"1\" p1=\"0\"", other = "<triangle pid=\"2\" p1=\"1\"/>";
  const std::string mesh = tetrahedron({r, r, r, r});
  for (const std::string& aside :
       {"<!-- " + other + " -->", "<![CDATA[" + other + "]]>", "<?x " + other + "?>"}) {
    std::string with = mesh;
    with.insert(with.find("<triangles>"), "<metadata name=\"a &gt; b\">" + aside + "</metadata>");
    EXPECT_EQ(losses_of_model(model_of(object(with))), Sentences{}) << aside;
  }
}

TEST_F(ThreeMfLosses, AModelThatIsNotReadIsRefused) {
  std::string prefixed = model_of(object(tetrahedron()));
  prefixed.replace(prefixed.find("<model"), 6, "<c:model");
  expect_error([&] { read_3mf(prefixed); }, "begins with 'c:model'");
  std::string wide = "\xFF\xFE";
  for (const char c : model_of(object(tetrahedron()))) wide += {c, '\0'};
  EXPECT_THROW(read_3mf(wide), Error);
  std::string cut = test::file_of_3mf(model_of(object(tetrahedron())));
  expect_error([&] { read_mesh(file("cut.3mf", cut.substr(0, cut.size() / 2))); }, "cut.3mf: ");
  std::string changed = cut;
  changed[changed.find("<vertices>") + 1] ^= 1;
  expect_error([&] { read_mesh(file("sum.3mf", changed)); }, "3D/3dmodel.model in it is damaged");
}

// ---- Tags ------------------------------------------------------------------------------

std::string tags_of(std::string_view text) {
  std::string all;
  XmlTags tags(text);
  while (const XmlTag* tag = tags.next()) {
    all += fmt::format("{}(", tag->name);
    for (const auto& [name, value] : tag->attributes) all += fmt::format("{}={};", name, value);
    all += ")";
  }
  return all;
}

TEST(XmlTags, AreStartTagsWithTheirAttributes) {
  EXPECT_EQ(tags_of("<?xml version='1.0'?><!DOCTYPE a><a><b:c d = \"1\"\n e:f='>\"/<'/></a>"),
            "a()b:c(d=1;e:f=>\"/<;)");
  EXPECT_EQ(tags_of("<!-- <x/> -- > --><a/><![CDATA[<x y='z'/>]]><b/>"), "a()b()");
  EXPECT_EQ(tags_of("text < <a b='1' c>"), "a(b=1;)");
  for (const char* cut : {"", "<", "<a", "<a ", "<a b", "<a b=", "<a b=\"", "<!--", "<![CDATA[x",
                          "</a", "<?", "<>", "</>", "<a b=1>"}) {
    EXPECT_NO_THROW(tags_of(cut)) << cut;
  }
  XmlTags tags("<b:c d:e='1' e='2'/>");
  const XmlTag* tag = tags.next();
  ASSERT_NE(tag, nullptr);
  EXPECT_EQ(tag->local_name(), "c");
  EXPECT_EQ(tag->value("e"), "2");
  EXPECT_EQ(tag->value("x"), std::nullopt);
}

// ---- Damaged files ---------------------------------------------------------------------

/// Files are looked at in the process in which the library reads them, which may be ours.
TEST_F(ImportLosses, DamagedFilesAreErrorsOrLosses) {
  const SharedLibrary library(DISPLAYFILE_IMPORT_LIBRARY);
  Gltf gltf = skinned({{"name", "j"}});
  const std::string r = "pid=\"1\" p1=\"0\"";
  const std::vector<std::pair<std::string, std::string>> files{
      {"a.gltf", gltf.text("a%20b.bin")},
      {"a.glb", gltf.binary()},
      {"a.3mf", test::file_of_3mf(model_of(object(tetrahedron({r, "", r, r}))))},
      {"b.3mf", test::content(model("3mf-triangle-colours.3mf"))}};
  std::mt19937_64 random(1);
  for (const auto& [name, bytes_of_file] : files) {
    int refused = 0, taken = 0;
    for (int i = 0; i < 200; ++i) {
      const std::string path = file(name, test::mutated(bytes_of_file, files[0].second, random));
      try {
        losses_of(path, true, library);
        ++taken;
      } catch (const Error& e) {
        EXPECT_TRUE(std::string(e.what()).starts_with(path + ": ")) << e.what();
        ++refused;
      }
    }
    EXPECT_GT(refused, 0) << name;
    EXPECT_GT(taken, 0) << name;
  }
}

}  // namespace
}  // namespace displayfile
