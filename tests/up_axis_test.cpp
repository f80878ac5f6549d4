// Which axis is up in meshes of different formats, and in pictures of several.

#include "displayfile/mesh/up_axis.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "displayfile/mesh/fitted_view.h"
#include "displayfile/mesh/import_library.h"
#include "displayfile/mesh/mesh.h"
#include "tests/temporary_folder.h"

namespace displayfile {
namespace {

const std::filesystem::path kModels = "/usr/share/assimp/models";

using UpAxis = test::TemporaryFolder;

class UpAxisOfImported : public test::TemporaryFolder {
 protected:
  void SetUp() override {
    if (!import_library_version()) GTEST_SKIP() << "no import library";
  }
  /// The up axis that a file or its format sets.
  std::optional<Upright> in_file(const std::string& name, const std::string& text) {
    return read_mesh(file(name, text)).upright;
  }
};

constexpr const char* kObj = "v 0 0 0\nv 1 0 0\nv 0 1 4\nf 1 2 3\n";
constexpr const char* kSmd =
    "version 1\nnodes\n0 \"root\" -1\nend\nskeleton\ntime 0\n0 0 0 0 0 0 0\nend\ntriangles\nm\n"
    "0 0 0 0 0 0 1 0 0\n0 1 0 0 0 0 1 0 0\n0 0 1 4 0 0 1 0 0\nend\n";

std::string opengex(const std::string& metrics) {
  return metrics +
         "GeometryNode $node1 { Name {string {\"up\"}} ObjectRef {ref {$geometry1}} }\n"
         "GeometryObject $geometry1 { Mesh (primitive = \"triangles\") {\n"
         "VertexArray (attrib = \"position\") { float[3] { {0, 0, 0}, {1, 0, 0}, {0, 1, 4} } }\n"
         "IndexArray { unsigned_int32[3] { {0, 1, 2} } } } }\n";
}

TEST_F(UpAxis, OfFormatsReadHereNothingIsSaidAndPrintersHaveZUp) {
  const Mesh obj = read_mesh(file("a.obj", kObj));
  EXPECT_FALSE(obj.upright || obj.usual_upright);
  const Mesh off = read_mesh(file("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 4\n3 0 1 2\n"));
  EXPECT_FALSE(off.upright || off.usual_upright);
  const Mesh stl =
      read_mesh(file("A.STL",
                     "solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                     "vertex 0 1 4\nendloop\nendfacet\nendsolid\n"));
  EXPECT_EQ(stl.upright, upright("z"));
}

TEST_F(UpAxisOfImported, OfFormatsThatLayItDown) {
  EXPECT_EQ(in_file("a.smd", kSmd), upright("z"));
  EXPECT_EQ(in_file("a.ogex", opengex("")), upright("z"));
  EXPECT_EQ(in_file("a.ogex", opengex("Metric (key = \"up\") {string {\"z\"}}\n")), upright("z"));
  EXPECT_EQ(in_file("a.ogex", opengex("Metric (key = \"time\") {float {1}}\n"
                                      "Metric (key=\"up\"){string{\"y\"}}\n")),
            upright("y"));
  EXPECT_EQ(in_file("a.ogex", opengex("Metric (key = \"time\") {float {1}}\n")), upright("z"));
}

TEST_F(UpAxisOfImported, OfModelsIsAsTheirFilesSay) {
  const auto path = kModels / "FBX/cubes_nonames.fbx";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  const std::string text = test::content(path);
  const auto says = [&](const std::string& axis, const std::string& sign) {
    std::string changed = text;
    for (const auto& [key, value] : {std::pair("\"UpAxis\"", axis), {"\"UpAxisSign\"", sign}}) {
      const std::string before = std::string(key) + ", \"int\", \"Integer\", \"\",";
      changed.replace(changed.find(before) + before.size(), 1, value);
    }
    return in_file("a.fbx", changed);
  };
  EXPECT_EQ(read_mesh(path).upright, upright("y"));
  EXPECT_EQ(says("1", "1"), upright("y"));
  EXPECT_EQ(says("2", "1"), upright("z"));
  EXPECT_EQ(says("0", "1"), upright("x"));
  EXPECT_EQ(says("2", "-1"), upright("-z"));
  EXPECT_EQ(says("7", "1"), upright("y")) << "which is no axis";
  // The library turns COLLADA to y up, and leaves Blender's worlds as they are.
  for (const auto& [model, axis] : {std::pair("BLEND/box.blend", "z"), {"Collada/duck.dae", "y"}}) {
    EXPECT_EQ(read_mesh(kModels / model).upright, upright(axis)) << model;
  }
}

TEST(NearestUpright, IsThatOfTheNearestAxis) {
  for (const char* axis : {"x", "-x", "y", "-y", "z", "-z"}) {
    EXPECT_EQ(nearest_upright(100.0 * upright(axis).up + Point3(0.1, -0.2, 0.3)), upright(axis));
  }
  EXPECT_EQ(nearest_upright(Point3(0.0)), upright("y"));
  EXPECT_EQ(nearest_upright(Point3(1.0)), upright("y"));
}

/// A mesh of one triangle.
Mesh standing(const std::optional<Upright>& said, const std::optional<Upright>& usual = {}) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 4}};
  mesh.corners = {0, 1, 2};
  mesh.first_corner = {0, 3};
  mesh.objects = {{"", 0, 1}};
  mesh.upright = said;
  mesh.usual_upright = usual;
  return mesh;
}

CommonUpright common(const std::vector<Mesh>& meshes, const Camera& camera = {},
                     const ModellingTransformation& modelling = {}) {
  CommonUpright common(camera);
  for (const Mesh& mesh : meshes) common.add(mesh, modelling);
  return common;
}

TEST(CommonUpright, IsWhatTheCameraOrTheMeshesSay) {
  const Upright x = upright("x"), y = upright("y"), z = upright("z");
  const Camera by_custom{.upright = UprightBy::convention}, said{.upright = x};
  EXPECT_EQ(common({}).upright(), y);
  EXPECT_EQ(common({standing({})}).upright(), y);
  EXPECT_EQ(common({standing(z)}).upright(), z);
  EXPECT_EQ(common({standing(z)}, said).upright(), x);
  EXPECT_EQ(common({standing({}, z)}).upright(), y) << "unless custom is asked for";
  EXPECT_EQ(common({standing({}, z)}, by_custom).upright(), z);
  EXPECT_EQ(common({standing(y, z)}, by_custom).upright(), y);
  EXPECT_EQ(common({standing({}), standing(z), standing({})}).upright(), z);
  EXPECT_FALSE(common({standing({}), standing(z), standing({}), standing(z)}).differ());
  const CommonUpright differing = common({standing(z), standing(x), standing(x)});
  EXPECT_TRUE(differing.differ());
  EXPECT_EQ(differing.upright(), y);
  EXPECT_FALSE(common({standing(z), standing(y)}, said).differ());
  EXPECT_EQ(std::get<Upright>(common({standing(z)}).camera().upright), z);
}

TEST(CommonUpright, TurnsWithTheModellingTransformation) {
  ModellingTransformation modelling;
  modelling.scale({-2, 3, 5});
  modelling.translate({1e20, -1e20, 7});
  EXPECT_EQ(common({standing(upright("z"))}, {}, modelling).upright(), upright("z"));
  modelling.rotate_x(-90);
  EXPECT_EQ(common({standing(upright("z"))}, {}, modelling).upright(), upright("y"));
  modelling.rotate_z(20);
  EXPECT_EQ(common({standing(upright("z"))}, {}, modelling).upright(), upright("y"));
}

TEST(CommonUpright, AFittedViewFollowsIt) {
  const std::vector<Mesh> z_up{standing(upright("z"))};
  const auto view_up = [&](const std::vector<Mesh>& meshes, const Camera& camera) {
    GraphicsSystem system;
    fit_view(meshes, system, camera);
    return system.view().up;
  };
  EXPECT_EQ(view_up(z_up, {}), Point3(0, 0, 1));
  EXPECT_EQ(view_up(z_up, {.upright = upright("-x")}), Point3(-1, 0, 0));
  EXPECT_EQ(view_up({standing({})}, {}), Point3(0, 1, 0));
}

TEST_F(UpAxisOfImported, MeshesThatStandDifferentlyAreToldOnce) {
  const std::string smd = file("a.smd", kSmd),
                    ogex = file("a.ogex", opengex("Metric (key = \"up\") {string {\"y\"}}"));
  const std::string obj = file("a.obj", kObj);
  GraphicsSystem system;
  const std::vector<std::string> both{smd, ogex};
  const auto skipped = import_meshes(both, system).skipped;
  ASSERT_EQ(skipped[0].warnings, std::vector<std::string>{std::string(kStandDifferently)});
  EXPECT_TRUE(skipped[1].warnings.empty());
  EXPECT_EQ(system.view().up, Point3(0, 1, 0));
  GraphicsSystem agreeing;
  const std::vector<std::string> agree{obj, smd};
  const auto agreed = import_meshes(agree, agreeing);
  for (const auto& of_mesh : agreed.skipped) EXPECT_TRUE(of_mesh.warnings.empty());
  EXPECT_EQ(agreeing.view().up, Point3(0, 0, 1));
}

}  // namespace
}  // namespace displayfile
