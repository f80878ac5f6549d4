// Bad mesh files are refused with their name and place, and change nothing.

#include "displayfile/mesh/mesh.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/segments/display_file.h"
#include "tests/mesh_files.h"

namespace displayfile {
namespace {

using test::bytes;
using test::cube;
using test::cube_vertices;
using test::MeshTest;

// ---- Bad files -------------------------------------------------------------------------

/// Importing the file is refused with a message that starts with its path and contains `expected`;
/// the system is unchanged.
void expect_refused(const std::string& path, const std::string& expected) {
  GraphicsSystem system;
  std::ostringstream record;
  Recorder recorder(record);
  system.set_recorder(&recorder);
  try {
    import_mesh(path, system);
    ADD_FAILURE() << path << " was accepted";
  } catch (const Error& e) {
    EXPECT_TRUE(std::string(e.what()).starts_with(path)) << e.what();
    EXPECT_NE(std::string(e.what()).find(expected), std::string::npos)
        << e.what() << "\ndoes not say: " << expected;
  }
  EXPECT_TRUE(system.display_file().segments().empty());
  EXPECT_FALSE(system.explicit_settings().contains_view());
  EXPECT_EQ(record.str(), "");
}

TEST_F(MeshTest, IndexOutOfRange) {
  expect_refused(file("a.obj", cube_vertices(0) + "f 1 2 3\nf 1 2 99 3\n"),
                 ":10:7: vertex index 99 out of range: expected 1 to 8 or -8 to -1");
  expect_refused(file("b.obj", cube_vertices(0) + "f 1 2 0\n"), ":9:7: vertex index 0");
  expect_refused(file("c.obj", cube_vertices(0) + "f 1 2 -9\n"), ":9:7: vertex index -9");
  expect_refused(file("d.obj", cube_vertices(0) + "f 1//1 2//1 3//1\n"), "no normal was given");
  expect_refused(file("e.obj", cube_vertices(0) + "f 1 2 three\n"), ":9:7: 'three': expected");
  expect_refused(file("f.obj", cube_vertices(0) + "f 1 2 99999999999999999999\n"), ":9:7:");
  expect_refused(file("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
                 ":6:7: vertex index 3 out of range: expected 0 to 2");
  expect_refused(file("a.ply",
                      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                      "property float y\nproperty float z\nelement face 1\n"
                      "property list uchar int vertex_indices\nend_header\n"
                      "0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n"),
                 ":13:7: vertex index 7 out of range: expected 0 to 2");
}

TEST_F(MeshTest, CoordinatesThatAreNotFinite) {
  const std::string face = "v 1 0 0\nv 0 1 0\nf 1 2 3\n";
  expect_refused(file("nan.obj", "v 0 nan 0\n" + face), ":1:5: coordinate nan: expected a finite");
  expect_refused(file("inf.obj", "v 0 0 -inf\n" + face), ":1:7: coordinate -inf");
  expect_refused(file("large.obj", "v 1e39 0 0\n" + face), ":1:3: coordinate 1e39");
  expect_refused(file("word.obj", "v 0 0 x\n" + face), ":1:7: 'x': expected a coordinate");
  expect_refused(file("weight.obj", "v 0 0 1 0\n" + face), ":1:9: weight 0");
  const std::string off = "0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  expect_refused(file("nan.off", "OFF\n3 1 0\nnan " + off), ":3:1: coordinate nan");
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
      "property double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  expect_refused(file("inf.ply", ply + "inf " + off), ":10:1: coordinate inf");
  std::string binary = ply;
  binary.replace(binary.find("ascii"), 5, "binary_little_endian");
  for (const double c : {0., 0., 0., 1., std::nan(""), 0., 0., 1., 0.}) binary += bytes(c);
  binary += '\3' + bytes(0) + bytes(1) + bytes(2);
  expect_refused(file("nan.ply", binary), "vertex 1: coordinate nan: expected a finite");
  expect_refused(file("nan_text.stl", "solid\nfacet normal 0 0 1\nvertex 0 0 nan\n"),
                 ":3:12: coordinate nan");
  std::string stl(80, ' ');
  stl += bytes(std::uint32_t{1});
  for (int i = 0; i < 12; ++i) stl += bytes(i == 7 ? std::nanf("") : static_cast<float>(i * i % 7));
  expect_refused(file("nan.stl", stl + std::string(2, '\0')), "expected finite coordinates");
}

TEST_F(MeshTest, TruncatedFiles) {
  expect_refused(file("a.obj", cube_vertices(0) + "v 1 2"), ":9:6: end of line: expected");
  expect_refused(file("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n"), "end of file: expected vertex 2");
  expect_refused(file("a.ply", "ply\nformat ascii 1.0\nelement vertex 0\n"), "expected end_header");
  const std::string header =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\n"
      "property float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n";
  std::string data;
  for (const float c : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) data += bytes(c);
  data += '\3';
  for (const int i : {0, 1, 2}) data += bytes(i);
  EXPECT_EQ(read_mesh(file("whole.ply", header + data)).faces(), 1u);
  for (std::size_t n = 0; n < data.size(); ++n) {
    expect_refused(file("cut.ply", header + data.substr(0, n)), "announced");
  }
  const std::string facet = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n";
  expect_refused(file("b.stl", facet), "expected endsolid");
  expect_refused(file("c.stl", facet + "endloop\nendfacet\nendsolid\n"),
                 ":7:1: a facet of 2 vertices: expected 3");
  expect_refused(file("d.stl", facet + "facet normal 0 0 1\n"), ":6:1: facet: expected endfacet");
  std::string stl(80, ' ');
  stl += bytes(std::uint32_t{2}) + std::string(50, '\0');
  expect_refused(file("a.stl", stl), "expected 184 bytes for 2 facets, not 134");
}

TEST_F(MeshTest, AnStlFileThatIsNeitherTextNorBytes) {
  expect_refused(
      file("a.stl", "<html>not found</html>"),
      "neither STL text, which begins with 'solid', nor binary STL: expected 84 bytes for "
      "0 facets, not 22");
  std::string stl(80, ' ');
  stl += bytes(std::uint32_t{2}) + std::string(50, '\0');
  expect_refused(file("b.stl", stl), "nor binary STL: expected 184 bytes for 2 facets, not 134");
}

TEST_F(MeshTest, FilesThatAnnounceTooMuch) {
  expect_refused(file("vertices.off", "OFF\n1000000000 1 0\n0 0 0\n"), ":2:1: 1000000000 vertices");
  expect_refused(file("faces.off", "OFF\n1 1000000000 0\n0 0 0\n"), ":2:3: 1000000000 faces");
  expect_refused(
      file("keyword.ply", "ply\nformat ascii 1.0\nelement face 0\nproprety x\nend_header\n"),
      ":4:1:");
  expect_refused(file("no_corners.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n0\n"), ":6:1:");
  expect_refused(file("few_corners.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2\n"), ":6:8:");
  expect_refused(file("corners.off", "OFF\n1 1 0\n0 0 0\n1000000000 0 0 0\n"), ":4:1:");
  const std::string count = "4000000000 0 1 2\n", binary_count("\xFF\xFF\xFF\xFF\0\0\0\1", 8);
  for (const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    const std::string start = fmt::format("ply\nformat {} 1.0\n", format);
    expect_refused(file("vertices.ply", start + "element vertex 1000000000\nproperty float x\n"
                                                "end_header\n0 0 0\n"),
                   ":3:16: 1000000000 vertex announced");
    expect_refused(file("list.ply", start +
                                        "element face 1\n"
                                        "property list uint int vertex_indices\nend_header\n" +
                                        (format == "ascii" ? count : binary_count)),
                   "announced");
  }
  std::string stl(80, ' ');
  expect_refused(file("a.stl", stl + bytes(std::uint32_t{1000000000})), "1000000000 facets");
}

/// Root may read every file: for the length of the test it is another user.
TEST_F(MeshTest, FileThatMayNotBeReadIsRefusedWithTheReason) {
  const std::string path = file("a.obj", cube());
  std::filesystem::permissions(folder_, std::filesystem::perms::all);
  std::filesystem::permissions(path, std::filesystem::perms::none);
  ASSERT_EQ(::geteuid() == 0 ? ::seteuid(65534) : 0, 0);
  expect_refused(path, ": cannot be read: Permission denied");
  ASSERT_EQ(::getuid() == 0 ? ::seteuid(0) : 0, 0);
}

TEST_F(MeshTest, FilesThatAreNoMesh) {
  for (const char* extension : {"obj", "ply", "off", "stl", "3ds", "gltf", "dae", "fbx"}) {
    const std::string name = fmt::format("a.{}", extension);
    expect_refused(file(name, ""), "empty file");
    std::string garbage;
    for (unsigned i = 0, x = 1; i < 4096; ++i) {
      x = x * 1664525u + 1013904223u;
      garbage += static_cast<char>(x >> 24);
    }
    expect_refused(file(name, garbage), "");
    expect_refused((folder_ / ("missing-" + name)).string(), "no such file");
  }
  expect_refused(folder_.string(), "not a regular file");
  expect_refused(file("mesh.xyz", "1 2 3\n"), "xyz");
  expect_refused(file("points.obj", "v 0 0 0\nv 1 0 0\np 1 2\n"), "no faces");
  expect_refused(file("line.obj", "v 0 0 0\nv 1 0 0\nf 1 2 1\n"), "no faces");
}

TEST_F(MeshTest, NothingIsEnteredWhenAnotherFileIsBad) {
  GraphicsSystem system;
  const std::vector<std::string> paths = {file("a.obj", cube()), file("b.obj", "f 1 2 3\n")};
  EXPECT_THROW(import_meshes(paths, system), Error);
  EXPECT_TRUE(system.display_file().segments().empty());
  EXPECT_FALSE(system.explicit_settings().contains_view());
}

/// An import refused only when a segment is closed has set the view and the styles by then.
TEST_F(MeshTest, AStoppedImportChangesNothing) {
  const std::string path = file("cube.obj", cube());
  GraphicsSystem system, other;
  for (GraphicsSystem* g : {&system, &other}) {
    g->set_hidden_surfaces({.removal = true});
    g->set_hidden_surfaces({.method = HiddenMethod::bsp});
  }
  WorkBudget budget;
  budget.stop();
  {
    const BudgetInForce in_force(budget);
    EXPECT_THROW(import_mesh(path, system), LimitReached);
  }
  EXPECT_TRUE(system.display_file().segments().empty());
  EXPECT_FALSE(system.explicit_settings().contains_view());
  EXPECT_FALSE(system.looks().attributes.light);
  import_mesh(path, system);
  import_mesh(path, other);
  EXPECT_EQ(dump(system.display_file()), dump(other.display_file()));
}

}  // namespace
}  // namespace displayfile
