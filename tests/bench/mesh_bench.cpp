// From a mesh file to a display file, by the readers here and by the import library side by side:
//   mesh_bench [--triangles N] [--rounds N]
// Prints ratios; run it on a machine that does nothing else.

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "displayfile/mesh/fitted_view.h"
#include "displayfile/mesh/import_library.h"
#include "displayfile/mesh/mesh.h"
#include "programs/bench/side_by_side.h"

namespace displayfile::bench {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

struct Triangles {
  std::vector<Point3> vertices;
  std::vector<Triangle> faces;
};

/// Points of a surface over n x m squares, each cut in two. One that goes round has its last column
/// on its first.
Triangles surface(std::uint32_t n, std::uint32_t m, bool round, const auto& at) {
  Triangles t;
  const std::uint32_t columns = round ? n : n + 1;
  for (std::uint32_t j = 0; j <= m; ++j) {
    for (std::uint32_t i = 0; i < columns; ++i) t.vertices.push_back(at(1.0 * i / n, 1.0 * j / m));
  }
  for (std::uint32_t j = 0; j < m; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = j * columns + i, b = j * columns + (i + 1) % columns;
      t.faces.push_back({a, b, b + columns});
      t.faces.push_back({a, b + columns, a + columns});
    }
  }
  return t;
}

Triangles height_field(std::uint32_t n) {
  return surface(n, n, false, [](double u, double v) {
    return Point3(2 * u - 1, 2 * v - 1, 0.2 * std::sin(10 * u) * std::cos(14 * v));
  });
}

/// Closed: its poles are many vertices of equal position.
Triangles ball(std::uint32_t n) {
  return surface(n, n, true, [](double u, double v) {
    const double longitude = 2 * M_PI * u, latitude = M_PI * v;
    const double r = v == 0.0 || v == 1.0 ? 0.0 : std::sin(latitude);
    return Point3(r * std::cos(longitude), -std::cos(latitude), -r * std::sin(longitude));
  });
}

std::string obj(const Triangles& t) {
  std::string text;
  for (const Point3& p : t.vertices) text += fmt::format("v {:.6f} {:.6f} {:.6f}\n", p.x, p.y, p.z);
  for (const auto& [a, b, c] : t.faces) text += fmt::format("f {} {} {}\n", a + 1, b + 1, c + 1);
  return text;
}

template <class Number>
void put(std::string& bytes, Number value) {
  const auto raw = std::bit_cast<std::array<char, sizeof value>>(value);
  bytes.append(raw.begin(), raw.end());
}

std::string ply(const Triangles& t) {
  std::string data = fmt::format(
      "ply\nformat binary_{}_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\n"
      "property float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
      std::endian::native == std::endian::little ? "little" : "big", t.vertices.size(),
      t.faces.size());
  for (const Point3& p : t.vertices) {
    for (int axis = 0; axis < 3; ++axis) put(data, static_cast<float>(p[axis]));
  }
  for (const Triangle& face : t.faces) {
    data += '\3';
    for (const std::uint32_t v : face) put(data, v);
  }
  return data;
}

/// A file that is gone afterwards.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& extension, const std::string& data)
      : path_(std::filesystem::temp_directory_path() /
              fmt::format("mesh_bench.{}.{}", ::getpid(), extension)) {
    std::ofstream(path_, std::ios::binary) << data;
  }
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

/// As import_meshes enters a bare mesh.
void enter_bare(const Mesh& mesh) {
  GraphicsSystem system;
  fit_view(std::span(&mesh, 1), system);
  enter_meshes(std::span(&mesh, 1), system);
}

void print(const std::string& what, const Spread& faster) {
  fmt::print("{:<56} {:>6.2f} times as fast ({:.2f} to {:.2f})\n", what, faster.median,
             faster.least, faster.greatest);
}

void compare(const std::string& name, const std::string& extension, const std::string& data,
             int rounds) {
  const TemporaryFile file(extension, data);
  const std::string path = file.path();
  print(name + ", file to mesh",
        times_faster(
            rounds, [&] { read_mesh(path); }, [&] { read_by_import_library(path, false); }));
  print(name + ", file to display file",
        times_faster(
            rounds, [&] { enter_bare(read_mesh(path)); },
            [&] { enter_bare(read_by_import_library(path, false)); }));
}

void run(int triangles, int rounds) {
  const auto n = static_cast<std::uint32_t>(std::ceil(std::sqrt(triangles / 2.0)));
  fmt::print("Against Assimp {} in the same process, {} triangles\n",
             import_library_version().value_or("(none)"), 2 * n * n);
  const Triangles field = height_field(n), round = ball(n);
  compare("height field, OBJ", "obj", obj(field), rounds);
  compare("height field, binary PLY", "ply", ply(field), rounds);
  compare("ball, OBJ", "obj", obj(round), rounds);
  compare("ball, binary PLY", "ply", ply(round), rounds);
}

}  // namespace
}  // namespace displayfile::bench

int main(int argc, char** argv) {
  CLI::App app("From a mesh file to a display file, beside the import library");
  int triangles = 1000000, rounds = 5;
  app.add_option("--triangles", triangles)->check(CLI::Range(2, 100000000));
  app.add_option("--rounds", rounds)->check(CLI::Range(1, 1000));
  CLI11_PARSE(app, argc, argv);
  displayfile::bench::run(triangles, rounds);
}
