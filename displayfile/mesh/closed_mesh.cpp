#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numeric>
#include <span>
#include <vector>

#include "displayfile/mesh/mesh.h"
#include "displayfile/mesh/welded_faces.h"
#include "hidden/disjoint_sets.h"
#include "hidden/exact/rounding.h"

namespace displayfile {

namespace {

double sum_of_sizes(const Point3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

/// False only if the faces leave a hole: the area vectors of a closed surface sum to 0. Sides whose
/// ends are within reach of each other differ by an area of at most their length times the reach;
/// the rest of the tolerance is for rounding, of products and of their sum.
bool area_may_be_closed(const Mesh& mesh, double reach) {
  Point3 twice_area(0.0);
  double lengths = 0.0, products = 0.0;
  for (std::size_t i = 0; i < mesh.faces(); ++i) {
    const auto face = mesh.face(i);
    const Point3& p = mesh.vertices[face[0]];
    Point3 a = mesh.vertices[face[1]] - p;
    double to_a = sum_of_sizes(a);
    lengths += 2.0 * to_a;  // a side is no longer than the ways to both of its ends
    for (const std::uint32_t corner : face.subspan(2)) {
      const Point3 b = mesh.vertices[corner] - p;
      const double to_b = sum_of_sizes(b);
      twice_area += glm::cross(a, b);
      products += to_a * to_b;
      lengths += 2.0 * to_b;
      a = b;
      to_a = to_b;
    }
  }
  const double rounded = (static_cast<double>(mesh.corners.size()) + 16.0) * kUnit * products;
  return !(glm::length(twice_area) > 4.0 * reach * lengths + rounded);
}

/// True if every edge is used exactly twice, once in each direction.
bool edges_pair_up(const WeldedFaces& faces) {
  const std::size_t vertices = faces.vertices.size();
  std::vector<std::size_t> end(vertices + 1, 0);  // of the edges with this lower end
  for_each_edge(faces,
                [&](std::uint32_t from, std::uint32_t to) { ++end[std::min(from, to) + 1]; });
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<std::uint64_t> edges(end.back());  // twice the higher end, and 1 if they come from it
  for_each_edge(faces, [&](std::uint32_t from, std::uint32_t to) {
    edges[end[std::min(from, to)]++] = 2 * std::uint64_t{std::max(from, to)} + (from > to ? 1 : 0);
  });
  std::size_t begin = 0;
  for (std::size_t v = 0; v < vertices; begin = end[v++]) {
    const auto of_vertex = std::span(edges).subspan(begin, end[v] - begin);
    std::ranges::sort(of_vertex);
    if (of_vertex.size() % 2 != 0) return false;
    for (std::size_t k = 0; k < of_vertex.size(); k += 2) {
      if (of_vertex[k] % 2 != 0 || of_vertex[k + 1] != of_vertex[k] + 1) return false;
    }
  }
  return true;
}

DisjointSets connected_parts(const WeldedFaces& faces) {
  DisjointSets parts(faces.vertices.size());
  for (std::size_t i = 0; i < faces.faces(); ++i) {
    for (const std::uint32_t v : faces.face(i)) parts.join(v, faces.face(i)[0]);
  }
  return parts;
}

/// True if every connected part encloses a positive volume (the divergence theorem, summed over
/// the fans of its faces, about a vertex of its own).
bool volumes_are_positive(const WeldedFaces& faces) {
  DisjointSets parts = connected_parts(faces);
  std::vector<double> volume(faces.vertices.size(), 0.0);
  for (std::size_t i = 0; i < faces.faces(); ++i) {
    const auto face = faces.face(i);
    const std::uint32_t own = parts.name(face[0]);
    const Point3& origin = faces.vertices[own];
    const Point3 a = faces.vertices[face[0]] - origin;
    for (std::size_t k = 2; k < face.size(); ++k) {
      const Point3 b = faces.vertices[face[k - 1]] - origin;
      const Point3 c = faces.vertices[face[k]] - origin;
      volume[own] += glm::dot(a, glm::cross(b, c));
    }
  }
  for (std::uint32_t v = 0; v < volume.size(); ++v) {
    if (!(volume[parts.name(v)] > 0.0)) return false;
  }
  return true;
}

bool pair_up_and_bound(const WeldedFaces& faces) {
  return edges_pair_up(faces) && volumes_are_positive(faces);
}

/// As pair_up_and_bound, but the ends of some edges may also lie along others.
bool bounds_solids(const WeldedFaces& faces, double reach) {
  if (pair_up_and_bound(faces)) return true;
  const SidesWithVertices sides(faces, reach);
  return sides.any() && pair_up_and_bound(FacesWithCorners(faces, sides).faces());
}

}  // namespace

bool closed_and_consistently_oriented(const Mesh& mesh) {
  const double reach = entered_reach(mesh);
  if (mesh.objects.empty() || !area_may_be_closed(mesh, reach)) return false;
  const WeldedFaces all = weld(mesh, reach);
  if (bounds_solids(all, reach)) return true;
  if (mesh.objects.size() == 1) return false;
  WeldedObjects faces_of(all);
  return std::ranges::all_of(mesh.objects, [&](const Mesh::Object& object) {
    return bounds_solids(faces_of(object), reach);
  });
}

}  // namespace displayfile
