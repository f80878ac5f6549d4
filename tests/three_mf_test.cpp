// 3MF as its specifications have it: colours of triangles, components, parts, units, whatever is
// left out. The kinds are those of the consortium's samples.

#include "displayfile/mesh/formats_beside_library.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/shared_library.h"
#include "displayfile/mesh/import_library.h"
#include "displayfile/mesh/mesh.h"
#include "tests/error_of.h"
#include "tests/fuzz/mutated_bytes.h"
#include "tests/mesh_colours.h"
#include "tests/three_mf_files.h"

namespace displayfile {
namespace {

using test::colours_of;
using test::expect_error;
using test::kItem;
using test::model_of;
using test::object;
using test::tetrahedron;
using test::text_of;
using Sentences = std::vector<std::string>;

class ThreeMfTest : public test::MeshFiles {
 protected:
  void SetUp() override {
    if (!import_library_version()) GTEST_SKIP() << "no import library";
  }

  Mesh read_3mf(const std::string& model) const {
    return read_mesh(file("a.3mf", test::file_of_3mf(model)));
  }
  /// With other parts, by their names.
  Mesh read_3mf(const std::string& model, const test::ArchiveFiles& others) const {
    test::ArchiveFiles parts = test::parts_of_3mf(model);
    parts.insert(parts.end(), others.begin(), others.end());
    return read_mesh(file("a.3mf", test::archive(parts)));
  }
  std::string colours(const std::string& objects) const {
    return text_of(colours_of(read_3mf(model_of(objects))));
  }
  Sentences losses(const std::string& objects) const {
    return read_3mf(model_of(objects)).skipped.warnings;
  }
  void expect_refused(const std::string& model, const std::string& words) const {
    expect_error([&] { read_3mf(model); }, "a.3mf: " + words);
  }
};

struct Box {
  Point3 low{1e9}, high{-1e9};
  bool operator==(const Box&) const = default;
};

Box box_of(const Mesh& mesh, std::size_t object = 0) {
  Box box;
  for (std::size_t i = 0; i < mesh.objects[object].faces; ++i) {
    for (const std::uint32_t v : mesh.face(mesh.objects[object].first_face + i)) {
      box.low = glm::min(box.low, mesh.vertices[v]);
      box.high = glm::max(box.high, mesh.vertices[v]);
    }
  }
  return box;
}

const std::string kRed = "pid=\"1\" p1=\"0\"", kBlue = "pid=\"1\" p1=\"1\"";

// ---- Colours ---------------------------------------------------------------------------

TEST_F(ThreeMfTest, TrianglesHaveTheirOwnColours) {
  std::map<std::string, int> faces;
  const Mesh cube = read_mesh(DISPLAYFILE_SOURCE_DIR "/tests/meshes/3mf-triangle-colours.3mf");
  for (const auto& c : colours_of(cube)) ++faces[text_of({c})];
  EXPECT_EQ(faces, (std::map<std::string, int>{{"(1 0 0)", 6}, {"(0 0 1)", 6}}));
  EXPECT_EQ(cube.skipped.warnings, Sentences{});
  EXPECT_EQ(colours(object(tetrahedron({kRed, kRed, kBlue, kRed}))),
            "(1 0 0)(1 0 0)(0 0 1)(1 0 0)");
  EXPECT_EQ(colours(object(tetrahedron({kRed, "", kRed, ""}), "pid='1' pindex='1'")),
            "(1 0 0)(0 0 1)(1 0 0)(0 0 1)")
      << "the object's, where a triangle has none";
  EXPECT_EQ(colours(object(tetrahedron({"p1=\"0\"", "", "", ""}), "pid='1' pindex='1'")),
            "(1 0 0)(0 0 1)(0 0 1)(0 0 1)")
      << "an index without its group is into the object's";
  EXPECT_EQ(colours(object(tetrahedron())), "(none)(none)(none)(none)");
}

TEST_F(ThreeMfTest, ColourGroups) {
  EXPECT_EQ(colours(object(tetrahedron(), "pid=\"2\" pindex=\"1\"")),
            "(1 0 0)(1 0 0)(1 0 0)(1 0 0)");
  const std::string same = "pid=\"2\" p1=\"0\" p2=\"0\" p3=\"0\"";
  const std::string varied = "pid=\"2\" p1=\"0\" p2=\"1\" p3=\"1\"";
  const std::string last_varies = "pid=\"2\" p1=\"1\" p3=\"0\"";
  const Mesh mesh = read_3mf(model_of(object(tetrahedron({same, varied, last_varies, same}))));
  const auto green = Colour(0, 1, 0);
  ASSERT_EQ(mesh.colour(0), green);
  EXPECT_EQ(mesh.colour(3), green);
  for (const std::size_t face : {1u, 2u}) {
    ASSERT_TRUE(mesh.colour(face));
    EXPECT_NEAR(mesh.colour(face)->r, 2.0 / 3, 1e-15);
    EXPECT_NEAR(mesh.colour(face)->g, 1.0 / 3, 1e-15);
  }
  EXPECT_EQ(mesh.skipped.warnings,
            Sentences{"left out: the different colours of the corners of 2 triangles: their mean "
                      "is drawn"});
}

TEST_F(ThreeMfTest, OpacityIsCounted) {
  const std::string group =
      "<m:colorgroup id=\"5\"><m:color color=\"#FF000080\"/><m:color color=\"#ff0000FF\"/>"
      "</m:colorgroup>";
  const Mesh mesh = read_3mf(model_of(
      group + object(tetrahedron({"pid='5' p1='0'", "pid='5' p1='1'", "", "pid='5' p1='0'"}))));
  EXPECT_EQ(text_of(colours_of(mesh)), "(1 0 0)(1 0 0)(none)(1 0 0)");
  EXPECT_EQ(mesh.skipped.transparent_faces, 2u);
}

TEST_F(ThreeMfTest, TexturesAreCounted) {
  const std::string group =
      "<m:texture2d id=\"6\" path=\"/3D/a.png\"/><m:texture2dgroup id=\"7\" texid=\"6\">"
      "<m:tex2coord u=\"0\" v=\"0\"/><m:tex2coord u=\"1\" v=\"0\"/></m:texture2dgroup>";
  const std::string of_texture = "pid='7' p1='0' p2='1' p3='1'";
  const Mesh mesh =
      read_3mf(model_of(group + object(tetrahedron({of_texture, kRed, of_texture, of_texture}))));
  EXPECT_EQ(text_of(colours_of(mesh)), "(none)(1 0 0)(none)(none)");
  EXPECT_EQ(mesh.skipped.textured_faces, 3u);
}

TEST_F(ThreeMfTest, EveryGroupHasAsManyPropertiesAsItsFileGivesIt) {
  const std::string groups =
      "<m:texture2dgroup id=\"5\" texid=\"4\"><m:tex2coord u=\"0\" v=\"0\"/></m:texture2dgroup>"
      "<m:compositematerials id=\"6\" matid=\"1\" matindices=\"0 1\"><m:composite values=\"1 1\"/>"
      "</m:compositematerials><m:multiproperties id=\"7\" pids=\"1\"><m:multi pindices=\"0\"/>"
      "</m:multiproperties><m:colorgroup id=\"8\"><m:color color=\"#000000\"/></m:colorgroup>";
  for (int group = 5; group <= 8; ++group) {
    const auto with = [&](int index) {
      return model_of(groups +
                      object(tetrahedron(), fmt::format("pid='{}' pindex='{}'", group, index)));
    };
    EXPECT_EQ(read_3mf(with(0)).faces(), 4u) << group;
    expect_refused(with(1), "not a mesh that can be read: 3MF: property index '1' out of range");
  }
}

TEST_F(ThreeMfTest, MixedMaterials) {
  const std::string group =
      "<m:compositematerials id=\"5\" matid=\"1\" matindices=\"0 1\">"
      "<m:composite values=\"0.25 0.75\"/><m:composite values=\"2 0\"/></m:compositematerials>";
  EXPECT_EQ(colours(group + object(tetrahedron({"pid='5' p1='0'", "pid='5' p1='1'", kBlue, ""}))),
            "(0.25 0 0.75)(1 0 0)(0 0 1)(none)");
}

TEST_F(ThreeMfTest, OfSeveralPropertiesTheFirstIsDrawn) {
  const std::string group =
      "<m:multiproperties id=\"5\" pids=\"1 2\"><m:multi pindices=\"1 0\"/></m:multiproperties>";
  const Mesh mesh =
      read_3mf(model_of(group + object(tetrahedron({"pid='5' p1='0'", kRed, kRed, kRed}))));
  EXPECT_EQ(text_of(colours_of(mesh)), "(0 0 1)(1 0 0)(1 0 0)(1 0 0)");
  EXPECT_EQ(mesh.skipped.warnings,
            Sentences{"left out: all but the first of the properties of 1 triangle "
                      "(multiproperties)"});
}

TEST_F(ThreeMfTest, PropertiesThatAreNotThere) {
  EXPECT_EQ(losses(object(tetrahedron({"pid='77' p1='0'", "", "", ""}))),
            Sentences{"left out: the colour of 1 triangle, which the file does not define"});
  expect_refused(model_of(object(tetrahedron({"pid='1' p1='2'", "", "", ""}))),
                 "not a mesh that can be read: 3MF: property index '2' out of range: expected less "
                 "than 2");
  expect_refused(model_of("<basematerials id=\"8\"><base displaycolor=\"red\"/></basematerials>" +
                          object(tetrahedron())),
                 "not a mesh that can be read: 3MF: colour 'red': expected #RRGGBB");
}

// ---- Places and units ------------------------------------------------------------------

TEST_F(ThreeMfTest, ComponentsArePlaced) {
  const std::string turned = "0 1 0 -1 0 0 0 0 1 0 7 0", larger = "2 0 0 0 2 0 0 0 2 5 0 0";
  const Mesh mesh = read_3mf(model_of(
      object(tetrahedron(), "name=\"A &amp; &lt;B&gt;\"", 2) +
          object(
              "<components><component objectid=\"2\" transform=\"" + larger + "\"/></components>",
              "", 3) +
          object("<components><component objectid=\"2\"/><component objectid=\"3\" transform=\"" +
                 turned + "\"/></components>"),
      "", "<item objectid=\"9\" transform=\"1 0 0 0 1 0 0 0 1 100 0 0\"/>"));
  EXPECT_EQ(mesh.faces(), 8u);
  EXPECT_EQ(mesh.skipped.warnings, Sentences{});
  ASSERT_EQ(mesh.objects.size(), 2u);
  EXPECT_EQ(mesh.objects[0].name, "A & <B>");
  EXPECT_EQ(box_of(mesh, 0), (Box{{100, 0, 0}, {101, 1, 1}}));
  // x from 5 to 7 and y from 0 to 2, turned by a right angle to y and -x, and moved.
  EXPECT_EQ(box_of(mesh, 1), (Box{{98, 12, 0}, {100, 14, 2}}));
}

TEST_F(ThreeMfTest, FacesStayOutwardUnderAMirror) {
  const Mesh plain = read_3mf(model_of(object(tetrahedron())));
  const Mesh mesh = read_3mf(model_of(
      object(tetrahedron()), "", "<item objectid=\"9\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/>"));
  EXPECT_TRUE(closed_and_consistently_oriented(plain));
  EXPECT_TRUE(closed_and_consistently_oriented(mesh));
  EXPECT_EQ(box_of(mesh), (Box{{-1, 0, 0}, {0, 1, 1}}));
}

TEST_F(ThreeMfTest, CoordinatesAreReadInDoublePrecision) {
  std::string far = tetrahedron();
  far.replace(far.find("x=\"1\""), 5, "x=\" 4000000.0625 \"");
  EXPECT_EQ(box_of(read_3mf(model_of(object(far)))).high.x, 4000000.0625);
}

TEST_F(ThreeMfTest, ObjectsInOtherParts) {
  const Mesh cube = read_mesh(DISPLAYFILE_SOURCE_DIR "/tests/meshes/3mf-production.3mf");
  EXPECT_EQ(cube.faces(), 12u);
  EXPECT_EQ(box_of(cube).low.x, 105.0);
  EXPECT_EQ(box_of(cube).high.x, 106.0);
  EXPECT_EQ(cube.skipped.warnings, Sentences{});

  const std::string other =
      model_of(object(tetrahedron({kBlue, kBlue, kBlue, kBlue}), "name='in'", 2), "", "");
  const std::string components =
      "<components><component p:path=\"/3D/Other.model\" objectid=\"2\"/></components>";
  for (const char* required : {"", "requiredextensions=\"p\"", "requiredextensions=\" p  m\""}) {
    const Mesh mesh =
        read_3mf(model_of(object(components) + object(tetrahedron(), "", 2), required,
                          kItem + std::string("<item p:path=\"/3D/Other.model\" objectid=\"2\" "
                                              "transform=\"1 0 0 0 1 0 0 0 1 9 0 0\"/>")),
                 {{"3D/Other.model", other}});
    ASSERT_EQ(mesh.objects.size(), 2u);
    EXPECT_EQ(mesh.objects[0].name, "in");
    EXPECT_EQ(box_of(mesh, 1).low.x, 9.0);
    EXPECT_EQ(mesh.colour(0), Colour(0, 0, 1));
    EXPECT_EQ(mesh.skipped.warnings, Sentences{"left out: 1 object that the build does not place"});
  }
  expect_refused(model_of(object(components)),
                 "not a mesh that can be read: 3MF: its model 3D/Other.model is not in it");
}

/// A part whose unit is another, in the unit of the first.
TEST_F(ThreeMfTest, Units) {
  const auto in_unit = [](std::string model, const std::string& unit) {
    return model.replace(model.find("millimeter"), 10, unit);
  };
  const std::string inner = model_of(object(tetrahedron(), "", 2), "", "");
  const std::string outer =
      model_of(object("<components><component p:path=\"/a.model\" objectid=\"2\" "
                      "transform=\"1 0 0 0 1 0 0 0 1 5 0 0\"/></components>"));
  const auto high = [&](const char* of_outer, const char* of_inner) {
    return box_of(read_3mf(in_unit(outer, of_outer), {{"a.model", in_unit(inner, of_inner)}}))
        .high.x;
  };
  EXPECT_EQ(high("millimeter", "millimeter"), 6.0);
  EXPECT_EQ(high("inch", "inch"), 6.0);
  EXPECT_DOUBLE_EQ(high("millimeter", "inch"), 5 + 25.4);
  EXPECT_DOUBLE_EQ(high("centimeter", "meter"), 5 + 100.0);
  EXPECT_DOUBLE_EQ(high("foot", "inch"), 5 + 1 / 12.0);
  EXPECT_DOUBLE_EQ(high("millimeter", "micron"), 5 + 0.001);
  EXPECT_EQ(read_3mf(in_unit(model_of(object(tetrahedron())), "inch")).skipped.warnings,
            Sentences{"left out: its unit, inch: --unit sets that of a sheet or scale"});
  expect_refused(in_unit(model_of(object(tetrahedron())), "ell"),
                 "not a mesh that can be read: 3MF: unit 'ell': unknown");
}

// ---- Parts left out, and refused -------------------------------------------------------

TEST_F(ThreeMfTest, OtherGeometryIsNamed) {
  EXPECT_EQ(losses(object(tetrahedron({"", "", "", ""}, "<b:beamlattice/>"))),
            Sentences{"left out: 1 beam lattice"});
  expect_refused(model_of(object("<mesh><vertices/><triangles/><b:beamlattice/></mesh>")),
                 "no faces: expected polygons (found 0 points and lines, and 0 faces of fewer than "
                 "3 different vertices); left out: 1 beam lattice");
}

TEST_F(ThreeMfTest, ExtensionsThatAreRequiredAndNotReadAreRefusedByName) {
  const auto requires_ = [&](const std::string& prefixes) {
    return model_of(object(tetrahedron()), "requiredextensions=\"" + prefixes + "\"");
  };
  for (const char* prefixes : {"b", "m b", "p  b", "b p"}) {
    expect_refused(requires_(prefixes),
                   "requires the 3MF extension "
                   "http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02");
  }
  expect_refused(requires_("unheard-of"), "requires the 3MF extension unheard-of");
  for (const char* prefixes : {"", "p", "m", " m p "}) {
    EXPECT_EQ(read_3mf(requires_(prefixes)).faces(), 4u) << prefixes;
  }
}

TEST_F(ThreeMfTest, PrefixesOfElementsAreAllowed) {
  std::string prefixed = model_of(object(tetrahedron({kRed, kBlue, "", ""})));
  for (const char* name : {"model", "object", "mesh", "vertex", "triangle", "item", "base "}) {
    for (const char* begin : {"<", "</"}) {
      for (std::size_t at = 0;
           (at = prefixed.find(begin + std::string(name), at)) != std::string::npos;) {
        prefixed.insert(at + std::string(begin).size(), "c:");
      }
    }
  }
  EXPECT_EQ(text_of(colours_of(read_3mf(prefixed))), "(1 0 0)(0 0 1)(none)(none)");
}

TEST_F(ThreeMfTest, WhatIsNoTagIsNoTag) {
  const std::string other = "<triangle v1='0' v2='1' v3='2'/>";
  for (const std::string& aside :
       {"<!-- " + other + " -->", "<![CDATA[" + other + "]]>", "<?x " + other + "?>"}) {
    std::string with = tetrahedron();
    with.insert(with.find("<triangles>"), "<metadata name=\"a &gt; b\">" + aside + "</metadata>");
    EXPECT_EQ(read_3mf(model_of(object(with))).faces(), 4u) << aside;
  }
}

TEST_F(ThreeMfTest, BadModelsAreRefused) {
  const std::string begin = "not a mesh that can be read: 3MF: ";
  const auto changed = [](const std::string& from, const std::string& to) {
    std::string model = model_of(object(tetrahedron()));
    return model.replace(model.find(from), from.size(), to);
  };
  expect_refused(changed("<item objectid=\"9\"/>", ""), begin + "its build has no items");
  expect_refused(changed("objectid=\"9\"", "objectid=\"8\""), begin + "object 8 is not in");
  expect_refused(changed("v3=\"3\"", "v3=\"4\""), begin +
                                                      "vertex index '4' out of range: expected "
                                                      "less than 4");
  expect_refused(changed("v3=\"3\"", "v3=\"-1\""), begin + "vertex index '-1'");
  expect_refused(changed("v3=\"3\"", ""), begin + "triangle without v3");
  expect_refused(changed("z=\"1\"", "z=\"nan\""), begin + "z 'nan': expected a finite number");
  expect_refused(changed("z=\"1\"", "z=\"1e39\""), begin + "z '1e39'");
  expect_refused(changed("z=\"1\"", ""), begin + "vertex without z");
  expect_refused(changed("<item ", "<item transform=\"1 0 0\" "),
                 begin + "transform '1 0 0': expe");
  const std::string whole = model_of(object(tetrahedron()));
  for (const char* last : {"</resources>", "<build>", "</model>"}) {
    expect_refused(whole.substr(0, whole.find(last)), begin);
  }
  expect_refused(model_of(object(tetrahedron()) + object(tetrahedron())), begin +
                                                                              "object '9' is "
                                                                              "defined twice");
  expect_refused(model_of(object("<components><component objectid=\"9\"/></components>")),
                 begin + "object 9 is a component of itself");
  std::string wide = "\xFF\xFE";
  for (const char c : whole) wide += {c, '\0'};
  expect_refused(wide, begin + "its model begins with");
  std::string cut = test::file_of_3mf(whole);
  expect_error([&] { read_mesh(file("cut.3mf", cut.substr(0, cut.size() / 2))); }, "cut.3mf: ");
  std::string damaged = cut;
  damaged[damaged.find("<vertices>") + 1] ^= 1;
  expect_error([&] { read_mesh(file("sum.3mf", damaged)); }, "3D/3dmodel.model in it is damaged");
}

/// In this process, where nothing else protects: each is a mesh or an exception.
TEST_F(ThreeMfTest, DamagedModelsAreMeshesOrErrors) {
  const SharedLibrary library(DISPLAYFILE_IMPORT_LIBRARY);
  const std::string model = model_of(
      object(tetrahedron({kRed, "pid='2' p1='0' p2='1'", "", kBlue}), "pid='1' pindex='0'", 2) +
      object("<components><component objectid='2' transform='1 0 0 0 1 0 0 0 1 5 0 0'/>"
             "</components>"));
  std::mt19937_64 random(3);
  int refused = 0, read = 0;
  for (int i = 0; i < 1000; ++i) {
    const std::string path =
        file("a.3mf", test::file_of_3mf(test::mutated(model, tetrahedron(), random)));
    try {
      ++(read_three_mf(path, library) ? read : refused);
    } catch (const std::exception&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
  EXPECT_GT(read, 0);
}

}  // namespace
}  // namespace displayfile
