// glTF 2.0 as its specification has it, read in the import process: kinds of accessors, nodes,
// morph targets, skins and instances at rest, colours. The kinds are those of Khronos' samples.

#include "displayfile/mesh/formats_beside_library.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/common.hpp>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/mesh/import_library.h"
#include "displayfile/mesh/mesh.h"
#include "tests/error_of.h"
#include "tests/fuzz/mutated_bytes.h"
#include "tests/gltf_files.h"
#include "tests/mesh_colours.h"

namespace displayfile {
namespace {

using test::bytes;
using test::colours_of;
using test::expect_error;
using test::Gltf;
using test::Json;
using test::text_of;
using Points = std::vector<Point3>;
using Sentences = std::vector<std::string>;

class GltfTest : public test::MeshFiles {
 protected:
  void SetUp() override {
    if (!import_library_version()) GTEST_SKIP() << "no import library";
  }

  /// The file as JSON with a buffer beside it, with one in it, and as a binary one.
  std::vector<std::string> all_forms(Gltf gltf) const {
    file("b.bin", gltf.buffer);
    return {
        file("a.gltf", gltf.text("b.bin")),
        file("b.gltf", gltf.text("data:application/octet-stream;base64," + base64(gltf.buffer))),
        file("a.glb", gltf.binary())};
  }
  Mesh read(const Gltf& gltf) const { return read_mesh(all_forms(gltf)[0]); }

  /// The vertices in the order of the faces' corners.
  static Points corners_of(const Mesh& mesh) {
    Points corners;
    for (const std::uint32_t corner : mesh.corners) corners.push_back(mesh.vertices[corner]);
    return corners;
  }
  void expect_corners(const Gltf& gltf, const Points& expected) const {
    for (const std::string& path : all_forms(gltf)) {
      const Mesh mesh = read_mesh(path);
      EXPECT_EQ(corners_of(mesh), expected) << path;
      EXPECT_EQ(mesh.skipped.warnings, Sentences{}) << path;
    }
  }
  void expect_refused(const Gltf& gltf, const std::string& words) const {
    for (const std::string& path : all_forms(gltf)) {
      expect_error([&] { read_mesh(path); }, path + ": " + words);
    }
  }

 private:
  static std::string base64(const std::string& data) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < data.size(); i += 3) {
      std::uint32_t bits = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto byte = i + k < data.size() ? static_cast<unsigned char>(data[i + k]) : 0u;
        bits = bits << 8 | byte;
      }
      for (std::size_t k = 0; k < 4; ++k) {
        text += i + k > data.size() ? '=' : digits[bits >> (18 - 6 * k) & 63];
      }
    }
    return text;
  }
};

const Points kTriangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

Points moved(const Points& points, const std::function<Point3(const Point3&)>& move) {
  Points result;
  for (const Point3& p : points) result.push_back(move(p));
  return result;
}

template <class Number>
std::string packed(std::initializer_list<Number> numbers) {
  std::string data;
  for (const Number n : numbers) data += bytes(n);
  return data;
}

// ---- Accessors -------------------------------------------------------------------------

TEST_F(GltfTest, ATriangle) {
  expect_corners(Gltf{}, kTriangle);
  EXPECT_EQ(read(Gltf{}).upright, Upright{});
}

TEST_F(GltfTest, IndicesOfEveryType) {
  const Points expected{kTriangle[2], kTriangle[1], kTriangle[0]};
  for (const auto& [type, data] : {std::pair{5121, packed<std::uint8_t>({2, 1, 0})},
                                   {5123, packed<std::uint16_t>({2, 1, 0})},
                                   {5125, packed<std::uint32_t>({2, 1, 0})}}) {
    Gltf gltf;
    gltf.primitive()["indices"] = gltf.add(data, type, 3, "SCALAR");
    expect_corners(gltf, expected);
  }
}

/// KHR_mesh_quantization, which a file need not require.
TEST_F(GltfTest, QuantizedPositions) {
  const auto with = [](const std::string& data, int type, bool normalized, bool is_required) {
    Gltf gltf;
    const std::size_t accessor = gltf.add(data, type, 3, "VEC3");
    if (normalized) gltf.file["accessors"][accessor]["normalized"] = true;
    gltf.primitive()["attributes"]["POSITION"] = accessor;
    const int stride = type == 5120 || type == 5121 ? 4 : 8;
    gltf.file["bufferViews"][accessor]["byteStride"] = stride;
    if (is_required) gltf.file["extensionsRequired"] = {"KHR_mesh_quantization"};
    return gltf;
  };
  for (const bool is_required : {false, true}) {
    const Points whole{{0, 0, 0}, {100, 0, 0}, {0, 127, 3}};
    const std::string of_bytes = packed<std::int8_t>({0, 0, 0, 9, 100, 0, 0, 9, 0, 127, 3, 9});
    const std::string of_two = packed<std::int16_t>({0, 0, 0, 9, 100, 0, 0, 9, 0, 127, 3, 9});
    for (const int type : {5120, 5121}) {
      expect_corners(with(of_bytes, type, false, is_required), whole);
    }
    for (const int type : {5122, 5123}) {
      expect_corners(with(of_two, type, false, is_required), whole);
    }
    expect_corners(with(of_bytes, 5120, true, is_required),
                   moved(whole, [](const Point3& p) { return p / 127.0; }));
    expect_corners(with(of_two, 5123, true, is_required),
                   moved(whole, [](const Point3& p) { return p / 65535.0; }));
  }
  const std::string lowest = packed<std::int8_t>({-128, 0, 0, 0, 127, 0, 0, 0, 0, 127, 0, 0});
  expect_corners(with(lowest, 5120, true, true), {{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const Mesh cube = read_mesh(DISPLAYFILE_SOURCE_DIR "/tests/meshes/gltf-quantized.gltf");
  EXPECT_EQ(cube.faces(), 12u);
  for (const Point3& p : cube.vertices) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_TRUE(p[axis] == 0.0 || p[axis] == 1.0) << p[axis];
  }
}

TEST_F(GltfTest, InterleavedAndOffsetAccessors) {
  Gltf gltf;
  std::string data = "junk";
  for (const Point3& p : kTriangle) {
    for (int axis = 0; axis < 3; ++axis) data += bytes(static_cast<float>(p[axis]));
    data += bytes(9.0f) + bytes(9.0f);
  }
  const std::size_t accessor = gltf.add(data, 5126, 3, "VEC3");
  gltf.file["accessors"][accessor]["byteOffset"] = 4;
  gltf.file["bufferViews"][accessor]["byteStride"] = 20;
  gltf.primitive()["attributes"]["POSITION"] = accessor;
  expect_corners(gltf, kTriangle);
}

TEST_F(GltfTest, SparseAccessors) {
  Gltf gltf;
  const std::size_t indices = gltf.add("\2", 5121, 1, "SCALAR");
  const std::size_t values = gltf.add(packed({0.f, 2.f, 0.5f}), 5126, 1, "VEC3");
  const Json sparse{{"count", 1},
                    {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                    {"values", {{"bufferView", values}}}};
  gltf.file["accessors"][0]["sparse"] = sparse;
  expect_corners(gltf, {{0, 0, 0}, {1, 0, 0}, {0, 2, 0.5}});
  // Without a buffer view all others are zeros.
  Gltf zeros = gltf;
  zeros.file["accessors"][0].erase("bufferView");
  expect_refused(zeros, "no faces: expected polygons (found 0 points and lines, and 1 faces");
}

TEST_F(GltfTest, DataThatAreNotThereAreRefused) {
  const auto refused = [&](const std::function<void(Gltf&)>& change, const std::string& words) {
    Gltf gltf;
    gltf.primitive()["indices"] = gltf.add(std::string("\0\1\2", 3), 5121, 3, "SCALAR");
    change(gltf);
    expect_refused(gltf, "not a mesh that can be read: glTF: " + words);
  };
  refused([](Gltf& g) { g.file["accessors"][0]["count"] = 4; },
          "accessor 0: 4 elements announced, but its buffer view has 36 bytes");
  refused([](Gltf& g) { g.file["accessors"][0]["byteOffset"] = 1; }, "accessor 0: 3 elements");
  refused([](Gltf& g) { g.file["accessors"][0]["count"] = 4000000000u; }, "accessor 0: 4000000000");
  refused([](Gltf& g) { g.file["accessors"][0]["count"] = -1; }, "accessor 0: expected a count");
  refused([](Gltf& g) { g.file["accessors"][0]["type"] = "VEC2"; }, "accessor 0: VEC2: expected 3");
  refused([](Gltf& g) { g.file["accessors"][0]["type"] = "VEC9"; }, "accessor 0: its type");
  refused([](Gltf& g) { g.file["accessors"][0]["componentType"] = 7; }, "accessor 0: its type");
  refused([](Gltf& g) { g.file["bufferViews"][0]["byteLength"] = 999; },
          "accessor 0: its buffer view ends behind its buffer");
  refused([](Gltf& g) { g.file["bufferViews"][0]["byteOffset"] = 8; },
          "accessor 0: its buffer view ends behind its buffer");
  refused([](Gltf& g) { g.file["bufferViews"][0]["buffer"] = 1; }, "accessor 0: its buffer is not");
  refused([](Gltf& g) { g.file["accessors"][0]["bufferView"] = 7; }, "accessor 0: its buffer view");
  refused([](Gltf& g) { g.primitive()["attributes"]["POSITION"] = 7; },
          "accessor 7: there is none");
  refused([](Gltf& g) { g.primitive()["material"] = 0; }, "material 0: there is none");
  refused([](Gltf& g) { g.file["nodes"][0]["mesh"] = 1; }, "mesh 1: there is none");
  refused([](Gltf& g) { g.file["nodes"][0]["skin"] = 0; }, "skin 0: there is none");
  refused([](Gltf& g) { g.file["scene"] = 1; }, "scene 1: there is none");
  refused([](Gltf& g) { g.primitive()["mode"] = 7; }, "mode 7: expected 0 to 6");
  refused([](Gltf& g) { g.buffer[36] = 3; }, "vertex index 3 out of range");
  refused([](Gltf& g) { g.buffer.replace(0, 4, bytes(std::nanf(""))); },
          "accessor 0: expected fin");
  Gltf elsewhere;
  for (const char* uri :
       {"gone.bin", "../b.bin", "/etc/passwd", "data:text/plain,abc", "data:;base64,@@@@"}) {
    expect_error([&] { read_mesh(file("a.gltf", elsewhere.text(uri))); }, "glTF: accessor 0: ");
  }
}

/// Members of the wrong type are not treated as missing.
TEST_F(GltfTest, MembersOfOtherTypesAreRefused) {
  const auto refused = [&](const std::function<void(Json&)>& change, const std::string& words) {
    Gltf gltf;
    gltf.file["materials"] = Json::parse("[{}]");
    gltf.primitive()["material"] = 0;
    change(gltf.file);
    expect_refused(gltf, "not a mesh that can be read: glTF: " + words);
  };
  refused(
      [](Json& f) {
        f["nodes"][0]["translation"] = {1, 2};
      },
      "translation: expected 3 numbers");
  refused([](Json& f) { f["nodes"][0]["rotation"] = {1, 2, 3, "4"}; }, "rotation: expected 4 num");
  refused([](Json& f) { f["nodes"][0]["scale"] = 2; }, "scale: expected an array");
  refused([](Json& f) { f["nodes"][0]["matrix"] = {1, 2, 3}; }, "matrix: expected 16 numbers");
  refused([](Json& f) { f["nodes"][0]["children"] = 0; }, "children: expected an array");
  refused([](Json& f) { f["scene"] = "0"; }, "scene: expected a whole number");
  refused([](Json& f) { f["accessors"][0]["byteOffset"] = -1; }, "byteOffset: expected a whole nu");
  refused([](Json& f) { f["bufferViews"][0]["byteLength"] = "36"; },
          "byteLength: expected a whole");
  refused([](Json& f) { f["meshes"][0]["primitives"] = 1; }, "primitives: expected an array");
  refused([](Json& f) { f["materials"][0]["pbrMetallicRoughness"] = 1; },
          "pbrMetallicRoughness: expected an object");
  refused(
      [](Json& f) {
        f["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {1, 0};
      },
      "baseColorFactor: expected 4 numbers");
  refused([](Json& f) { f["materials"][0]["alphaCutoff"] = "1"; },
          "alphaCutoff: expected a number");
  refused([](Json& f) { f["meshes"][0]["primitives"][0]["mode"] = 4.5; }, "mode: expected a whole");
}

// ---- Primitives ------------------------------------------------------------------------

TEST_F(GltfTest, StripsAndFans) {
  Gltf gltf;
  gltf.primitive()["attributes"]["POSITION"] =
      gltf.add(packed({0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 1.f, 1.f, 0.f, 0.f, 2.f, 0.f}),
               5126, 5, "VEC3");
  const Point3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), d(1, 1, 0), e(0, 2, 0);
  gltf.primitive()["mode"] = 5;
  expect_corners(gltf, {a, b, c, b, d, c, c, d, e});
  gltf.primitive()["mode"] = 6;
  expect_corners(gltf, {a, b, c, a, c, d, a, d, e});
}

TEST_F(GltfTest, PointsAndLinesAreCounted) {
  for (const auto& [mode, count] : {std::pair{0, 3u}, {1, 1u}, {2, 3u}, {3, 2u}}) {
    Gltf gltf;
    gltf.primitive()["mode"] = mode;
    expect_refused(gltf, fmt::format("no faces: expected polygons (found {} points", count));
    gltf.file["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}});
    EXPECT_EQ(read(gltf).skipped.points_and_lines, count) << mode;
  }
}

TEST_F(GltfTest, PrimitivesWithoutPositionsAreTold) {
  Gltf gltf;
  gltf.file["meshes"][0]["primitives"].push_back(
      {{"extensions", {{"ACME_shape", Json::object()}}}});
  EXPECT_EQ(read(gltf).skipped.warnings, Sentences{"left out: 1 primitive without positions"});
}

TEST_F(GltfTest, NormalsAreReadAndTurned) {
  Gltf gltf;
  gltf.primitive()["attributes"]["NORMAL"] =
      gltf.add(packed({0.f, 0.f, 1.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f}), 5126, 3, "VEC3");
  gltf.file["nodes"][0]["rotation"] = {1, 0, 0, 1};  // by a right angle about x
  gltf.file["nodes"][0]["scale"] = {1, 1, -1};       // and mirrored
  const Mesh mesh = read_mesh(all_forms(gltf)[0], true);
  ASSERT_EQ(mesh.corner_normals.size(), 3u);
  for (std::size_t corner = 0; corner < 3; ++corner) {
    EXPECT_EQ(mesh.normal(corner), Point3(0, 1, 0)) << "outward: the faces are turned too";
  }
  EXPECT_EQ(corners_of(mesh), (Points{{0, 0, 1}, {1, 0, 0}, {0, 0, 0}}));
  EXPECT_TRUE(read(gltf).corner_normals.empty());
}

// ---- Nodes -----------------------------------------------------------------------------

TEST_F(GltfTest, NodesAreTransformedExactly) {
  const auto with = [](const Json& node) {
    Gltf gltf;
    gltf.file["nodes"][0].update(node);
    return gltf;
  };
  const double s = 0.70710677;  // in single precision, not quite a unit
  expect_corners(with({{"rotation", {0, 0, s, s}}, {"translation", {4e6, 0.1, 0}}}),
                 {{4e6, 0.1, 0}, {4e6, 1.1, 0}, {4e6 - 1, 0.1, 0}});
  expect_corners(with({{"rotation", {0.5, 0.5, 0.5, 0.5}}}), {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  expect_corners(with({{"rotation", {0, 0.999999, 0, 0}}, {"scale", {2, 3, 4}}}),
                 {{0, 0, 0}, {-2, 0, 0}, {0, 3, 0}});
  expect_corners(with({{"matrix", {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1}}}),
                 {{5, 6, 7}, {5, 7, 7}, {4, 6, 7}});
}

TEST_F(GltfTest, ChildrenAreInTheirParents) {
  Gltf gltf;
  gltf.file["nodes"] = Json::parse(R"([{"children":[2,1],"translation":[10,0,0],"name":"root"},
      {"mesh":0,"translation":[0,1,0],"name":"b"},{"mesh":0,"scale":[2,2,2],"name":"a"},
      {"mesh":0,"name":"nowhere"}])");
  const Mesh mesh = read(gltf);
  EXPECT_EQ(corners_of(mesh),
            (Points{{10, 0, 0}, {12, 0, 0}, {10, 2, 0}, {10, 1, 0}, {11, 1, 0}, {10, 2, 0}}));
  ASSERT_EQ(mesh.objects.size(), 2u);
  EXPECT_EQ(mesh.objects[0].name, "a");
  EXPECT_EQ(mesh.objects[1].name, "b");
  EXPECT_EQ(mesh.skipped.warnings, Sentences{"left out: 1 object that is not in the scene"});
  gltf.file.erase("scene");
  EXPECT_EQ(read(gltf).faces(), 2u) << "the first scene";
  gltf.file.erase("scenes");
  EXPECT_EQ(read(gltf).faces(), 3u) << "all, where there is no scene";
}

TEST_F(GltfTest, NodesThatAreNoTreeAreRefused) {
  const auto refused = [&](const char* nodes, const std::string& words) {
    Gltf gltf;
    gltf.file["nodes"] = Json::parse(nodes);
    expect_refused(gltf, "not a mesh that can be read: glTF: node " + words);
  };
  refused(R"([{"children":[1]},{"children":[0],"mesh":0}])", "0: it is in the scene twice");
  refused(R"([{"children":[0],"mesh":0}])", "0: it is in the scene twice");
  refused(R"([{"children":[1,1]},{"mesh":0}])", "1: it is the child of two nodes");
  refused(R"([{"children":[7]}])", "0: its child 7 is none");
  std::string deep = "[";
  for (int i = 1; i < 100000; ++i) deep += fmt::format("{{\"children\":[{}]}},", i);
  Gltf gltf;
  gltf.file["nodes"] = Json::parse(deep + "{\"mesh\":0}]");
  EXPECT_EQ(read(gltf).faces(), 1u) << "however deep it is";
}

TEST_F(GltfTest, Instances) {
  for (const bool is_required : {false, true}) {
    Gltf gltf;
    Json attributes;
    attributes["TRANSLATION"] = gltf.add(packed({0.f, 0.f, 1.f, 5.f, 0.f, 0.f}), 5126, 2, "VEC3");
    attributes["ROTATION"] =
        gltf.add(packed({0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.5f, 0.5f}), 5126, 2, "VEC4");
    gltf.file["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = attributes;
    gltf.file["nodes"][0]["translation"] = {100, 0, 0};
    if (is_required) gltf.file["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    expect_corners(gltf,
                   {{100, 0, 1}, {101, 0, 1}, {100, 1, 1}, {105, 0, 0}, {105, 1, 0}, {104, 0, 0}});
    gltf.file["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["SCALE"] =
        gltf.add(packed({1.f, 1.f, 1.f}), 5126, 1, "VEC3");
    expect_refused(gltf, "not a mesh that can be read: glTF: attributes of instances");
  }
}

// ---- At rest ---------------------------------------------------------------------------

TEST_F(GltfTest, MorphTargetsInTheirWeights) {
  const auto with_target = [] {
    Gltf gltf;
    gltf.primitive()["targets"] =
        Json::array({{{"POSITION", gltf.add(packed({0.f, 0.f, 4.f, 0.f, 0.f, 0.f, 0.f, 8.f, 0.f}),
                                            5126, 3, "VEC3")}},
                     {{"POSITION", gltf.add(std::string(36, '\0'), 5126, 3, "VEC3")}}});
    return gltf;
  };
  const Points quarter{{0, 0, 1}, {1, 0, 0}, {0, 3, 0}};
  Gltf gltf = with_target();
  expect_corners(gltf, kTriangle);
  gltf.file["meshes"][0]["weights"] = {0.25, 1};
  expect_corners(gltf, quarter);
  gltf.file["nodes"][0]["weights"] = {-1, 0};
  expect_corners(gltf, {{0, 0, -4}, {1, 0, 0}, {0, -7, 0}});
  gltf.file["nodes"][0]["weights"] = {0, 0};
  expect_corners(gltf, kTriangle);
}

/// Two joints at the height 2, one of them turned by a right angle about x.
Gltf skinned(const std::vector<float>& weights) {
  Gltf gltf;
  std::string inverse_bind, all;
  for (int joint = 0; joint < 2; ++joint) {
    for (int i = 0; i < 16; ++i) inverse_bind += bytes(i % 5 == 0 ? 1.f : i == 14 ? -2.f : 0.f);
  }
  for (const float w : weights) all += bytes(w) + bytes(1.f - w) + bytes(0.f) + bytes(0.f);
  gltf.primitive()["attributes"]["JOINTS_0"] =
      gltf.add(packed<std::uint8_t>({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}), 5121, 3, "VEC4");
  gltf.primitive()["attributes"]["WEIGHTS_0"] = gltf.add(all, 5126, 3, "VEC4");
  gltf.file["skins"] = Json::parse(fmt::format(R"([{{"joints":[1,2],"inverseBindMatrices":{}}}])",
                                               gltf.add(inverse_bind, 5126, 2, "MAT4")));
  gltf.file["nodes"] = Json::parse(R"([{"mesh":0,"skin":0,"translation":[50,50,50]},
      {"translation":[0,0,2]},{"translation":[0,0,2],"rotation":[1,0,0,1]}])");
  gltf.file["scenes"][0]["nodes"] = {0, 1, 2};
  return gltf;
}

TEST_F(GltfTest, SkinsAtRest) {
  expect_corners(skinned({1, 1, 1}), kTriangle);
  // Around the height 2, z - 2 becomes -y and y becomes z - 2.
  expect_corners(skinned({0, 0, 0}), {{0, 2, 2}, {1, 2, 2}, {0, 2, 3}});
  expect_corners(skinned({1, 0.5, 0}), {{0, 0, 0}, {1, 1, 1}, {0, 2, 3}});
  const Mesh bent = read_mesh(DISPLAYFILE_SOURCE_DIR "/tests/meshes/gltf-skin.gltf");
  Point3 low(1e9), high(-1e9);
  for (const Point3& p : bent.vertices) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  EXPECT_EQ(low.y, 0.0);
  EXPECT_EQ(high.y, 3.0);
  EXPECT_EQ(low.z, -1.0);
  EXPECT_EQ(high.z, 0.0);
  EXPECT_EQ(bent.skipped.warnings, Sentences{});
  Gltf bad = skinned({1, 1, 0.5});
  bad.file["skins"][0]["joints"] = {1};
  expect_refused(bad, "not a mesh that can be read: glTF: joint 1 out of range: expected less");
  bad.file["skins"][0]["joints"] = {1, 2, 2};
  expect_refused(bad, "not a mesh that can be read: glTF: 2 inverse bind matrices for 3 joints");
  bad.file["skins"][0]["joints"] = {1, 3};
  expect_refused(bad, "not a mesh that can be read: glTF: joint 3: expected a node");
}

TEST_F(GltfTest, AnimationsAndVariantsAreTold) {
  Gltf gltf;
  gltf.file["animations"] = Json::parse(R"([{"channels":[],"samplers":[]}])");
  gltf.file["extensions"]["KHR_materials_variants"]["variants"] =
      Json::parse(R"([{"name":"a"},{"name":"b"}])");
  EXPECT_EQ(read(gltf).skipped.warnings,
            (Sentences{"left out: 1 animation", "left out: 2 variants of materials"}));
}

// ---- Looks -----------------------------------------------------------------------------

TEST_F(GltfTest, MaterialsAndColoursOfVertices) {
  Gltf gltf;
  gltf.file["materials"] = Json::parse(R"([
      {"pbrMetallicRoughness":{"baseColorFactor":[0,0,0,1]}},
      {"pbrMetallicRoughness":{"baseColorFactor":[0,0.5,0,0.25]},"alphaMode":"BLEND"},
      {"pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.25]}},
      {"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}},
      {"extensions":{"KHR_materials_pbrSpecularGlossiness":{"diffuseFactor":[0,0,1,1]}}},
      {"pbrMetallicRoughness":{"baseColorFactor":[1,0,0,0.25]},"alphaMode":"MASK"},
      {"pbrMetallicRoughness":{"baseColorFactor":[1,0,0,0.25]},"alphaMode":"MASK",
       "alphaCutoff":0.2}])");
  for (int m = 0; m < 7; ++m) {
    if (m > 0) gltf.file["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}});
    gltf.file["meshes"][0]["primitives"][static_cast<std::size_t>(m)]["material"] = m;
  }
  gltf.file["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}});
  const Mesh mesh = read(gltf);
  EXPECT_EQ(text_of(colours_of(mesh)),
            "(0 0 0)(0 0.5 0)(1 1 1)(1 1 1)(0 0 1)(1 0 0)(1 0 0)(1 1 1)");
  EXPECT_EQ(mesh.skipped.textured_faces, 1u);
  EXPECT_EQ(mesh.skipped.transparent_faces, 2u);
}

TEST_F(GltfTest, ColoursOfVerticesOfEveryType) {
  const auto with = [](const std::string& data, int type, const char* element, bool normalized) {
    Gltf gltf;
    const std::size_t accessor = gltf.add(data, type, 3, element);
    if (normalized) gltf.file["accessors"][accessor]["normalized"] = true;
    gltf.primitive()["attributes"]["COLOR_0"] = accessor;
    return gltf;
  };
  const std::string red = "(1 0 0.2)";
  const auto colour = [&](const Gltf& gltf) { return text_of(colours_of(read(gltf))); };
  EXPECT_EQ(colour(with(packed<std::uint8_t>({255, 0, 51, 255, 255, 0, 51, 255, 255, 0, 51, 255}),
                        5121, "VEC4", true)),
            red);
  EXPECT_EQ(colour(with(packed<std::uint16_t>({65535, 0, 13107, 65535, 0, 13107, 65535, 0, 13107}),
                        5123, "VEC3", true)),
            red);
  EXPECT_EQ(
      colour(with(packed({1.f, 0.f, .5f, 1.f, 0.f, .5f, 1.f, 0.f, .5f}), 5126, "VEC3", false)),
      "(1 0 0.5)");
  Gltf varied = with(packed({1.f, 0.f, 0.f, 0.f, 1.f, 0.f, .5f, .5f, 0.f}), 5126, "VEC3", false);
  const Mesh mesh = read(varied);
  EXPECT_EQ(text_of(colours_of(mesh)), "(0.5 0.5 0)");
  EXPECT_EQ(mesh.skipped.warnings.size(), 1u);
  // Opacity counts where the material is blended.
  Gltf clear =
      with(packed<std::uint8_t>({255, 0, 51, 0, 255, 0, 51, 0, 255, 0, 51, 0}), 5121, "VEC4", true);
  clear.file["materials"] = Json::parse(R"([{"alphaMode":"BLEND"},{}])");
  clear.primitive()["material"] = 0;
  EXPECT_EQ(read(clear).skipped.transparent_faces, 1u);
  clear.primitive()["material"] = 1;
  EXPECT_EQ(read(clear).skipped.transparent_faces, 0u);
}

// ---- Extensions ------------------------------------------------------------------------

TEST_F(GltfTest, ExtensionsThatAreRequiredAndNotReadAreRefusedByName) {
  for (const char* name : {"EXT_meshopt_compression", "ACME_of_our_own"}) {
    Gltf gltf;
    gltf.file["extensionsRequired"] = {"KHR_materials_unlit", name};
    expect_refused(gltf, fmt::format("requires the glTF extension {}, which is not read", name));
  }
  Gltf two;
  two.file["extensionsRequired"] = {"A", "KHR_texture_transform", "B"};
  expect_refused(two, "requires the glTF extensions A, B, which are not read");
  two.file["extensionsRequired"] = {"KHR_materials_unlit", "KHR_texture_basisu"};
  two.file["extensionsUsed"] = {"ACME_of_our_own", "KHR_materials_unlit", "KHR_texture_basisu"};
  expect_corners(two, kTriangle);
}

// ---- Damaged files ---------------------------------------------------------------------

/// In this process, where nothing else protects: each is a mesh or an exception.
TEST_F(GltfTest, DamagedFilesAreMeshesOrErrors) {
  Gltf gltf = skinned({1, 0.5, 0});
  gltf.primitive()["indices"] = gltf.add(std::string("\0\1\2", 3), 5121, 3, "SCALAR");
  std::mt19937_64 random(2);
  for (const auto& [name, content] :
       {std::pair<std::string, std::string>{"a.gltf", gltf.text("b.bin")},
        {"a.glb", gltf.binary()}}) {
    file("b.bin", gltf.buffer);
    int refused = 0, read = 0;
    for (int i = 0; i < 500; ++i) {
      const std::string path = file(name, test::mutated(content, Gltf{}.text("b.bin"), random));
      try {
        ++(read_gltf(path, true) ? read : refused);
      } catch (const std::exception&) {
        ++refused;
      }
    }
    EXPECT_GT(refused, 0) << name;
    EXPECT_GT(read, 0) << name;
  }
}

}  // namespace
}  // namespace displayfile
