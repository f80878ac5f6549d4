// A reply of the import program is a valid mesh, or it is refused: nothing in it is trusted.

#include "displayfile/mesh/mesh_reply.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <glm/common.hpp>
#include <limits>
#include <random>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "clip/point.h"
#include "displayfile/mesh/up_axis.h"

namespace displayfile {
namespace {

using Bytes = std::vector<std::byte>;

constexpr std::size_t kPlenty = std::size_t{1} << 24;

/// Fewer bytes came than were requested.
struct EndOfBytes {};

Mesh two_faces() {
  Mesh mesh;
  mesh.upright = upright("-z");
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1e30, -0.0, 5e-324}};
  mesh.normals = {{0, 0, 1}, {0, 0, 0}};
  mesh.corners = {0, 1, 2, 3, 2, 1, 4};
  mesh.first_corner = {0, 4, 7};
  mesh.corner_normals = {0, 0, 0, 1, Mesh::kNoNormal, 1, 1};
  mesh.materials = {{Colour(0.25, 0.5, 1), true, false}, {std::nullopt, false, true}};
  mesh.face_materials = {1, Mesh::kNoMaterial};
  mesh.objects = {{"roof", 0, 1}, {std::string("a\0b", 3), 1, 1}};
  mesh.skipped = {3, 4, 1, 2, {"", "it lost something"}};
  return mesh;
}

Bytes sent(const Mesh& mesh) {
  Bytes bytes;
  send_mesh(mesh, [&](std::span<const std::byte> part) {
    bytes.insert(bytes.end(), part.begin(), part.end());
  });
  return bytes;
}

std::variant<Mesh, std::string> received(std::span<const std::byte> bytes,
                                         std::size_t most = kPlenty) {
  const ByteSource source = [&](std::span<std::byte> to) {
    if (to.size() > bytes.size()) throw EndOfBytes{};
    std::copy_n(bytes.begin(), to.size(), to.begin());
    bytes = bytes.subspan(to.size());
  };
  return receive_reply(source, most);
}

/// Checks the invariants of a mesh as mesh.h states them, independently.
void expect_sound(const Mesh& mesh) {
  ASSERT_FALSE(mesh.first_corner.empty());
  EXPECT_EQ(mesh.first_corner.front(), 0u);
  EXPECT_EQ(mesh.first_corner.back(), mesh.corners.size());
  for (std::size_t i = 0; i < mesh.faces(); ++i) {
    ASSERT_LE(mesh.first_corner[i] + 3, mesh.first_corner[i + 1]);
  }
  for (const std::uint32_t corner : mesh.corners) EXPECT_LT(corner, mesh.vertices.size());
  for (const Point3& p : mesh.vertices) EXPECT_TRUE(std::isfinite(p.x + p.y + p.z));
  for (const Point3& p : mesh.normals) EXPECT_TRUE(std::isfinite(p.x + p.y + p.z));
  EXPECT_TRUE(mesh.corner_normals.empty() || mesh.corner_normals.size() == mesh.corners.size());
  for (const std::uint32_t n : mesh.corner_normals) {
    EXPECT_TRUE(n == Mesh::kNoNormal || n < mesh.normals.size());
  }
  EXPECT_TRUE(mesh.face_materials.empty() || mesh.face_materials.size() == mesh.faces());
  for (std::size_t i = 0; i < mesh.faces(); ++i) {
    const auto colour = mesh.colour(i);
    EXPECT_TRUE(!colour || (*colour == glm::clamp(*colour, 0.0, 1.0)));
  }
  std::size_t faces = 0;
  for (const Mesh::Object& object : mesh.objects) {
    EXPECT_EQ(object.first_face, faces);
    EXPECT_GT(object.faces, 0u);
    faces += object.faces;
  }
  EXPECT_EQ(faces, mesh.faces());
}

TEST(MeshReply, AMeshComesAsItWasSent) {
  const Mesh mesh = two_faces();
  const Mesh got = std::get<Mesh>(received(sent(mesh)));
  EXPECT_EQ(got.upright, mesh.upright);
  EXPECT_EQ(got.vertices, mesh.vertices);
  EXPECT_TRUE(std::signbit(got.vertices[4].y));
  EXPECT_EQ(got.normals, mesh.normals);
  EXPECT_EQ(got.corners, mesh.corners);
  EXPECT_EQ(got.first_corner, mesh.first_corner);
  EXPECT_EQ(got.corner_normals, mesh.corner_normals);
  EXPECT_EQ(got.materials, mesh.materials);
  EXPECT_EQ(got.face_materials, mesh.face_materials);
  ASSERT_EQ(got.objects.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(got.objects[i].name, mesh.objects[i].name);
  EXPECT_EQ(got.skipped.warnings, mesh.skipped.warnings);
  EXPECT_EQ(got.skipped.points_and_lines, 3u);
  EXPECT_EQ(got.skipped.degenerate_faces, 4u);
  EXPECT_EQ(got.skipped.textured_faces, 1u);
  EXPECT_EQ(got.skipped.transparent_faces, 2u);
}

TEST(MeshReply, ARefusalComesAsItWasSent) {
  Bytes bytes;
  send_refusal("a.x: no", [&](std::span<const std::byte> part) {
    bytes.insert(bytes.end(), part.begin(), part.end());
  });
  EXPECT_EQ(std::get<std::string>(received(bytes)), "a.x: no");
}

TEST(MeshReply, WhatIsCutOffIsNoMesh) {
  const Bytes bytes = sent(two_faces());
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    EXPECT_THROW(received(std::span(bytes).first(n)), EndOfBytes) << n;
  }
}

TEST(MeshReply, WhatIsOutOfRangeIsRefused) {
  const auto refused = [](auto&& change) {
    Mesh mesh = two_faces();
    change(mesh);
    EXPECT_THROW(received(sent(mesh)), BadReply);
  };
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  refused([](Mesh& m) { m.vertices[4].x = kNan; });
  refused([](Mesh& m) { m.vertices[0].z = -kInfinity; });
  refused([](Mesh& m) { m.vertices[0].y = 2 * kCoordinateLimit; });
  refused([](Mesh& m) { m.normals[1].y = kInfinity; });
  refused([](Mesh& m) { m.corners[6] = 5; });
  refused([](Mesh& m) { m.corners[6] = 0xFFFFFFFFu; });
  refused([](Mesh& m) { m.corner_normals[0] = 2; });
  refused([](Mesh& m) { m.corner_normals.pop_back(); });
  refused([](Mesh& m) { m.face_materials[0] = 2; });
  refused([](Mesh& m) { m.face_materials.pop_back(); });
  refused([](Mesh& m) { m.first_corner[0] = 1; });
  refused([](Mesh& m) { m.first_corner[1] = 5; });
  refused([](Mesh& m) { m.first_corner[1] = 2; });
  refused([](Mesh& m) { m.first_corner[1] = 8; });
  refused([](Mesh& m) { m.first_corner[1] = ~std::size_t{0}; });
  refused([](Mesh& m) { m.first_corner[2] = 6; });
  refused([](Mesh& m) { m.corners[5] = 2; });  // twice the same position
  refused([](Mesh& m) { m.materials[0].colour->g = 1.5; });
  refused([](Mesh& m) { m.materials[0].colour->b = kNan; });
  refused([](Mesh& m) { m.objects[0].faces = 2; });
  refused([](Mesh& m) { m.objects[0].faces = 0; });
  refused([](Mesh& m) { m.objects[1].faces = ~std::size_t{0}; });
  refused([](Mesh& m) { m.objects.pop_back(); });
  refused([](Mesh& m) { m.skipped.textured_faces = 3; });
  refused([](Mesh& m) { m.first_corner = {0}, m.corners = {}, m.objects = {}; });
}

/// Each word of the reply in turn is changed: the result is a sound mesh or an error, and no memory
/// is allocated for data that do not come.
TEST(MeshReply, NoWordIsBelieved) {
  const Bytes bytes = sent(two_faces());
  const std::uint64_t telling[] = {0,
                                   1,
                                   2,
                                   7,
                                   0xFFFFFFFFu,
                                   std::uint64_t{1} << 32,
                                   std::uint64_t{1} << 60,
                                   std::uint64_t{1} << 63,
                                   ~std::uint64_t{0},
                                   0x7FF0000000000000u};
  for (std::size_t at = 0; at + 8 <= bytes.size(); at += 4) {
    for (const std::uint64_t word : telling) {
      Bytes changed = bytes;
      std::memcpy(changed.data() + at, &word, sizeof word);
      try {
        const auto reply = received(changed);
        if (const auto* mesh = std::get_if<Mesh>(&reply)) expect_sound(*mesh);
      } catch (const BadReply&) {
      } catch (const EndOfBytes&) {
      }
    }
  }
  std::mt19937_64 random(7);
  for (int i = 0; i < 20000; ++i) {
    Bytes changed = bytes;
    for (int k = 0; k < 3; ++k) changed[random() % changed.size()] = std::byte(random() & 0xFF);
    try {
      const auto reply = received(changed);
      if (const auto* mesh = std::get_if<Mesh>(&reply)) expect_sound(*mesh);
    } catch (const BadReply&) {
    } catch (const EndOfBytes&) {
    }
  }
}

TEST(MeshReply, MoreThanTheLimitIsRefusedBeforeItComes) {
  const Bytes bytes = sent(two_faces());
  EXPECT_NO_THROW(received(bytes, bytes.size()));
  EXPECT_THROW(received(bytes, 100), BadReply);
  EXPECT_THROW(received(std::span(bytes).first(200), 100), BadReply);
}

}  // namespace
}  // namespace displayfile
