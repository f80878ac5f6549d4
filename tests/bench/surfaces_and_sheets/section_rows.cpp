// The areas of sections against rational arithmetic: 50 planes through every closed mesh, of them
// 20 through vertices and 10 along faces, on both sides.

#include <fmt/format.h>
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <random>

#include "displayfile/mesh/section.h"
#include "hidden/triangulation.h"
#include "tests/bench/surfaces_and_sheets/rows.h"

namespace displayfile::bench {
namespace {

using RationalPoint = std::array<mpq_class, 3>;

/// Faces as triangles: what a face of more sides that is not flat is cut into is no matter of
/// sections.
std::vector<std::array<Point3, 3>> triangles_of(const Mesh& mesh) {
  std::vector<std::array<Point3, 3>> all;
  Triangulation triangulation;
  std::vector<Point3> polygon;
  for (std::size_t i = 0; i < mesh.faces(); ++i) {
    polygon.clear();
    for (const std::uint32_t v : mesh.face(i)) polygon.push_back(mesh.vertices[v]);
    if (polygon.size() == 3) {
      all.push_back({polygon[0], polygon[1], polygon[2]});
      continue;
    }
    for (const auto& t : triangulation.triangulate(polygon)) {
      all.push_back({polygon[t.vertex[0]], polygon[t.vertex[1]], polygon[t.vertex[2]]});
    }
  }
  return all;
}

std::size_t largest_axis(const Point3& normal) {
  const Point3 size = glm::abs(normal);
  return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

/// The area in the projection along an axis, as a sum over triangles: no loops are made. The limit
/// of planes from behind: a vertex in the plane counts as before it.
double exact_area(const std::vector<std::array<Point3, 3>>& triangles, const SectionPlane& plane) {
  const std::size_t axis = largest_axis(plane.normal), x = (axis + 1) % 3, y = (axis + 2) % 3;
  const auto value = [&](const RationalPoint& p) {
    return mpq_class(plane.normal.x * p[0] + plane.normal.y * p[1] + plane.normal.z * p[2] -
                     plane.distance);
  };
  mpq_class twice = 0;
  for (const auto& triangle : triangles) {
    // Far from the plane no rational is needed: a bound of some hundred roundings.
    bool all_before = true, all_behind = true;
    for (const Point3& p : triangle) {
      const double near = glm::dot(plane.normal, p) - plane.distance;
      const double bound =
          1e-13 * (glm::dot(glm::abs(plane.normal), glm::abs(p)) + std::abs(plane.distance));
      all_before &= near > bound;
      all_behind &= near < -bound;
    }
    if (all_before || all_behind) continue;
    std::array<RationalPoint, 3> t;
    std::array<mpq_class, 3> v;
    for (std::size_t i = 0; i < 3; ++i) {
      t[i] = {triangle[i].x, triangle[i].y, triangle[i].z};
      v[i] = value(t[i]);
    }
    RationalPoint up, down;
    bool is_cut = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      if ((v[i] >= 0) == (v[j] >= 0)) continue;
      is_cut = true;
      RationalPoint& p = v[j] >= 0 ? up : down;
      for (std::size_t c = 0; c < 3; ++c) p[c] = (t[i][c] * v[j] - t[j][c] * v[i]) / (v[j] - v[i]);
    }
    if (is_cut) twice += down[x] * up[y] - up[x] * down[y];
  }
  const mpq_class half = twice / 2;
  return half.get_d() * (glm::length(plane.normal) / plane.normal[static_cast<int>(axis)]);
}

std::vector<SectionPlane> planes_through(const Mesh& mesh) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> in(-1.0, 1.0);
  const auto any_vertex = [&] {
    return mesh.vertices[mesh.corners[random() % mesh.corners.size()]];
  };
  std::vector<SectionPlane> planes;
  for (int k = 0; k < 50; ++k) {
    Point3 normal(in(random), in(random), in(random));
    const Point3 a = any_vertex(), b = any_vertex();
    if (k < 10) {  // along an axis, through a vertex, exactly
      normal = Point3(0.0);
      normal[k % 3] = k % 2 == 0 ? 1.0 : -1.0;
      planes.push_back({normal, glm::dot(normal, a)});
    } else if (k < 20) {  // through a vertex, but for rounding
      planes.push_back({normal, glm::dot(normal, a)});
    } else if (k < 30) {  // along a face, from both sides
      const auto face = mesh.face(random() % mesh.faces());
      const Point3& p = mesh.vertices[face[0]];
      Point3 across = glm::cross(mesh.vertices[face[1]] - p, mesh.vertices[face[2]] - p);
      if (across == Point3(0.0)) across = normal;
      if (k % 2 == 0) across = -across;
      planes.push_back({across, glm::dot(across, p)});
    } else {
      planes.push_back({normal, glm::dot(normal, 0.5 * (a + b))});
    }
  }
  return planes;
}

Result row_of(const std::string& path) {
  constexpr double kLimit = 1e-12;
  const std::string name = std::filesystem::path(path).stem().string();
  const Mesh mesh = read_mesh(path);
  Result row{fmt::format("section areas of {}, 50 planes", name), "<= 1e-12", "", "", "", ""};
  if (!closed_and_consistently_oriented(mesh)) {
    row.measured = "not closed";
    return row;
  }
  const auto triangles = triangles_of(mesh);
  double worst = 0.0;
  int cut = 0;
  for (const SectionPlane& plane : planes_through(mesh)) {
    const double exact = exact_area(triangles, plane), found = section(mesh, plane).area;
    cut += exact != 0.0;
    const double error = exact == found ? 0.0 : std::abs(found - exact) / std::abs(exact);
    worst = std::max(worst, error);
  }
  row.measured = fmt::format("{:.2e}", worst);
  row.spread = fmt::format("{} cut it", cut);
  row.beside = "rational arithmetic, relative";
  row.verdict = holds_if(worst <= kLimit);
  return row;
}

}  // namespace

void add_section_rows(const TableOptions& options, std::vector<Result>& results) {
  for (const std::string& path : options.meshes) results.push_back(row_of(path));
}

}  // namespace displayfile::bench
