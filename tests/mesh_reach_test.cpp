// The precision of the numbers in a mesh file, and the reach of touching that follows from it
// (displayfile/mesh/written_digits.h, entered_reach of displayfile/mesh/mesh.h).

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <span>
#include <sstream>
#include <string>

#include "clip/surfaces.h"
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/mesh/written_digits.h"
#include "displayfile/user_routines/system_inside.h"
#include "tests/mesh_files.h"

namespace displayfile {
namespace {

using test::bytes;

double rounding_of(std::initializer_list<const char*> numbers) {
  WrittenDigits digits;
  for (const char* number : numbers) digits.see(number);
  return digits.rounding();
}

TEST(WrittenDigits, OfFewerThanSixAreMeantAsTheyStand) {
  EXPECT_EQ(rounding_of({}), 0.0);
  EXPECT_EQ(rounding_of({"12345", "-1.2345", "0.00012345", "1.2345e-7", "0.0000000"}), 0.0);
}

TEST(WrittenDigits, AreRoundedByHalfTheLastOfTheLongest) {
  EXPECT_EQ(rounding_of({"1.23456", "0.1"}), 0.5e-5);
  EXPECT_EQ(rounding_of({"-1.23456"}), 0.5e-5);
  EXPECT_EQ(rounding_of({"1.50000"}), 0.5e-5) << "zeros behind count";
  EXPECT_EQ(rounding_of({"0.00150000"}), 0.5e-8) << "and those in front do not";
  EXPECT_EQ(rounding_of({"123456"}), 0.5);
  EXPECT_EQ(rounding_of({"1.23456", "1.234567"}), 0.5e-6) << "the longer";
  EXPECT_EQ(rounding_of({"0.123456", "123.456", "1.23456"}), 0.5e-3) << "the coarsest of these";
  EXPECT_EQ(rounding_of({"1.23456e+02", "1.00000E+00"}), 0.5e-3);
  EXPECT_EQ(rounding_of({"1.234567e-3"}), 0.5e-9);
}

class MeshReach : public test::MeshFiles {
 protected:
  double rounding(const std::string& name, const std::string& text) const {
    return read(name, text).rounding;
  }
  Mesh stl(float largest) const {
    std::string data(80, ' ');
    data += bytes(std::uint32_t{1});
    for (const float c : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, largest, 0.f, 0.f, 0.f, 1.f, 0.1f}) {
      data += bytes(c);
    }
    return read("a.stl", data + "xx");
  }
};

TEST_F(MeshReach, IsOfSinglePrecisionInBinaryFiles) {
  EXPECT_EQ(stl(1024.f).rounding, 1024 * 0x1p-24);
  EXPECT_EQ(entered_reach(stl(-1024.f)), 8 * 1024 * 0x1p-24);
}

TEST_F(MeshReach, IsByThePropertiesOfPly) {
  const auto ply = [&]<class Number>(const char* type, Number largest) {
    const char* const order =
        std::endian::native == std::endian::little ? "binary_little_endian" : "binary_big_endian";
    std::string data = fmt::format(
        "ply\nformat {0} 1.0\nelement vertex 3\nproperty {1} x\nproperty {1} y\nproperty {1} z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n",
        order, type);
    for (const Number c : {Number{0}, Number{0}, Number{0}, largest, Number{0}, Number{0},
                           Number{0}, Number{1}, Number{0}}) {
      data += bytes(c);
    }
    data += bytes(std::uint8_t{3});
    for (const std::int32_t i : {0, 1, 2}) data += bytes(i);
    return rounding("a.ply", data);
  };
  EXPECT_EQ(ply("float", 8.f), 8 * 0x1p-24);
  EXPECT_EQ(ply("double", 8.0), 0.0);
  EXPECT_EQ(ply("int", std::int32_t{8}), 0.0);
}

TEST_F(MeshReach, IsByTheDecimalsOfTexts) {
  const auto obj = [&](const char* x) {
    return rounding("a.obj", fmt::format("v 0 0 0\nv {} 0 0\nv 0 1 0\nf 1 2 3\n", x));
  };
  EXPECT_EQ(obj("10.5"), 0.0);
  EXPECT_EQ(obj("10.5000"), 0.5e-4);
  EXPECT_EQ(obj("0.00123456"), 0.5e-8);
  EXPECT_EQ(rounding("a.off", "OFF\n3 1 0\n0 0 0\n10.5000 0 0\n0 1 0\n3 0 1 2\n"), 0.5e-4);
  EXPECT_EQ(rounding("a.stl",
                     "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 10.5000 0 0\n"
                     "vertex 0 1 0\nendloop\nendfacet\nendsolid\n"),
            0.5e-4);
  EXPECT_EQ(rounding("b.ply",
                     "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                     "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                     "end_header\n0 0 0\n10.5000 0 0\n0 1 0\n3 0 1 2\n"),
            0.5e-4);
}

/// An explicit setting is kept; otherwise each mesh has its own, and the recorder writes it.
TEST_F(MeshReach, IsThatOfItsSegments) {
  const Mesh mesh = stl(1024.f);
  const std::string before = fmt::format("set-touching {}\n", entered_reach(mesh)),
                    after = "set-touching auto\n";
  const auto recorded = [&](const std::function<void(GraphicsSystem&)>& set) {
    std::ostringstream program;
    Recorder recorder(program);
    GraphicsSystem g;
    set(g);
    const Touching touching = g.hidden_surfaces().touching;
    g.set_recorder(&recorder);
    enter_meshes(std::span(&mesh, 1), g);
    EXPECT_EQ(g.hidden_surfaces().touching, touching);
    return program.str();
  };
  const std::string as_it_is = recorded([](GraphicsSystem&) {});
  const std::size_t opened = as_it_is.find("open-segment"), closed = as_it_is.find("close-segment");
  EXPECT_LT(as_it_is.find(before), opened);
  EXPECT_GT(as_it_is.find(after), closed);
  EXPECT_NE(as_it_is.find(after), std::string::npos);
  EXPECT_EQ(
      recorded([](GraphicsSystem& g) { SystemInside::replace_touching(g, touching("auto")); }),
      as_it_is);
  for (const char* word : {"off", "0.5"}) {
    SCOPED_TRACE(word);
    EXPECT_EQ(recorded([&](GraphicsSystem& g) {
                g.set_hidden_surfaces({.touching = touching(word)});
              }).find("set-touching"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace displayfile
