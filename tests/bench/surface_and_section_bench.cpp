// The perimeter method, exact and as an array of columns, beside the truth and beside Franklin's;
// and areas of sections against rational arithmetic: 50 planes through every closed mesh, of them
// 20 through vertices and 10 along faces, on both sides.

#include <fmt/format.h>
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <glm/geometric.hpp>
#include <random>
#include <string>
#include <vector>

#include "displayfile/graphics_system.h"
#include "displayfile/mesh/section.h"
#include "displayfile/segments/scene_lines.h"
#include "hidden/triangles/triangulation.h"
#include "interp/truth/judged_lines.h"
#include "programs/scenes/random.h"
#include "tests/bench/benchmark.h"
#include "tests/bench/command/timing.h"

namespace displayfile::bench {

const char* const kAbout = "Surfaces by the perimeter method; areas of meshes' sections";

namespace {

namespace fs = std::filesystem;

// Surfaces.

/// Random heights, and heights of few values: flat cells, equal heights; views along the grid too.
DisplayFile random_surface(std::uint64_t seed) {
  Random random(seed);
  const auto from = [&](int low, int high) {
    return low + static_cast<int>(random.between(0.0, high - low + 1.0));
  };
  const int nx = from(2, 12), ny = from(2, 12), values = from(1, 4);
  const bool stepped = seed % 2 == 0;
  std::vector<double> heights(static_cast<std::size_t>(nx * ny));
  for (double& z : heights) z = stepped ? from(0, values) / 4.0 : random.between(-1.0, 1.0);
  const double azimuth = seed % 3 == 0 ? 45.0 * from(0, 7) : random.between(0.0, 360.0);
  const double elevation = seed % 5 == 0 ? 0.0 : random.between(-89.0, 89.0);
  const SineCosine a = sine_cosine_of_degrees(azimuth), e = sine_cosine_of_degrees(elevation);
  const Point3 eye{e.cosine * a.sine, -e.cosine * a.cosine, e.sine};
  GraphicsSystem g;
  g.set_view_plane_normal(-eye);
  g.set_view_up({0, 0, 1});
  if (seed % 4 < 2) {
    g.set_perspective(random.between(3.0, 8.0) * eye);
    g.set_window(-30, 30, -30, 30);
  } else {
    g.set_parallel(-eye);
    g.set_window(-4, 4, -4, 4);
  }
  g.open_segment(1);
  g.surface_3({-1, 1, nx, -1, 1, ny, heights});
  g.close_segment();
  return g.display_file();
}

void judge() {
  constexpr int kGrids = 200;
  LineErrors exact, rounded;
  for (int seed = 0; seed < kGrids; ++seed) {
    const DisplayFile file = random_surface(static_cast<std::uint64_t>(seed));
    const auto add = [&](LineErrors& sum, const Precision& precision) {
      const JudgedLines judged =
          judged_lines(file, {.method = HiddenMethod::perimeter, .precision = precision});
      sum.missing += judged.errors.missing;
      sum.extra += judged.errors.extra;
    };
    add(exact, {});
    add(rounded, {.exact = false, .roundoff = 1e-9});
  }
  const double wrong = exact.missing + exact.extra;
  print_row({{"work", fmt::format("missing + extra, {} random grids, beside the truth", kGrids)},
             {"asked", "0 but rounding"},
             {"measured", wrong},
             {"holds", wrong <= 1e-9 * kGrids}});
  print_row({{"work", "the same with ROUNDOFF: 1024 columns"},
             {"measured", rounded.missing + rounded.extra}});
}

/// The perimeter method alone, on a surface of 300 x 300 points.
void compare_methods(const Options& options) {
  constexpr int kPoints = 300;
  std::vector<double> heights;
  for (int j = 0; j < kPoints; ++j) {
    for (int i = 0; i < kPoints; ++i) {
      heights.push_back(0.5 * std::sin(-6.0 + 12.0 * i / (kPoints - 1)) *
                        std::cos(-6.0 + 12.0 * j / (kPoints - 1)));
    }
  }
  GraphicsSystem g;
  g.set_view_plane_normal({-0.43, 0.75, -0.5});
  g.set_parallel({-0.43, 0.75, -0.5});
  g.set_view_up({0, 0, 1});
  g.set_window(-5, 5, -5, 5);
  g.open_segment(1);
  g.surface_3({-3, 3, kPoints, -3, 3, kPoints, heights});
  g.close_segment();
  const ViewedScene scene(g.display_file());
  const auto seconds = [&](HiddenMethod method, const Precision& precision) {
    SurfacePlan sort;
    sort.precision = precision;
    return least_seconds_each(Clock::processor, options.rounds,
                              [&] { find_lines(scene, sort.by(method)); });
  };
  const double exact = seconds(HiddenMethod::perimeter, {});
  const double rounded = seconds(HiddenMethod::perimeter, {.exact = false, .roundoff = 1e-9});
  const double franklin = seconds(HiddenMethod::franklin, {});
  const std::string work = fmt::format("lines of {0} x {0} found: ", kPoints);
  print_row({{"work", work + "Franklin's time over the perimeter's"},
             {"measured", figure(franklin / exact)}});
  print_row({{"work", work + "exact over ROUNDOFF"}, {"measured", figure(exact / rounded)}});
}

// Sections.

using RationalPoint = std::array<mpq_class, 3>;

/// Faces as triangles: the division of non-flat faces of more sides does not matter to sections.
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
    } else if (k < 20) {  // through a vertex, up to rounding
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

void judge_sections(const std::string& path) {
  const Mesh mesh = read_mesh(path);
  Json row{{"work", fmt::format("section areas of {}, 50 planes", fs::path(path).stem().string())}};
  row["asked"] = "<= 1e-12";
  if (!closed_and_consistently_oriented(mesh)) {
    row["measured"] = "not closed";
    print_row(row);
    return;
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
  row.update({{"measured", worst},
              {"besides", fmt::format("{} cut it", cut)},
              {"beside", "rational arithmetic, relative"},
              {"holds", worst <= 1e-12}});
  print_row(row);
}

}  // namespace

void run(const Options& options) {
  judge();
  compare_methods(options);
  for (const std::string& path : options.inputs) judge_sections(path);
}

}  // namespace displayfile::bench
