// The visible-surface map of meshes beside CGAL's envelopes of triangles, which are exact too. Both
// get the same triangles in normalised device coordinates of an orthographic view, the nearest of
// which is seen: the upper envelope.

#include <CGAL/Env_surface_data_traits_3.h>
#include <CGAL/Env_triangle_traits_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/envelope_3.h>

#include "hidden/map/map_pieces.h"
#include "tests/bench/benchmark.h"
#include "tests/bench/device_scene.h"

namespace displayfile::bench {

const char* const kAbout = "The map beside CGAL's Envelope_3";

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

}  // namespace

void run(const Options& options) {
  for (const std::string& mesh : options.inputs) {
    const DeviceScene scene = read_model(mesh).all;
    std::size_t pieces = 0, faces = 0;
    const auto find = [&] {
      pieces = pieces_of_map(scene.items(), visible_map(scene.items(), {})).pieces.size();
    };
    find();
    std::vector<double> ours;
    for (int round = 0; round < options.rounds; ++round) ours.push_back(seconds(find));
    const std::vector<Traits::Surface_3> surfaces = surfaces_of(scene);
    const double envelope = seconds([&] {
      EnvelopeDiagram diagram;
      CGAL::upper_envelope_3(surfaces.begin(), surfaces.end(), diagram);
      for (auto f = diagram.faces_begin(); f != diagram.faces_end(); ++f) {
        faces += f->number_of_surfaces() > 0 ? 1 : 0;
      }
    });
    print_row({{"table", "the map beside CGAL's envelope"},
               {"mesh", scene.name},
               {"triangles", scene.size()},
               {"pieces of the map", pieces},
               {"faces of the envelope", faces},
               {"envelope's time over the map's", figure(envelope / spread(ours).median)}});
  }
}

}  // namespace displayfile::bench
