// A mesh file that announces more than it contains is refused before memory is allocated for that.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>

#include "displayfile/mesh/mesh.h"
#include "tests/bench/command/counted_memory.h"
#include "tests/error_of.h"
#include "tests/mesh_files.h"

namespace displayfile {
namespace {

using test::bytes;
using test::error_of;
using test::MeshTest;

/// The announced size takes gigabytes.
void expect_refused(const std::string& path, const std::string& expected) {
  std::string message;
  const std::int64_t most =
      bench::most_bytes_held([&] { message = error_of([&] { read_mesh(path); }); });
  EXPECT_TRUE(message.starts_with(path)) << message;
  EXPECT_NE(message.find(expected), std::string::npos) << message;
  EXPECT_LT(most, 1 << 20) << path;
}

TEST_F(MeshTest, ReadingAFileThatIsWholeCounts) {
  std::string vertices;
  for (int k = 0; k < 50'000; ++k) vertices += fmt::format("v {} 0 0\n", k);
  const std::string path = file("whole.obj", vertices + "f 1 2 3\n");
  EXPECT_GT(bench::most_bytes_held([&] { error_of([&] { read_mesh(path); }); }), 1 << 20);
}

TEST_F(MeshTest, SizesThatAreAnnouncedTakeNoMemory) {
  expect_refused(file("vertices.off", "OFF\n1000000000 1 0\n0 0 0\n"), "1000000000 vertices");
  expect_refused(file("faces.off", "OFF\n1 1000000000 0\n0 0 0\n"), "1000000000 faces");
  expect_refused(file("corners.off", "OFF\n1 1 0\n0 0 0\n1000000000 0 0 0\n"), ":4:1:");
  const std::string count = "4000000000 0 1 2\n", binary_count("\xFF\xFF\xFF\xFF\0\0\0\1", 8);
  for (const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    const std::string start = fmt::format("ply\nformat {} 1.0\n", format);
    expect_refused(file("vertices.ply", start + "element vertex 1000000000\nproperty float x\n"
                                                "end_header\n0 0 0\n"),
                   "1000000000 vertex announced");
    expect_refused(file("list.ply", start +
                                        "element face 1\n"
                                        "property list uint int vertex_indices\nend_header\n" +
                                        (format == "ascii" ? count : binary_count)),
                   "announced");
  }
  expect_refused(file("a.stl", std::string(80, ' ') + bytes(std::uint32_t{1'000'000'000})),
                 "1000000000 facets");
}

}  // namespace
}  // namespace displayfile
