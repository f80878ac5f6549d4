// The visible-surface map beside CGAL's envelopes of triangles, which are exact too.
//   map_beside_envelope MESH...
// Both get the same triangles in normalised device coordinates of an orthographic view, the
// nearest of which is seen: the upper envelope. Prints ratios and counts.

#include <CGAL/Env_surface_data_traits_3.h>
#include <CGAL/Env_triangle_traits_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/envelope_3.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <string>
#include <vector>

#include "hidden/map/map_pieces.h"
#include "programs/bench/side_by_side.h"
#include "tests/bench/command_line.h"
#include "tests/bench/device_scene.h"
#include "tests/bench/result_table.h"

namespace displayfile::bench {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Traits = CGAL::Env_triangle_traits_3<Kernel>;
using EnvelopeDiagram = CGAL::Envelope_diagram_2<Traits>;

/// The envelope's triangles: those that are not edge-on, which it does not take here, nor we.
std::vector<Traits::Surface_3> surfaces_of(const DeviceScene& scene) {
  std::vector<Traits::Surface_3> surfaces;
  for (const Primitives::Item& polygon : scene.polygons) {
    const auto at = [&](std::size_t k) {
      const Point3& p = scene.points[polygon.first + k];
      return Kernel::Point_3(p.x, p.y, p.z);
    };
    const Kernel::Triangle_3 triangle(at(0), at(1), at(2));
    if (!triangle.is_degenerate()) surfaces.emplace_back(triangle);
  }
  return surfaces;
}

std::size_t faces_with_surfaces(const EnvelopeDiagram& diagram) {
  std::size_t faces = 0;
  for (auto f = diagram.faces_begin(); f != diagram.faces_end(); ++f) {
    faces += f->number_of_surfaces() > 0 ? 1 : 0;
  }
  return faces;
}

struct Options {
  std::vector<std::string> meshes;
  int rounds = 5;
};

void run(const Options& options) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& mesh : options.meshes) {
    const DeviceScene scene = read_model(mesh).all;
    std::size_t pieces = 0, faces = 0;
    std::vector<double> ours;
    for (int round = 0; round <= options.rounds; ++round) {
      const double spent = seconds([&] {
        pieces = pieces_of_map(scene.items(), visible_map(scene.items(), {})).pieces.size();
      });
      if (round > 0) ours.push_back(spent);
    }
    const std::vector<Traits::Surface_3> surfaces = surfaces_of(scene);
    const double envelope = seconds([&] {
      EnvelopeDiagram diagram;
      CGAL::upper_envelope_3(surfaces.begin(), surfaces.end(), diagram);
      faces = faces_with_surfaces(diagram);
    });
    rows.push_back({scene.name, std::to_string(scene.size()), std::to_string(pieces),
                    std::to_string(faces), fmt::format("{:.0f}", envelope / spread(ours).median)});
  }
  fmt::print("{}", text_table({"mesh", "triangles", "pieces of the map", "faces of the envelope",
                               "envelope's time over the map's"},
                              rows));
}

}  // namespace
}  // namespace displayfile::bench

int main(int argc, char** argv) {
  displayfile::bench::Options options;
  CLI::App app("The map beside CGAL's Envelope_3", "map_beside_envelope");
  app.add_option("meshes", options.meshes, "meshes")->required()->check(CLI::ExistingFile);
  app.add_option("--rounds", options.rounds)->check(CLI::Range(1, 1000));
  return displayfile::bench::parsed_and_run(app, argc, argv,
                                            [&] { displayfile::bench::run(options); });
}
