// Meshes compressed by gzip and Zstandard are those that were compressed, or one message.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <zlib.h>
#include <zstd.h>

#include <string>
#include <vector>

#include "displayfile/mesh/compressed_data.h"
#include "displayfile/mesh/mesh.h"
#include "tests/error_of.h"
#include "tests/mesh_files.h"

namespace displayfile {
namespace {

using test::expect_error;

std::string by_gzip(const std::string& text) {
  constexpr int kWindow = 15, kGzip = 16, kMemory = 8;
  z_stream stream{};
  deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kWindow + kGzip, kMemory,
               Z_DEFAULT_STRATEGY);
  std::string data(deflateBound(&stream, text.size()) + 64, '\0');
  std::string in = text;
  stream.next_in = reinterpret_cast<Bytef*>(in.data());
  stream.avail_in = static_cast<uInt>(in.size());
  stream.next_out = reinterpret_cast<Bytef*>(data.data());
  stream.avail_out = static_cast<uInt>(data.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  data.resize(stream.total_out);
  deflateEnd(&stream);
  return data;
}

std::string by_zstd(const std::string& text) {
  std::string data(ZSTD_compressBound(text.size()), '\0');
  data.resize(ZSTD_compress(data.data(), data.size(), text.data(), text.size(), 3));
  return data;
}

struct Compression {
  const char* extension;
  std::string (*compressed)(const std::string&);
  const char* name;
};
const Compression kCompressions[] = {{".gz", by_gzip, "gzip"}, {".zst", by_zstd, "Zstandard"}};

class CompressedMeshes : public test::MeshFiles {};

/// Texts and binary data, short ones and one that expands in many steps.
TEST_F(CompressedMeshes, AreThoseThatWereCompressed) {
  std::string grid;
  constexpr int kSide = 200;
  for (int i = 0; i < kSide * kSide; ++i) {
    grid += fmt::format("v {} {} {}\n", i % kSide, i / kSide, i * 7919 % 1000);
  }
  for (int i = 1; i < kSide * (kSide - 1); ++i) {
    grid += fmt::format("f {} {} {}\n", i, i + 1, i + kSide);
  }
  std::string stl = "a binary one";
  stl.resize(80);
  stl += test::bytes(std::uint32_t{1});
  for (const float c : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.5f}) {
    stl += test::bytes(c);
  }
  stl += std::string(2, '\0');
  for (const auto& [name, text] :
       {std::pair<std::string, std::string>("cube.obj", test::cube()),
        {"grid.OBJ", grid},
        {"a.stl", stl},
        {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n"}}) {
    const Mesh plain = read(name, text);
    for (const Compression& by : kCompressions) {
      const Mesh mesh = read(name + by.extension, by.compressed(text));
      EXPECT_EQ(mesh.vertices, plain.vertices) << name << by.extension;
      EXPECT_EQ(mesh.corners, plain.corners) << name << by.extension;
      EXPECT_EQ(mesh.face_materials, plain.face_materials) << name << by.extension;
      EXPECT_EQ(mesh.usual_upright, plain.usual_upright) << name;
      EXPECT_EQ(mesh.upright, plain.upright) << name;
      EXPECT_TRUE(mesh.skipped.warnings.empty()) << name;
    }
  }
}

TEST_F(CompressedMeshes, MayBeInPartsAndUnderOtherNames) {
  for (const Compression& by : kCompressions) {
    const std::string text = test::cube(), half = text.substr(0, 40), rest = text.substr(40);
    EXPECT_EQ(read("a.obj" + std::string(by.extension),
                   by.compressed(half) + by.compressed("") + by.compressed(rest))
                  .faces(),
              6u);
    EXPECT_EQ(read("b.obj", by.compressed(text)).faces(), 6u) << "the bytes tell";
  }
  EXPECT_EQ(read("c.obj.gz", by_gzip(test::cube()) + std::string(512, '\0')).faces(), 6u)
      << "zeros follow on tapes";
  EXPECT_EQ(read("d.obj.gz", test::cube()).faces(), 6u) << "expanded already";
}

TEST_F(CompressedMeshes, FindTheirMaterials) {
  file("my.mtl", "newmtl red\nKd 1 0 0\n");
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n";
  for (const Compression& by : kCompressions) {
    for (const char* library : {"my.mtl", "gone.mtl"}) {
      const Mesh mesh = read("my.obj" + std::string(by.extension),
                             by.compressed(fmt::format("mtllib {}\n", library) + text));
      EXPECT_EQ(mesh.colour(0), Colour(1, 0, 0)) << by.extension << library;
    }
  }
}

TEST_F(CompressedMeshes, MessagesNameThePlaceInTheText) {
  for (const Compression& by : kCompressions) {
    const std::string path =
        file("a.obj" + std::string(by.extension), by.compressed("v 0 0 0\nv 1 x 0\n"));
    expect_error([&] { read_mesh(path); }, path + ":2:5: 'x'");
  }
}

TEST_F(CompressedMeshes, DamagedDataAreRefused) {
  for (const Compression& by : kCompressions) {
    const std::string name = "a.obj" + std::string(by.extension);
    const std::string data = by.compressed(test::two_cubes(3));
    for (std::size_t n = 4; n < data.size(); n += 7) {
      expect_error([&] { read(name, data.substr(0, n)); },
                   fmt::format("its compressed data are cut off ({})", by.name));
    }
    int refused = 0;
    for (std::size_t i = 4; i < data.size(); ++i) {
      std::string changed = data;
      changed[i] = static_cast<char>(changed[i] ^ 0x55);
      refused += test::error_of([&] { read(name, changed); }).empty() ? 0 : 1;
    }
    EXPECT_GT(refused, static_cast<int>(data.size()) / 2);
    expect_error([&] { read(name, data + "more"); }, "its compressed data are damaged");
  }
}

/// A few bytes that stand for gigabytes.
TEST_F(CompressedMeshes, DataThatExpandTooMuchAreRefused) {
  const std::string zeros(std::size_t{100} << 20, ' ');
  for (const Compression& by : kCompressions) {
    const std::string path = file("a.obj" + std::string(by.extension), by.compressed(zeros));
    expect_error([&] { read_mesh(path); }, path + ": it expands to more than 256 times its size");
  }
}

TEST_F(CompressedMeshes, OtherFormatsAreRefusedByName) {
  for (const Compression& by : kCompressions) {
    const std::string end = by.extension;
    expect_error(
        [&] { read("a.gltf" + end, by.compressed("{}")); },
        "compressed, which is read of OBJ, OFF, PLY and STL only, by names such as part.stl.gz: "
        "decompress it first");
    expect_error(
        [&] { read("a.step" + end, by.compressed("ISO-10303-21;")); },
        "compressed, which is read of OBJ, OFF, PLY and STL only, by names such as part.stl.gz: "
        "decompress it first");
  }
}

TEST(CompressedData, NamesLoseTheirLastExtension) {
  EXPECT_EQ(name_uncompressed("b/a.obj.gz"), "b/a.obj");
  EXPECT_EQ(name_uncompressed("a.stl.ZST"), "a.stl");
  EXPECT_EQ(name_uncompressed("a.gz.obj"), "a.gz.obj");
  EXPECT_EQ(name_uncompressed("a"), "a");
}

}  // namespace
}  // namespace displayfile
