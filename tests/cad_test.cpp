// STEP and IGES by OpenCASCADE: small parts whose sizes, colours and places are known
// (tests/meshes).

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "clip/surfaces.h"
#include "displayfile/graphics_system.h"
#include "displayfile/mesh/mesh.h"
#include "tests/error_of.h"
#include "tests/fuzz/mutated_bytes.h"
#include "tests/mesh_files.h"
#include "tests/sides_of_kinds.h"

namespace displayfile {
namespace {

using Sentences = std::vector<std::string>;

class CadTest : public test::MeshFiles {
 protected:
  static std::string path(const std::string& name) {
    return DISPLAYFILE_SOURCE_DIR "/tests/meshes/" + name;
  }
  static std::string text(const std::string& name) { return test::content(path(name)); }

  /// The message with which a file is refused, without its path.
  static std::string refusal(const std::string& path, const ImportLimits& limits = {}) {
    const std::string message = test::error_of([&] { read_mesh(path, false, limits); });
    EXPECT_TRUE(message.starts_with(path + ": ")) << message;
    return message.substr(std::min(message.size(), path.size() + 2));
  }
  std::string refusal_of(const std::string& name, const std::string& text) const {
    return refusal(file(name, text));
  }
};

/// With the first `from` replaced, which must be there.
std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return at == text.npos ? text : text.replace(at, from.size(), to);
}

double volume(const Mesh& mesh) {
  double sum = 0.0;
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    const auto corners = mesh.face(f);
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
      sum += glm::dot(mesh.vertices[corners[0]],
                      glm::cross(mesh.vertices[corners[k]], mesh.vertices[corners[k + 1]]));
    }
  }
  return sum / 6.0;
}

/// Sides that are not of two faces, one in each direction.
std::size_t open_sides(const Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    const auto corners = mesh.face(f);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const std::uint32_t from = corners[k], to = corners[(k + 1) % corners.size()];
      ++uses[{from, to}];
      --uses[{to, from}];
    }
  }
  return static_cast<std::size_t>(
      std::ranges::count_if(uses, [](const auto& use) { return use.second != 0; }));
}

std::set<double> coordinates(const Mesh& mesh, int axis) {
  std::set<double> values;
  for (const Point3& p : mesh.vertices) values.insert(p[axis]);
  return values;
}

test::Sides sides_of(const Mesh& mesh, const char* lines) {
  GraphicsSystem g;
  g.set_perspective({30.0, 20.0, 50.0});
  g.set_view_depth(-40.0, 40.0);
  g.set_hidden_surfaces({.lines = line_selection(lines)});
  enter_mesh(mesh, g, 1);
  return test::sides_in_view(*g.retained(), Eye::at({30.0, 20.0, 50.0}));
}

// ---- Shapes ----------------------------------------------------------------------------

TEST_F(CadTest, TheCornersOfABoxAreThoseOfTheFile) {
  const Mesh box = read_mesh(path("box.step"));
  EXPECT_EQ(box.faces(), 6u);
  EXPECT_EQ(box.vertices.size(), 8u);
  EXPECT_EQ(coordinates(box, 0), (std::set{0.1, 1.1}));
  EXPECT_EQ(coordinates(box, 1), (std::set{0.2, 2.7}));
  EXPECT_EQ(coordinates(box, 2), (std::set{0.3, 3.3}));
  EXPECT_EQ(open_sides(box), 0u);
  EXPECT_TRUE(closed_and_consistently_oriented(box));
  EXPECT_EQ(box.skipped.warnings, Sentences{});
  EXPECT_EQ(left_out(box.skipped), Sentences{});
  EXPECT_EQ(test::count(sides_of(box, "crease"), test::kCrease), 12u);
}

TEST_F(CadTest, CurvedSurfacesAreClosedAndWithinTheDeflection) {
  const double pi = std::numbers::pi;
  for (const double deflection : {0.0, 0.002, 0.05}) {
    const Mesh sphere = read_mesh(path("sphere.step"), false, {.deflection = deflection});
    EXPECT_EQ(open_sides(sphere), 0u);
    EXPECT_TRUE(closed_and_consistently_oriented(sphere));
    const double most = deflection > 0.0 ? deflection : std::sqrt(3.0) * 10.0 / 2500.0;
    const double whole = 4.0 / 3.0 * pi * 125.0;
    EXPECT_LT(volume(sphere), whole);
    EXPECT_GT(volume(sphere), whole * std::pow(1.0 - most / 5.0, 3.0)) << deflection;
    for (const Point3& p : sphere.vertices) EXPECT_NEAR(glm::length(p), 5.0, 1e-9);
    for (std::size_t f = 0; f < sphere.faces(); ++f) {
      const auto corners = sphere.face(f);
      const Point3 a = sphere.vertices[corners[0]], b = sphere.vertices[corners[1]],
                   c = sphere.vertices[corners[2]];
      for (const Point3& p : {(a + b) / 2.0, (b + c) / 2.0, (c + a) / 2.0, (a + b + c) / 3.0}) {
        ASSERT_GT(glm::length(p), 5.0 - most) << deflection;
      }
    }
    EXPECT_EQ(sides_of(sphere, "boundary,crease").size(), 0u) << deflection;
  }
  const Mesh cylinder = read_mesh(path("cylinder.step"));
  EXPECT_EQ(open_sides(cylinder), 0u);
  EXPECT_NEAR(volume(cylinder), pi * 25.0 * 12.0, pi * 25.0 * 12.0 * 2e-3);
}

/// A plane face with a hole is no polygon with a filled hole.
TEST_F(CadTest, HolesStayOpen) {
  const Mesh drilled = read_mesh(path("drilled.step"));
  EXPECT_EQ(open_sides(drilled), 0u);
  EXPECT_TRUE(closed_and_consistently_oriented(drilled));
  EXPECT_NEAR(volume(drilled), 400.0 - 16.0 * std::numbers::pi, 0.2);
}

TEST_F(CadTest, AFinerDeflectionHasMoreFacets) {
  const auto faces = [&](double deflection) {
    return read_mesh(path("sphere.step"), false, {.deflection = deflection}).faces();
  };
  EXPECT_LT(faces(0.1), faces(0.01));
  EXPECT_LT(faces(0.01), faces(0.001));
}

/// The seam of a cylinder and the sides of its facets are none, whatever the deflection.
TEST_F(CadTest, CreasesAreTheEdgesThatAreNotSmooth) {
  for (const double deflection : {0.0, 0.01, 1.0, 100.0}) {
    const Mesh cylinder = read_mesh(path("cylinder.step"), false, {.deflection = deflection});
    for (const auto& [ends, kinds] : sides_of(cylinder, "crease")) {
      EXPECT_EQ(ends.first.z, ends.second.z) << deflection;
    }
    EXPECT_GE(sides_of(cylinder, "crease").size(), 36u) << deflection;
    // A box with one upright edge rounded: its two tangent edges, from bottom to top, are none.
    const Mesh rounded = read_mesh(path("rounded.step"), false, {.deflection = deflection});
    std::size_t upright = 0;
    for (const auto& [ends, kinds] : sides_of(rounded, "crease")) {
      upright += ends.first.z != ends.second.z ? 1 : 0;
    }
    EXPECT_EQ(upright, 3u) << deflection;
  }
}

TEST_F(CadTest, NormalsAreThoseOfTheSurface) {
  const Mesh sphere = read_mesh(path("sphere.step"), true);
  std::size_t known = 0;
  for (std::size_t c = 0; c < sphere.corners.size(); ++c) {
    const Point3 normal = sphere.normal(c);
    if (normal == Point3(0.0)) continue;
    ++known;
    const Point3 outward = glm::normalize(sphere.vertices[sphere.corners[c]]);
    ASSERT_NEAR(glm::dot(glm::normalize(normal), outward), 1.0, 1e-9) << c;
  }
  EXPECT_GT(known, sphere.corners.size() * 9 / 10);  // the poles have none
  EXPECT_TRUE(read_mesh(path("sphere.step")).corner_normals.empty());
  const Mesh box = read_mesh(path("box.step"), true);
  for (std::size_t f = 0; f < box.faces(); ++f) {
    const auto corners = box.face(f);
    const Point3 a = box.vertices[corners[0]], b = box.vertices[corners[1]],
                 c = box.vertices[corners[2]];
    const Point3 plane = glm::normalize(glm::cross(b - a, c - a));
    for (std::size_t k = 0; k < corners.size(); ++k) {
      EXPECT_NEAR(glm::dot(glm::normalize(box.normal(box.first_corner[f] + k)), plane), 1.0, 1e-12);
    }
  }
}

// ---- Assemblies ------------------------------------------------------------------------

TEST_F(CadTest, InstancesOfAPartArePlacedNamedAndColoured) {
  const Mesh mesh = read_mesh(path("assembly.step"));
  ASSERT_EQ(mesh.objects.size(), 3u);
  EXPECT_EQ(mesh.objects[0].name, "plate");
  EXPECT_EQ(mesh.objects[1].name, "pin");
  EXPECT_EQ(mesh.objects[2].name, "pin");
  EXPECT_EQ(mesh.objects[1].faces, mesh.objects[2].faces);
  EXPECT_TRUE(closed_and_consistently_oriented(mesh));
  std::map<std::string, int> colours[3];
  for (std::size_t o = 0; o < 3; ++o) {
    const Mesh::Object& object = mesh.objects[o];
    for (std::size_t f = object.first_face; f < object.first_face + object.faces; ++f) {
      const auto colour = mesh.colour(f);
      ASSERT_TRUE(colour);
      ++colours[o][fmt::format("{} {} {}", colour->r, colour->g, colour->b)];
    }
  }
  EXPECT_EQ(colours[0], (std::map<std::string, int>{{"0.2 0.4 0.6", 5}, {"1 1 0", 1}}));
  ASSERT_EQ(colours[1].size(), 1u);
  EXPECT_EQ(colours[1].begin()->first, "0.8 0.1 0.1");
  ASSERT_EQ(colours[2].size(), 1u);
  EXPECT_EQ(colours[2].begin()->first, "0 1 0");  // of the instance
  // The first pin stands on (0.1, 0.2, 0.3), the other lies along x from (1, 1.5, 1).
  const auto extent = [&](std::size_t o, int axis) {
    double least = 1e9, most = -1e9;
    const Mesh::Object& object = mesh.objects[o];
    for (std::size_t f = object.first_face; f < object.first_face + object.faces; ++f) {
      for (const std::uint32_t v : mesh.face(f)) {
        least = std::min(least, mesh.vertices[v][axis]);
        most = std::max(most, mesh.vertices[v][axis]);
      }
    }
    return std::pair(least, most);
  };
  EXPECT_EQ(extent(1, 2), std::pair(0.3, 1.3));
  EXPECT_NEAR(extent(1, 0).first, 0.1 - 0.25, 1e-3);
  EXPECT_NEAR(extent(2, 0).first, 1.0, 1e-12);
  EXPECT_NEAR(extent(2, 0).second, 2.0, 1e-12);
}

TEST_F(CadTest, HiddenPartsAreLeftOutByCount) {
  const std::string hidden =
      replaced(text("assembly.step"), "STYLED_ITEM('color',(#508),#390);",
               "STYLED_ITEM('color',(#508),#390);\n#9999 = INVISIBILITY((#507));");
  const Mesh mesh = read_mesh(file("hidden.step", hidden));
  ASSERT_EQ(mesh.objects.size(), 1u);
  EXPECT_EQ(mesh.objects[0].name, "plate");
  EXPECT_EQ(mesh.skipped.warnings,
            Sentences{"left out: 2 instances of parts that are hidden in the file"});
}

TEST_F(CadTest, LengthsStayInTheUnitOfTheFile) {
  const Mesh inches = read_mesh(path("inches.step"));
  EXPECT_EQ(coordinates(inches, 0), (std::set{0.1, 1.0}));
  EXPECT_EQ(coordinates(inches, 1), (std::set{0.0, 1.0}));
  EXPECT_EQ(inches.skipped.warnings,
            Sentences{"left out: its unit, inch: --unit sets that of a sheet or scale"});
  const std::string metres =
      replaced(text("box.step"), "SI_UNIT(.MILLI.,.METRE.)", "SI_UNIT($,.METRE.)");
  const Mesh box = read_mesh(file("metres.step", metres));
  EXPECT_EQ(coordinates(box, 1), (std::set{0.2, 2.7}));
  EXPECT_EQ(box.skipped.warnings,
            Sentences{"left out: its unit, metre: --unit sets that of a sheet or scale"});
}

// ---- IGES ------------------------------------------------------------------------------

/// Its three surfaces have no edge in common in the file.
TEST_F(CadTest, SurfacesOfIgesAreJoined) {
  const Mesh cylinder = read_mesh(path("cylinder.igs"));
  EXPECT_EQ(open_sides(cylinder), 0u);
  EXPECT_TRUE(closed_and_consistently_oriented(cylinder));
  EXPECT_NEAR(volume(cylinder), std::numbers::pi * 300.0, 2.0);
  ASSERT_EQ(cylinder.objects.size(), 1u);
  EXPECT_EQ(cylinder.objects[0].name, "cylinder");
  for (const auto& [ends, kinds] : sides_of(cylinder, "crease")) {
    EXPECT_NEAR(ends.first.z, ends.second.z, 1e-6);
  }
  const Mesh inches =
      read_mesh(file("inches.igs", replaced(text("cylinder.igs"), ",1.,2,2HMM,", ",1.,1,2HIN,")));
  EXPECT_NEAR(volume(inches), std::numbers::pi * 300.0, 2.0);
  EXPECT_EQ(inches.skipped.warnings,
            Sentences{"left out: its unit, inch: --unit sets that of a sheet or scale"});
}

// ---- Bad files -------------------------------------------------------------------------

TEST_F(CadTest, BadFilesAreRefusedByName) {
  const std::string box = text("box.step");
  EXPECT_EQ(refusal_of("a.step", box.substr(0, box.size() / 2)),
            "not a STEP file that can be read: it ends too early: expected END-ISO-10303-21;");
  EXPECT_EQ(refusal_of("b.step", "hello\nEND-ISO-10303-21;\n"),
            "not a STEP file that can be read: line 2: Incorrect syntax: unexpected TYPE, "
            "expecting STEP");
  EXPECT_EQ(refusal_of("c.step", replaced(box, "(0.1,0.2,0.3)", "(0.1,0.2,")),
            "not a STEP file that can be read: incorrect syntax at 2 places");
  EXPECT_EQ(refusal_of("d.step",
                       "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nENDSEC;\nDATA;\n"
                       "#1=CARTESIAN_POINT('',(0.,0.,0.));\nENDSEC;\nEND-ISO-10303-21;\n"),
            "not a STEP file that can be read: it has no shapes");
  EXPECT_EQ(refusal_of("e.igs", text("cylinder.igs").substr(0, 2000)),
            "not an IGES file that can be read: it ends too early: expected a last line of the "
            "terminate section, T in column 73");
  EXPECT_EQ(refusal_of("f.step", ""), "empty file: expected a mesh");
  EXPECT_EQ(refusal(path("box.step"), {.deflection = -1.0}),
            "deflection -1: expected a length, 0 or more");
  EXPECT_EQ(refusal(path("sphere.step"), {.deflection = 1e-8}),
            "deflection 1e-08: expected at least 2.2e-07, the library's precision");
}

/// A face that cannot be made is a warning by name, not a hole.
TEST_F(CadTest, EntitiesWithErrorsAreCounted) {
  const Mesh open = read_mesh(file(
      "a.step", replaced(text("cylinder.step"), "CYLINDRICAL_SURFACE", "CYLINDRICAL_SURFICE")));
  ASSERT_EQ(open.skipped.warnings.size(), 1u);
  EXPECT_TRUE(open.skipped.warnings[0].starts_with("left out: ")) << open.skipped.warnings[0];
  EXPECT_NE(open.skipped.warnings[0].find("entities of STEP with errors, the first #"),
            std::string::npos)
      << open.skipped.warnings[0];
}

TEST_F(CadTest, LimitsHold) {
  EXPECT_EQ(refusal(path("box.step"), {.seconds = 1e-6}),
            "the import library (OpenCASCADE) reached the limit of 1e-06 seconds: "
            "--import-seconds (ImportLimits::seconds) sets another");
  // A finer deflection than there is memory for.
  const std::string hungry =
      refusal(path("sphere.step"), {.memory = std::size_t{64} << 20, .deflection = 1e-5});
  EXPECT_NE(hungry.find("--import-memory"), hungry.npos) << hungry;
}

/// Each is read, or refused with its name: whatever the library does to its process.
TEST_F(CadTest, MutantsAreReadOrRefused) {
  const std::vector<std::pair<std::string, std::string>> models{{".step", text("cylinder.step")},
                                                                {".step", text("sphere.step")},
                                                                {".igs", text("cylinder.igs")}};
  constexpr int kMutants = 200;
  std::size_t were_read = 0;
  for (int i = 0; i < kMutants; ++i) {
    std::mt19937_64 random(static_cast<std::uint64_t>(i));
    const auto& [extension, bytes] = models[static_cast<std::size_t>(i) % models.size()];
    const std::string mutant =
        file("m" + extension, test::mutated(bytes, models[0].second, random));
    try {
      were_read += read_mesh(mutant, false, {.seconds = 20.0, .deflection = 0.1}).faces() > 0;
    } catch (const Error& e) {
      const std::string message = e.what();
      EXPECT_TRUE(message.starts_with(mutant + ": ")) << i << ": " << message;
      EXPECT_EQ(message.find('\n'), message.npos) << i << ": " << message;
      EXPECT_EQ(message.find("invalid reply"), message.npos) << i << ": " << message;
    }
  }
  EXPECT_GT(were_read, 10u);
}

}  // namespace
}  // namespace displayfile
