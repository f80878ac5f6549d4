// The module of solids: combined by CGAL, which is included here and in touching_solids.cpp only.

#include "displayfile/solids/solids_module.h"

#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <iterator>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "displayfile/solids/combining_steps.h"
#include "displayfile/solids/exact_surface.h"

namespace displayfile {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using ExactMesh = CGAL::Surface_mesh<ExactPoint>;
using Face = ExactMesh::Face_index;
using Sources = ExactMesh::Property_map<Face, std::uint32_t>;

constexpr const char* kSource = "f:displayfile:source";

Sources sources_of(ExactMesh& mesh) {
  return mesh.add_property_map<Face, std::uint32_t>(kSource, 0).first;
}

/// Passes each face's source on to the faces it is cut into, and to the result; counts the steps.
struct SourcesFollow : PMP::Corefinement::Default_visitor<ExactMesh> {
  struct Of {
    const ExactMesh* mesh;
    Sources sources;
  };
  std::array<Of, 3>* of = nullptr;
  CombiningSteps* steps = nullptr;
  std::uint32_t cut = 0;

  void edge_face_intersections_step() const { steps->step(); }
  void intersection_of_coplanar_faces_step() const { steps->step(); }

  Sources& sources(const ExactMesh& mesh) const {
    return std::ranges::find(*of, &mesh, &Of::mesh)->sources;
  }
  void before_subface_creations(Face face, ExactMesh& mesh) { cut = sources(mesh)[face]; }
  void after_subface_created(Face face, ExactMesh& mesh) {
    steps->step();
    sources(mesh)[face] = cut;
  }
  void after_face_copy(Face from, const ExactMesh& mesh, Face to, ExactMesh& into) {
    sources(into)[to] = sources(mesh)[from];
  }
};

/// Sets the seed of the library's random numbers, which is otherwise the time: faces would be
/// triangulated differently each time.
void draw_the_same_lots() { CGAL::get_default_random() = CGAL::Random(1); }

/// A point of a mesh, for a message.
std::string in_words(const ExactPoint& p) {
  return fmt::format("{:.6g} {:.6g} {:.6g}", CGAL::to_double(p.x()), CGAL::to_double(p.y()),
                     CGAL::to_double(p.z()));
}

void require_simple(const ExactMesh& mesh, std::string_view name) {
  for (const Face face : mesh.faces()) {
    if (!PMP::is_degenerate_triangle_face(face, mesh)) continue;
    throw std::runtime_error(fmt::format("{} has a triangle of no area at {}: expected none", name,
                                         in_words(mesh.point(mesh.target(mesh.halfedge(face))))));
  }
  std::vector<std::pair<Face, Face>> crossing;
  PMP::self_intersections<CGAL::Sequential_tag>(mesh, std::back_inserter(crossing));
  if (crossing.empty()) return;
  throw std::runtime_error(fmt::format(
      "{} passes through itself near {}, or touches itself: expected a surface that does not", name,
      in_words(mesh.point(mesh.target(mesh.halfedge(std::ranges::min(crossing).first))))));
}

/// The nearest double, or the one next to it.
double nearest(const ExactKernel::FT& exact) { return CGAL::to_double(CGAL::exact(exact)); }

// ---- Solids that touch themselves ---------------------------------------------------------------

/// Vertices keep their numbers: two may have one position.
ExactSurface surface_of(ExactMesh& mesh) {
  ExactSurface surface;
  std::vector<std::uint32_t> number(mesh.num_vertices(), 0);
  for (const auto vertex : mesh.vertices()) {
    number[vertex.idx()] = static_cast<std::uint32_t>(surface.points.size());
    surface.points.push_back(mesh.point(vertex));
  }
  const Sources sources = sources_of(mesh);
  for (const Face face : mesh.faces()) {
    auto& triangle = surface.triangles.emplace_back();
    auto edge = mesh.halfedge(face);
    for (std::uint32_t& corner : triangle) {
      corner = number[mesh.target(edge).idx()];
      edge = mesh.next(edge);
    }
    surface.sources.push_back(sources[face]);
  }
  return surface;
}

/// Merges points of equal position. True if there were any.
bool merge_points(ExactSurface& surface) {
  std::vector<std::uint32_t> order(surface.points.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto at = [&](std::uint32_t i) -> const ExactPoint& { return surface.points[i]; };
  std::ranges::sort(order, ExactKernel().less_xyz_3_object(), at);
  std::vector<std::uint32_t> number(order.size());
  std::vector<ExactPoint> merged;
  for (const std::uint32_t i : order) {
    if (merged.empty() || merged.back() != at(i)) merged.push_back(at(i));
    number[i] = static_cast<std::uint32_t>(merged.size() - 1);
  }
  if (merged.size() == order.size()) return false;
  surface.points = std::move(merged);
  for (auto& triangle : surface.triangles) {
    for (std::uint32_t& corner : triangle) corner = number[corner];
  }
  return true;
}

bool has_manifold_vertices(const ExactMesh& mesh) {
  std::vector<ExactMesh::Halfedge_index> others;
  PMP::non_manifold_vertices(mesh, std::back_inserter(others));
  return others.empty();
}

/// Nothing if the surface touches itself.
std::optional<ExactMesh> mesh_of(const ExactSurface& surface) {
  if (!PMP::is_polygon_soup_a_polygon_mesh(surface.triangles)) return std::nullopt;
  ExactMesh mesh;
  PMP::polygon_soup_to_polygon_mesh(surface.points, surface.triangles, mesh);
  if (!CGAL::is_closed(mesh) || !has_manifold_vertices(mesh)) return std::nullopt;
  Sources sources = sources_of(mesh);
  for (const Face face : mesh.faces()) sources[face] = surface.sources[face.idx()];
  return mesh;
}

// ---- Which sides of triangles lie within a plane ------------------------------------------------

/// Finds the triangles beside a side.
class Neighbours {
 public:
  explicit Neighbours(const ExactSurface& surface) : surface_(surface) {
    for (const auto& [a, b, c] : surface.triangles) {
      sides_.insert(sides_.end(), {{a, b, c}, {b, c, a}, {c, a, b}});
    }
    std::ranges::sort(sides_, {}, &Side::ends);
  }
  /// True if the triangle beyond the side is coplanar with the one before it, and on the other side
  /// of it. False where the surface touches itself.
  bool is_flat_across(std::uint32_t from, std::uint32_t to) const {
    const auto before = sides(from, to), beyond = sides(to, from);
    if (before.size() != 1 || beyond.size() != 1) return false;
    const ExactPoint &a = surface_.points[from], &b = surface_.points[to];
    const ExactPoint& here = surface_.points[before[0].apex];
    const ExactPoint& there = surface_.points[beyond[0].apex];
    return CGAL::coplanar(a, b, here, there) &&
           CGAL::coplanar_orientation(a, b, here, there) == CGAL::NEGATIVE;
  }

 private:
  struct Side {
    std::uint32_t from, to, apex;
    std::pair<std::uint32_t, std::uint32_t> ends() const { return {from, to}; }
  };
  std::span<const Side> sides(std::uint32_t from, std::uint32_t to) const {
    const std::pair ends(from, to);
    return {std::ranges::lower_bound(sides_, ends, {}, &Side::ends),
            std::ranges::upper_bound(sides_, ends, {}, &Side::ends)};
  }

  const ExactSurface& surface_;
  std::vector<Side> sides_;
};

/// The ends of the sides along which triangles of different sources meet, each side once.
std::vector<std::array<std::uint32_t, 2>> boundaries_of(const ExactSurface& surface) {
  struct Use {
    std::uint32_t low, high, source;
    int way;
    auto key() const { return std::tuple(low, high, source); }
  };
  std::vector<Use> uses;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    std::uint32_t from = surface.triangles[i][2];
    for (const std::uint32_t to : surface.triangles[i]) {
      uses.push_back(
          {std::min(from, to), std::max(from, to), surface.sources[i], from < to ? 1 : -1});
      from = to;
    }
  }
  std::ranges::sort(uses, {}, &Use::key);
  std::vector<std::array<std::uint32_t, 2>> boundaries;
  for (std::size_t i = 0; i < uses.size();) {
    const auto key = uses[i].key();
    int ways = 0;
    for (; i < uses.size() && uses[i].key() == key; ++i) ways += uses[i].way;
    const std::array ends{std::get<0>(key), std::get<1>(key)};
    if (ways != 0 && (boundaries.empty() || boundaries.back() != ends)) boundaries.push_back(ends);
  }
  return boundaries;
}

/// The largest magnitude of a coordinate.
double largest_of(const ExactSurface& surface) {
  double largest = 0.0;
  for (const ExactPoint& p : surface.points) {
    for (int axis = 0; axis < 3; ++axis) {
      largest = std::max(largest, std::abs(CGAL::to_double(p[axis])));
    }
  }
  return largest;
}

/// True if the foot of the perpendicular from v to the segment from p to q is between these, and v
/// is within reach of it.
bool is_between(const ExactPoint& v, const ExactPoint& p, const ExactPoint& q, double reach) {
  const auto in_doubles = [](const ExactPoint& from, const ExactPoint& to) {
    return Point3(CGAL::to_double(to.x() - from.x()), CGAL::to_double(to.y() - from.y()),
                  CGAL::to_double(to.z() - from.z()));
  };
  const Point3 along = in_doubles(p, q), to_v = in_doubles(p, v), from_v = in_doubles(v, q);
  return glm::dot(to_v, along) > 0.0 && glm::dot(from_v, along) > 0.0 &&
         glm::length(glm::cross(along, to_v)) <= reach * glm::length(along);
}

/// For each vertex, whether it lies between the other ends of its two boundaries; false if it has
/// not two.
std::vector<std::uint8_t> vertices_between(const ExactSurface& surface, double reach) {
  struct Ends {
    std::size_t count = 0;
    std::array<std::uint32_t, 2> other{};
  };
  std::vector<Ends> at(surface.points.size());
  const auto note = [&](std::uint32_t v, std::uint32_t other) {
    if (at[v].count < 2) at[v].other[at[v].count] = other;
    ++at[v].count;
  };
  for (const auto& [a, b] : boundaries_of(surface)) {
    note(a, b);
    note(b, a);
  }
  std::vector<std::uint8_t> between(surface.points.size(), 0);
  for (std::size_t v = 0; v < at.size(); ++v) {
    if (at[v].count != 2) continue;
    const auto& [p, q] = at[v].other;
    const bool is_there =
        is_between(surface.points[v], surface.points[p], surface.points[q], reach);
    between[v] = is_there ? 1 : 0;
  }
  return between;
}

}  // namespace

// ---- The module
// ----------------------------------------------------------------------------------

/// A mesh, unless it touches itself: then the surface.
struct ExactSolid::Body {
  ExactMesh mesh;
  ExactSurface surface;

  bool has_mesh() const { return mesh.number_of_faces() > 0; }
  bool is_empty() const { return !has_mesh() && surface.triangles.empty(); }
  ExactSurface as_surface() const {
    if (!has_mesh()) return surface;
    ExactMesh copy = mesh;  // properties of a const mesh are not found by name
    return surface_of(copy);
  }
};

namespace {

using Body = ExactSolid::Body;

std::shared_ptr<const Body> bounded(const BoundingTriangles& triangles, std::string_view name) {
  std::vector<ExactPoint> points;
  points.reserve(triangles.vertices.size());
  for (const Point3& p : triangles.vertices) points.emplace_back(p.x, p.y, p.z);
  std::vector<std::array<std::size_t, 3>> soup;
  soup.reserve(triangles.triangles.size());
  for (const auto& [a, b, c] : triangles.triangles) soup.push_back({a, b, c});
  draw_the_same_lots();
  // Duplicates vertices and edges where surfaces touch, which require_simple refuses.
  PMP::orient_polygon_soup(points, soup);
  auto body = std::make_shared<Body>();
  ExactMesh& mesh = body->mesh;
  if (PMP::is_polygon_soup_a_polygon_mesh(soup))
    PMP::polygon_soup_to_polygon_mesh(points, soup, mesh);
  if (mesh.is_empty() || !CGAL::is_closed(mesh)) {
    throw std::runtime_error(
        fmt::format("{} is not closed: expected a surface that bounds a solid", name));
  }
  Sources sources = sources_of(mesh);
  for (const Face face : mesh.faces()) sources[face] = triangles.source[face.idx()];
  require_simple(mesh, name);
  PMP::orient_to_bound_a_volume(mesh);
  return body;
}

/// Combines meshes that do not touch themselves, by CGAL's corefinement. Nothing if the result
/// touches itself along an edge, which CGAL does not support. The result may touch itself in
/// points, where it is not a valid mesh.
std::optional<ExactMesh> corefined(SolidOperation operation, ExactMesh first, ExactMesh second,
                                   CombiningSteps& steps) {
  draw_the_same_lots();
  ExactMesh result;
  std::array<SourcesFollow::Of, 3> of{
      {{&first, sources_of(first)}, {&second, sources_of(second)}, {&result, sources_of(result)}}};
  SourcesFollow follow;
  follow.of = &of;
  follow.steps = &steps;
  const auto parameters = CGAL::parameters::visitor(follow);
  bool done = false;
  switch (operation) {
    case SolidOperation::unite:
      done = PMP::corefine_and_compute_union(first, second, result, parameters);
      break;
    case SolidOperation::intersect:
      done = PMP::corefine_and_compute_intersection(first, second, result, parameters);
      break;
    case SolidOperation::difference:
      done = PMP::corefine_and_compute_difference(first, second, result, parameters);
      break;
  }
  if (!done) return std::nullopt;
  return result;
}

Body body_of(ExactSurface surface) {
  if (auto mesh = mesh_of(surface)) return {std::move(*mesh), {}};
  return {{}, std::move(surface)};
}

Body body_of(ExactMesh mesh) {
  ExactSurface surface = surface_of(mesh);
  const bool touches_itself = merge_points(surface) || !has_manifold_vertices(mesh);
  if (touches_itself) return {{}, std::move(surface)};
  return {std::move(mesh), {}};
}

Body combined_body(SolidOperation operation, const Body& a, const Body& b, CombiningSteps& steps) {
  if (a.has_mesh() && b.has_mesh()) {
    if (auto mesh = corefined(operation, a.mesh, b.mesh, steps)) {
      if (mesh->number_of_faces() == 0) return {};
      if (CGAL::is_closed(*mesh)) return body_of(std::move(*mesh));
    }
  }
  return body_of(combined_by_arrangement(operation, a.as_surface(), b.as_surface(), steps));
}

std::shared_ptr<const Body> combined(SolidOperation operation, const Body& a, const Body& b,
                                     CombiningSteps& steps) {
  return std::make_shared<const Body>(combined_body(operation, a, b, steps));
}

bool is_empty(const Body& body) { return body.is_empty(); }

BoundingTriangles rounded(const Body& body, double (*reach_of)(double largest)) {
  const ExactSurface surface = body.as_surface();
  const Neighbours neighbours(surface);
  BoundingTriangles result;
  for (const ExactPoint& p : surface.points) {
    result.vertices.emplace_back(nearest(p.x()), nearest(p.y()), nearest(p.z()));
  }
  result.triangles = surface.triangles;
  result.source = surface.sources;
  result.is_between = vertices_between(surface, reach_of(largest_of(surface)));
  for (const auto& triangle : surface.triangles) {
    auto& flat = result.is_flat.emplace_back();
    std::uint32_t from = triangle[2];
    for (std::size_t k = 0; k < 3; ++k) {
      flat[k] = neighbours.is_flat_across(from, triangle[k]) ? 1 : 0;
      from = triangle[k];
    }
  }
  return result;
}

}  // namespace

}  // namespace displayfile

extern "C" __attribute__((visibility("default"))) const void* displayfile_module() {
  using namespace displayfile;
  static constexpr SolidsModule kModule{DISPLAYFILE_MODULE_VERSION, bounded, combined, is_empty,
                                        rounded};
  return &kModule;
}
