// The C++ side of bindings.py: enters a mesh and draws it, and prints the least seconds of each;
// or, with --views, the median seconds of new views of a wave.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <glm/common.hpp>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

#include "displayfile/mesh/fitted_view.h"
#include "displayfile/mesh/mesh.h"
#include "interp/displayfile.h"

namespace {

using namespace displayfile;

template <class Work>
double seconds(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void set_window(const Mesh& mesh, GraphicsSystem& system) {
  Point3 low = mesh.vertices.front(), high = low;
  for (const Point3& p : mesh.vertices) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  system.set_window(low.x, high.x, low.y, high.y);
}

void enter(const Mesh& mesh, GraphicsSystem& system) {
  system.set_line_style({LineStyle::Kind::none});
  system.set_light({1, 1, 1});
  system.open_segment(1);
  system.polygons_abs_3({mesh.vertices, mesh.corners});
  system.close_segment();
}

DrawOptions by_z_buffer(int size) {
  DrawOptions options;
  options.width = options.height = size;
  options.surfaces.method = HiddenMethod::z_buffer;
  options.samples = 1;
  return options;
}

// The wave of bindings.py.
Mesh wave(int cells) {
  Mesh mesh;
  for (int row = 0; row <= cells; ++row) {
    for (int column = 0; column <= cells; ++column) {
      const double x = 4.0 * column / cells - 2.0, y = 4.0 * row / cells - 2.0;
      mesh.vertices.push_back({x, y, 0.4 * std::sin(5.0 * x) * std::cos(4.0 * y)});
    }
  }
  const auto across = static_cast<std::uint32_t>(cells);
  for (std::uint32_t row = 0; row < across; ++row) {
    for (std::uint32_t column = 0; column < across; ++column) {
      const std::uint32_t k = row * (across + 1) + column;
      for (const std::uint32_t corner :
           {k, k + 1, k + across + 2, k, k + across + 2, k + across + 1}) {
        mesh.corners.push_back(corner);
      }
    }
  }
  return mesh;
}

Camera camera_at(double azimuth) {
  return {.eye = EyeDirection{azimuth, 30.0}, .upright = upright("z")};
}

void print_new_views(int cells, int rounds) {
  const Mesh mesh = wave(cells);
  GraphicsSystem system;
  system.retain();
  fit_view(mesh.vertices, system, camera_at(0.0));
  enter(mesh, system);
  const DrawOptions options = by_z_buffer(800);
  Renderer renderer;
  std::vector<double> times;
  for (int k = 0; k < rounds; ++k) {
    GraphicsSystem shape;
    fit_view(mesh.vertices, shape, camera_at(7.0 * k));
    const InView seen{*system.retained(), system.display_file(), shape.view()};
    times.push_back(seconds([&] { renderer.draw(seen, options); }));
  }
  const auto middle = times.begin() + rounds / 2;
  std::nth_element(times.begin(), middle, times.end());
  std::cout << *middle << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3 && argc != 4) {
    std::cerr << "usage: bindings_bench MESH ROUNDS, or --views CELLS ROUNDS\n";
    return 2;
  }
  if (argc == 4) {
    print_new_views(std::atoi(argv[2]), std::atoi(argv[3]));
    return 0;
  }
  const Mesh mesh = read_mesh(argv[1]);
  const int rounds = std::atoi(argv[2]);
  const DrawOptions options = by_z_buffer(1024);
  double entering = std::numeric_limits<double>::infinity(), anew = entering, again = entering;
  for (int k = 0; k < rounds; ++k) {
    GraphicsSystem system;
    set_window(mesh, system);
    entering = std::min(entering, seconds([&] { enter(mesh, system); }));
    Renderer renderer;
    anew = std::min(anew, seconds([&] { renderer.draw(system, options); }));
    for (int i = 0; i < 3; ++i) {
      again = std::min(again, seconds([&] { renderer.draw(system, options); }));
    }
  }
  std::cout << entering << ' ' << anew << ' ' << again << '\n';
}
