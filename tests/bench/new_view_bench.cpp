// New views of a retained scene: a view renderer's, that keeps memory and shares vertices
// (interp/view_renderer.h), against entering each view anew and drawing it.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include "clip/error.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/scene_viewer.h"
#include "displayfile/turntable.h"
#include "interp/draw.h"
#include "interp/raster/software.h"
#include "interp/view_renderer.h"

namespace {

using namespace displayfile;
using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A height field of 2 n^2 triangles.
void enter_terrain(int n, GraphicsSystem& system) {
  std::vector<Point3> vertices;
  std::vector<std::uint32_t> corners;
  const auto at = [n](int i, int j) { return static_cast<std::uint32_t>(j * (n + 1) + i); };
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const double x = 1.8 * i / n - 0.9, y = 1.8 * j / n - 0.9;
      const double hills = 0.2 * std::sin(7.0 * x) * std::cos(5.0 * y);
      vertices.emplace_back(x, y, hills + 0.02 * std::sin(61.0 * x + 3.0) * std::sin(47.0 * y));
    }
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      corners.insert(corners.end(), {at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      corners.insert(corners.end(), {at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  system.set_line_style({LineStyle::Kind::none});
  system.set_perspective({0.3, -2.5, 2.0});
  system.set_view_plane_normal({-0.3, 2.5, -2.0});
  system.set_view_reference_point({0, 0, 0});
  system.set_view_up({0, 0, 1});
  system.set_window(-1.3, 1.3, -1.3, 1.3);
  system.open_segment(1);
  system.polygons_abs_3(vertices, corners);
  system.close_segment();
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("New views of a retained scene, entering each anew in units of a view renderer's");
  std::string mesh;
  int side = 300, size = 1024, threads = 1, views = 24;
  bool phases = false, light = false;
  app.add_option("MESH", mesh, "a mesh file; without one, a terrain");
  app.add_option("--side", side, "of the terrain: 2 n^2 triangles");
  app.add_option("--size", size, "pixels a side");
  app.add_option("--threads", threads);
  app.add_option("--views", views);
  app.add_flag("--phases", phases, "how the time is shared");
  app.add_flag("--light", light);
  CLI11_PARSE(app, argc, argv);
  try {
    GraphicsSystem system;
    RetainedScene scene;
    system.retain(&scene);
    if (light) system.set_light({1, 2, 3});
    if (mesh.empty()) {
      enter_terrain(side, system);
    } else {
      system.set_line_style({LineStyle::Kind::none});
      import_mesh(mesh, system);
    }
    Turntable turntable(scene, system.display_file(), system.view());
    if (!mesh.empty()) turntable.fit_window(8);
    DrawOptions options;
    options.width = options.height = size;
    options.threads = threads;
    options.hidden = HiddenMethod::z_buffer;
    options.with_ids = false;
    ViewRenderer renderer(scene, system.display_file());
    SceneViewer viewer(scene, system.display_file());
    SoftwareRenderer software;
    std::vector<double> ours, anew, of_viewing, of_drawing;
    std::size_t items = 0;
    for (int k = 0; k < views + 3; ++k) {
      const auto [view, lights] = turntable.at(360.0 * k / views);
      auto start = Clock::now();
      renderer.draw(view, options, lights);
      const double new_view = since(start);
      start = Clock::now();
      const ViewedScene& seen = viewer.view({view, lights, PictureSize{size, size}, threads});
      const double viewing = since(start);
      start = Clock::now();
      RasterRequest request;
      request.width = request.height = size;
      request.threads = threads;
      request.method = HiddenMethod::z_buffer;
      software.draw(seen, request);
      const double drawing = since(start);
      items = seen.items();
      if (k < 3) continue;
      ours.push_back(new_view);
      of_viewing.push_back(viewing);
      of_drawing.push_back(drawing);
      if (k % 4 != 0) continue;
      start = Clock::now();
      const DisplayFile file = viewer.display_file(view, lights);
      SoftwareRenderer().draw(file, request);
      anew.push_back(since(start));
    }
    fmt::print(
        "{} polygons, {} x {}, {} threads: anew {:.2f} in units of a new view; viewing {:.2f} and "
        "drawing {:.2f} of it; {} items in the last\n",
        system.polygons_entered(), size, size, threads, median(anew) / median(ours),
        median(of_viewing) / median(ours), median(of_drawing) / median(ours), items);
    if (phases)
      fmt::print("ms: {:.2f} viewing {:.2f} drawing {:.2f}\n", 1e3 * median(ours),
                 1e3 * median(of_viewing), 1e3 * median(of_drawing));
  } catch (const Error& error) {
    fmt::print(stderr, "new_view_bench: {}\n", error.what());
    return 2;
  }
}
