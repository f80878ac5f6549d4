// What smooth shading costs: flat, Gouraud and Phong shading of the same polygons, in turn:
//   shading_bench [--size N] [--rounds N] [--method METHOD] [MESH...]
// Balls of 100, 10,000 and 100,000 triangles, and the meshes. A picture of an unchanged display
// file, of which the method has all that it keeps; and one from a display file that is new to it.
// Prints ratios; run it on a machine that does nothing else.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "clip/surfaces.h"
#include "displayfile/mesh/mesh.h"
#include "interp/device/raster_request.h"
#include "interp/raster/software.h"
#include "programs/bench/side_by_side.h"
#include "tests/bench/command_line.h"

namespace displayfile::bench {
namespace {

struct Options {
  int size = 1024, rounds = 15;
  std::string method = "z-buffer";
  std::vector<std::string> meshes;
};

/// A ball that fills the picture, of about so many triangles, with its own normals.
DisplayFile ball(int triangles, Shading shading) {
  const int n = std::max(3, static_cast<int>(std::lround(std::sqrt(triangles / 2.0))));
  const auto point = [&](int i, int k) {
    const double a = std::numbers::pi * i / n, b = 2 * std::numbers::pi * k / n;
    return Point3(std::sin(a) * std::sin(b), -std::cos(a), std::sin(a) * std::cos(b));
  };
  GraphicsSystem g;
  g.set_view_depth(-1.5, 1.5);
  g.set_light({-0.5, 0.7, 1.0});
  g.set_shading(shading);
  g.set_line_style({LineStyle::Kind::none});
  g.set_back_face_removal(true);
  g.open_segment(1);
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      const Point3 a = point(i, k), b = point(i, k + 1), c = point(i + 1, k + 1);
      const Point3 d = point(i + 1, k);
      for (const auto& triangle : {std::array{a, b, c}, std::array{a, c, d}}) {
        g.set_vertex_normals(triangle);
        g.polygon_abs_3(triangle);
      }
    }
  }
  g.close_segment();
  return g.display_file();
}

DisplayFile mesh(const std::string& path, Shading shading) {
  GraphicsSystem g;
  g.set_shading(shading);
  import_mesh(path, g);
  return g.display_file();
}

/// By one thread.
double processor_seconds(const auto& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Ratios of the second's processor time to the first's.
void compare(const std::string& name, const DisplayFile& a, const DisplayFile& b,
             const Options& options) {
  const RasterRequest request{
      .width = options.size, .height = options.size, .method = hidden_method(options.method)};
  SoftwareRenderer of_a, of_b;
  const Spread again = ratio_of_seconds(
      options.rounds, [&] { return processor_seconds([&] { of_a.draw(a, request); }); },
      [&] { return processor_seconds([&] { of_b.draw(b, request); }); });
  const Spread anew = ratio_of_seconds(
      options.rounds, [&] { return processor_seconds([&] { draw_with_software(a, request); }); },
      [&] { return processor_seconds([&] { draw_with_software(b, request); }); });
  fmt::print("  {:<20} again {:5.2f} ({:.2f} to {:.2f}), anew {:5.2f} ({:.2f} to {:.2f})\n", name,
             again.median, again.least, again.greatest, anew.median, anew.least, anew.greatest);
}

template <class Drawn>
void compare_shadings(const std::string& name, const Options& options, const Drawn& drawn) {
  const DisplayFile flat = drawn(Shading::flat), gouraud = drawn(Shading::gouraud),
                    phong = drawn(Shading::phong);
  fmt::print("{}, {} polygons seen from the front; bytes {:.2f} and {:.2f} of flat\n", name,
             flat.polygons(),
             static_cast<double>(gouraud.bytes()) / static_cast<double>(flat.bytes()),
             static_cast<double>(phong.bytes()) / static_cast<double>(flat.bytes()));
  compare("Gouraud over flat", flat, gouraud, options);
  compare("Phong over flat", flat, phong, options);
  compare("Phong over Gouraud", gouraud, phong, options);
}

void run(const Options& options) {
  for (const int triangles : {100, 10'000, 100'000}) {
    compare_shadings(fmt::format("ball of {}", triangles), options,
                     [&](Shading shading) { return ball(triangles, shading); });
  }
  for (const std::string& path : options.meshes) {
    compare_shadings(std::filesystem::path(path).filename().string(), options,
                     [&](Shading shading) { return mesh(path, shading); });
  }
}

}  // namespace
}  // namespace displayfile::bench

int main(int argc, char** argv) {
  displayfile::bench::Options options;
  CLI::App app{"Flat, Gouraud and Phong shading, in turn", "shading_bench"};
  app.add_option("--size", options.size, "pixels a side")->check(CLI::Range(1, 8192));
  app.add_option("--rounds", options.rounds, "that are timed")->check(CLI::Range(1, 1000));
  app.add_option("--method", options.method, "a method of image space");
  app.add_option("meshes", options.meshes)->check(CLI::ExistingFile);
  return displayfile::bench::parsed_and_run(app, argc, argv,
                                            [&] { displayfile::bench::run(options); });
}
