// Parts of glTF files that the import library passes over silently are refused or reported by name:
// extensions, skins, morph targets. Names in glTF are decoded.

#include "displayfile/mesh/import_losses.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/mesh/import_library.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/mesh/neighbour_files.h"
#include "displayfile/mesh/xml_tags.h"
#include "tests/error_of.h"
#include "tests/fuzz/mutated_bytes.h"
#include "tests/gltf_files.h"
#include "tests/mesh_files.h"

namespace displayfile {
namespace {

using test::bytes;
using test::expect_error;
using test::Gltf;
using test::Json;
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

// ---- glTF that the library reads ---------------------------------------------------------

class GltfLosses : public ImportLosses {
 protected:
  /// The file as JSON with a buffer beside it, and as a binary one. The library's input has a
  /// primitive that may be compressed.
  std::vector<std::string> both(Gltf gltf) const {
    gltf.file["meshes"].push_back(Json::parse(R"({"primitives":[{"attributes":{"POSITION":0},
            "extensions":{"KHR_draco_mesh_compression":{}}}]})"));
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

/// As KHR_mesh_quantization allows them, in a file that does not require that extension.
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
  expect_losses(skinned({{"name", "j"}, {"translation", {0, 0, 2}}}), one);
  expect_losses(skinned({{"name", "j"}, {"scale", {1, 1.5, 1}}}), one);
  // A skin ignores the transformation of its own node.
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

TEST_F(GltfLosses, AnimationsThatMoveSomethingAreTold) {
  Gltf gltf;
  const std::size_t times = gltf.add(bytes(0.f) + bytes(1.f), 5126, 2, "SCALAR");
  gltf.file["accessors"][times]["min"] = {0};
  gltf.file["accessors"][times]["max"] = {1};
  const std::size_t places =
      gltf.add(std::string(12, '\0') + bytes(1.f) + bytes(2.f) + bytes(3.f), 5126, 2, "VEC3");
  gltf.file["animations"] = Json::parse(fmt::format(
      R"([{{"samplers":[{{"input":{},"output":{}}}],
          "channels":[{{"sampler":0,"target":{{"node":0,"path":"translation"}}}}]}}])",
      times, places));
  expect_losses(gltf, {"left out: 1 animation"});
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
  Gltf gltf = skinned({{"name", "j"}});
  const std::string text = gltf.text("a%20b.bin");
  std::mt19937_64 random(1);
  for (const auto& [name, content] :
       {std::pair<std::string, std::string>("a.gltf", text), {"a.glb", gltf.binary()}}) {
    int refused = 0, taken = 0;
    for (int i = 0; i < 200; ++i) {
      const std::string path = file(name, test::mutated(content, text, random));
      try {
        losses_of_gltf(path);
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
