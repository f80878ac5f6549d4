// The C++ side of bindings.py: enters a mesh and draws it, and prints the least seconds of each.

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <glm/common.hpp>
#include <iostream>
#include <limits>
#include <string>

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

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: bindings_bench MESH ROUNDS\n";
    return 2;
  }
  const Mesh mesh = read_mesh(argv[1]);
  const int rounds = std::atoi(argv[2]);
  const DrawOptions options{
      .width = 1024, .height = 1024, .surfaces = {.method = HiddenMethod::z_buffer}, .samples = 1};
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
