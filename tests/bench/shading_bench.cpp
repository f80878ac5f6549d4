// Flat, Gouraud and Phong shading of the same polygons, in turn, by processor time on one thread:
// balls of 100, 10,000 and 100,000 triangles, and meshes. `again`: from an unchanged display file,
// for which the z-buffer has kept its data; `anew`: from a new display file. Bytes are those of the
// display file.

#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <tuple>

#include "displayfile/graphics_system.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/segments/display_file.h"
#include "interp/device/raster_request.h"
#include "interp/raster/software.h"
#include "tests/bench/benchmark.h"
#include "tests/bench/command/timing.h"

namespace displayfile::bench {

const char* const kAbout = "Flat, Gouraud and Phong shading, in turn";

namespace {

/// A ball that fills the picture, of about that many triangles, with its own normals.
void enter_ball(int triangles, GraphicsSystem& g) {
  const int n = std::max(3, static_cast<int>(std::lround(std::sqrt(triangles / 2.0))));
  const auto point = [&](int i, int k) {
    const double a = std::numbers::pi * i / n, b = 2 * std::numbers::pi * k / n;
    return Point3(std::sin(a) * std::sin(b), -std::cos(a), std::sin(a) * std::cos(b));
  };
  g.set_view_depth(-1.5, 1.5);
  g.set_light({-0.5, 0.7, 1.0});
  g.set_line_style({LineStyle::Kind::none});
  g.set_back_face_removal(true);
  g.open_segment(1);
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      const Point3 a = point(i, k), c = point(i + 1, k + 1);
      for (const auto& triangle :
           {std::array{a, point(i, k + 1), c}, std::array{a, c, point(i + 1, k)}}) {
        g.set_vertex_normals(triangle);
        g.polygon_abs_3(triangle);
      }
    }
  }
  g.close_segment();
}

void compare(const std::string& name, const Options& options, const auto& enter) {
  std::array<GraphicsSystem, 3> systems;
  for (const Shading shading : {Shading::flat, Shading::gouraud, Shading::phong}) {
    GraphicsSystem& system = systems[static_cast<std::size_t>(shading)];
    system.set_shading(shading);
    enter(system);
  }
  const auto file = [&](Shading shading) -> const DisplayFile& {
    return systems[static_cast<std::size_t>(shading)].display_file();
  };
  const RasterRequest request{.width = options.size,
                              .height = options.size,
                              .surfaces = {.method = HiddenMethod::z_buffer}};
  const auto ratio = [&](const auto& a, const auto& b) {
    return figures(ratio_of_seconds(
        options.rounds, [&] { return seconds_each(Clock::processor, 1, a); },
        [&] { return seconds_each(Clock::processor, 1, b); }));
  };
  for (const auto& [what, over, under] :
       {std::tuple("Gouraud over flat", Shading::gouraud, Shading::flat),
        {"Phong over flat", Shading::phong, Shading::flat},
        {"Phong over Gouraud", Shading::phong, Shading::gouraud}}) {
    const DisplayFile &a = file(under), &b = file(over);
    SoftwareRenderer of_a, of_b;
    print_row({{"table", "shading"},
               {"scene", name},
               {"seen from the front", a.polygons()},
               {"ratio", what},
               {"bytes", figure(static_cast<double>(b.bytes()) / static_cast<double>(a.bytes()))},
               {"again", ratio([&] { of_a.draw(a, request); }, [&] { of_b.draw(b, request); })},
               {"anew", ratio([&] { draw_with_software(a, request); },
                              [&] { draw_with_software(b, request); })}});
  }
}

}  // namespace

void run(const Options& options) {
  for (const int triangles : {100, 10'000, 100'000}) {
    compare(fmt::format("ball of {}", triangles), options,
            [&](GraphicsSystem& system) { enter_ball(triangles, system); });
  }
  for (const std::string& path : options.inputs) {
    compare(std::filesystem::path(path).filename().string(), options,
            [&](GraphicsSystem& system) { import_mesh(path, system); });
  }
}

}  // namespace displayfile::bench
