// From an application's call to a picture, side by side with what it is held against:
//   retained_path_bench [MESH...]
// Prints ratios and counts; run it on a machine that does nothing else. LP_NUM_THREADS sets
// OSMesa's threads and ours: 0 or 1 each in one thread (0, the default, in the calling one), 2 two.
// The same triangles, the same view, no culling on either side; OSMesa's vertices shared, indexed
// and resident, glFinish, nothing read back.

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>

#include "displayfile/files.h"
#include "displayfile/mesh/mesh.h"
#include "interp/device/raster_request.h"
#include "interp/opengl/osmesa.h"
#include "interp/raster/software.h"
#include "programs/bench/indexed_triangles.h"
#include "programs/bench/opengl_mesh.h"
#include "programs/bench/side_by_side.h"

namespace displayfile::bench {
namespace {

constexpr int kRounds = 7;

/// A height field of 2 n^2 triangles that lies wholly inside the default view.
std::vector<Point3> height_field(int n) {
  std::vector<Point3> corners;
  const auto at = [n](int i, int j) {
    const double x = 1.8 * i / n - 0.9, y = 1.8 * j / n - 0.9;
    return Point3(x, y, 0.3 * std::sin(5 * x) * std::cos(7 * y));
  };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      for (const Point3& p :
           {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1)}) {
        corners.push_back(p);
      }
    }
  }
  return corners;
}

void enter(std::span<const Point3> corners, GraphicsSystem& system) {
  system.open_segment(1);
  for (std::size_t i = 0; i < corners.size(); i += 3) system.polygon_abs_3(corners.subspan(i, 3));
  system.close_segment();
}

void print(const std::string& what, double value, const std::string& unit) {
  fmt::print("{:<64} {:>8.2f} {}\n", what, value, unit);
}

void api_to_display_file() {
  std::vector<double> rates;
  for (int n : {158, 500, 1414}) {  // 50 thousand, half a million and 4 million triangles
    const auto corners = height_field(n);
    std::vector<double> times;
    std::size_t bytes = 0;
    for (int i = 0; i <= (n > 1000 ? 3 : kRounds); ++i) {
      GraphicsSystem system;
      system.set_line_style({LineStyle::Kind::none});
      times.push_back(seconds([&] { enter(corners, system); }));
      bytes = system.display_file().bytes() / system.display_file().polygons();
    }
    const double triangles = static_cast<double>(corners.size()) / 3;
    rates.push_back(triangles / spread(times).median);
    print(fmt::format("API to display file, {:.0f} triangles: of 4 million a second", triangles),
          rates.back() / 4e6, "x");
    print("  bytes a triangle in the display file (at most 160)", static_cast<double>(bytes), "");
  }
  print("  time for each triangle, of 4 million over of 50 thousand", rates.front() / rates.back(),
        "x");
}

void parsing() {
  std::ostringstream text;
  Recorder recorder(text);
  GraphicsSystem recorded;
  recorded.set_recorder(&recorder);
  enter(height_field(316), recorded);  // 200 thousand triangles
  const std::string program = text.str();
  std::vector<double> times;
  for (int i = 0; i <= kRounds; ++i) {
    GraphicsSystem system;
    times.push_back(seconds([&] { replay(program, "bench.draw", system); }));
  }
  print("replaying a drawing program: of 1 million polygons a second",
        static_cast<double>(recorded.counts().polygons) / spread(times).median / 1e6, "x");
}

void interpreting(const std::string& name, const GraphicsSystem& system) {
  RasterRequest request;
  request.width = request.height = 1024;
  request.method = HiddenMethod::z_buffer;
  if (!osmesa_available()) return;
  const IndexedTriangles triangles = indexed_triangles(ViewedScene(system.display_file()));
  OpenGlMesh peer(triangles, {PictureSize{request.width, request.height}});
  peer.set_matrix(glm::dmat4(1.0));
  peer.make_resident();
  request.threads = std::max(1, std::atoi(std::getenv("LP_NUM_THREADS")));
  SoftwareRenderer renderer;
  const Spread faster = times_faster(
      kRounds, [&] { renderer.draw(system.display_file(), request); }, [&] { peer.draw(); });
  fmt::print(
      "{:<28} {:>7} polygons, threads {}: {:>5.2f} times as fast as OSMesa ({:.2f} to {:.2f})\n",
      name, system.display_file().polygons(), request.threads, faster.median, faster.least,
      faster.greatest);
}

void run(int argc, char** argv) {
  api_to_display_file();
  parsing();
  const char* llvmpipe = std::getenv("LP_NUM_THREADS");
  fmt::print(
      "Interpreting with the z-buffer, 1024 x 1024, against OSMesa from vertex buffers\n{}\n"
      "LP_NUM_THREADS={}\n",
      osmesa_description(), llvmpipe == nullptr ? "(not set)" : llvmpipe);
  GraphicsSystem field;
  field.set_line_style({LineStyle::Kind::none});
  field.set_light({1, 2, 3});
  enter(height_field(187), field);
  interpreting("height field", field);
  for (int i = 1; i < argc; ++i) {
    GraphicsSystem system;
    import_mesh(argv[i], system);
    const std::string path = argv[i];
    interpreting(path.substr(path.rfind('/') + 1), system);
  }
}

}  // namespace
}  // namespace displayfile::bench

int main(int argc, char** argv) {
  if (std::getenv("LP_NUM_THREADS") == nullptr) setenv("LP_NUM_THREADS", "0", 0);
  displayfile::bench::run(argc, argv);
}
