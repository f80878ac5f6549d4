// Solids combined by CGAL. Nothing else includes it, and nothing here is seen from outside.

#include "displayfile/solids/exact_solid.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <iterator>
#include <new>
#include <string>
#include <utility>

#include "clip/error.h"

namespace displayfile {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactPoint = Kernel::Point_3;
using ExactMesh = CGAL::Surface_mesh<ExactPoint>;
using Face = ExactMesh::Face_index;
using Sources = ExactMesh::Property_map<Face, std::uint32_t>;

constexpr const char* kSource = "f:displayfile:source";

Sources sources_of(ExactMesh& mesh) {
  return mesh.add_property_map<Face, std::uint32_t>(kSource, 0).first;
}

/// Hands each face's source on to what it is cut into, and to the result.
struct SourcesFollow : PMP::Corefinement::Default_visitor<ExactMesh> {
  struct Of {
    const ExactMesh* mesh;
    Sources sources;
  };
  std::array<Of, 3>* of = nullptr;
  std::uint32_t cut = 0;

  Sources& sources(const ExactMesh& mesh) const {
    return std::ranges::find(*of, &mesh, &Of::mesh)->sources;
  }
  void before_subface_creations(Face face, ExactMesh& mesh) { cut = sources(mesh)[face]; }
  void after_subface_created(Face face, ExactMesh& mesh) { sources(mesh)[face] = cut; }
  void after_face_copy(Face from, const ExactMesh& mesh, Face to, ExactMesh& into) {
    sources(into)[to] = sources(mesh)[from];
  }
};

/// The library draws lots, from a seed that is the time unless this is called: how a face is cut
/// into triangles would not be the same each time.
void draw_the_same_lots() { CGAL::get_default_random() = CGAL::Random(1); }

/// A point of a mesh, for a message.
std::string in_words(const ExactPoint& p) {
  return fmt::format("{:.6g} {:.6g} {:.6g}", CGAL::to_double(p.x()), CGAL::to_double(p.y()),
                     CGAL::to_double(p.z()));
}

void require_simple(const ExactMesh& mesh, std::string_view name) {
  for (const Face face : mesh.faces()) {
    if (!PMP::is_degenerate_triangle_face(face, mesh)) continue;
    throw Error(fmt::format("{} has a triangle of no area at {}: expected none", name,
                            in_words(mesh.point(mesh.target(mesh.halfedge(face))))));
  }
  std::vector<std::pair<Face, Face>> crossing;
  PMP::self_intersections<CGAL::Sequential_tag>(mesh, std::back_inserter(crossing));
  if (crossing.empty()) return;
  throw Error(fmt::format(
      "{} passes through itself near {}: expected a surface that does not", name,
      in_words(mesh.point(mesh.target(mesh.halfedge(std::ranges::min(crossing).first))))));
}

/// The nearest double, or the one next to it.
double nearest(const Kernel::FT& exact) { return CGAL::to_double(CGAL::exact(exact)); }

/// Whether the triangle beyond the half-edge lies in the plane of the one before it, and on its
/// other side.
bool is_flat_across(const ExactMesh& mesh, ExactMesh::Halfedge_index edge) {
  const auto opposite = mesh.opposite(edge);
  const ExactPoint &a = mesh.point(mesh.source(edge)), &b = mesh.point(mesh.target(edge));
  const ExactPoint& here = mesh.point(mesh.target(mesh.next(edge)));
  const ExactPoint& there = mesh.point(mesh.target(mesh.next(opposite)));
  return CGAL::coplanar(a, b, here, there) &&
         CGAL::coplanar_orientation(a, b, here, there) == CGAL::NEGATIVE;
}

}  // namespace

struct ExactSolid::Body {
  ExactMesh mesh;
};

ExactSolid::ExactSolid(const BoundingTriangles& triangles, std::string_view name) {
  std::vector<ExactPoint> points;
  points.reserve(triangles.vertices.size());
  for (const Point3& p : triangles.vertices) points.emplace_back(p.x, p.y, p.z);
  std::vector<std::array<std::size_t, 3>> soup;
  soup.reserve(triangles.triangles.size());
  for (const auto& [a, b, c] : triangles.triangles) soup.push_back({a, b, c});
  draw_the_same_lots();
  // Where surfaces touch at a vertex or an edge it is made several.
  PMP::orient_polygon_soup(points, soup);
  auto body = std::make_shared<Body>();
  ExactMesh& mesh = body->mesh;
  if (PMP::is_polygon_soup_a_polygon_mesh(soup))
    PMP::polygon_soup_to_polygon_mesh(points, soup, mesh);
  if (mesh.is_empty() || !CGAL::is_closed(mesh)) {
    throw Error(fmt::format("{} is not closed: expected a surface that bounds a solid", name));
  }
  Sources sources = sources_of(mesh);
  for (const Face face : mesh.faces()) sources[face] = triangles.source[face.idx()];
  require_simple(mesh, name);
  PMP::orient_to_bound_a_volume(mesh);
  body_ = std::move(body);
}

ExactSolid ExactSolid::combined(SolidOperation operation, const ExactSolid& a, const ExactSolid& b,
                                std::string_view name) {
  if (a.is_empty() || b.is_empty()) {
    const bool gone = operation == SolidOperation::intersect ||
                      (operation == SolidOperation::difference && a.is_empty());
    if (gone) return ExactSolid(std::make_shared<Body>());
    return a.is_empty() ? b : a;
  }
  draw_the_same_lots();
  ExactMesh first = a.body_->mesh, second = b.body_->mesh;  // both are cut
  auto body = std::make_shared<Body>();
  std::array<SourcesFollow::Of, 3> of{{{&first, sources_of(first)},
                                       {&second, sources_of(second)},
                                       {&body->mesh, sources_of(body->mesh)}}};
  SourcesFollow follow;
  follow.of = &of;
  const auto parameters = CGAL::parameters::visitor(follow);
  bool done = false;
  try {
    switch (operation) {
      case SolidOperation::unite:
        done = PMP::corefine_and_compute_union(first, second, body->mesh, parameters);
        break;
      case SolidOperation::intersect:
        done = PMP::corefine_and_compute_intersection(first, second, body->mesh, parameters);
        break;
      case SolidOperation::difference:
        done = PMP::corefine_and_compute_difference(first, second, body->mesh, parameters);
        break;
    }
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw Error(
        fmt::format("the {} with {} was not found: {}", name_of(operation), name, error.what()));
  }
  if (!done) {
    throw Error(
        fmt::format("the {} with {} touches itself along an edge, or in a point: expected a solid; "
                    "move or size "
                    "a part a little",
                    name_of(operation), name));
  }
  return ExactSolid(std::move(body));
}

bool ExactSolid::is_empty() const { return body_->mesh.number_of_faces() == 0; }

BoundingTriangles ExactSolid::rounded() const {
  ExactMesh mesh = body_->mesh;
  const Sources sources = sources_of(mesh);
  BoundingTriangles result;
  std::vector<std::uint32_t> number(mesh.num_vertices(), 0);
  for (const auto vertex : mesh.vertices()) {
    const ExactPoint& p = mesh.point(vertex);
    number[vertex.idx()] = static_cast<std::uint32_t>(result.vertices.size());
    result.vertices.emplace_back(nearest(p.x()), nearest(p.y()), nearest(p.z()));
  }
  for (const Face face : mesh.faces()) {
    std::array<std::uint32_t, 3> triangle{};
    std::array<std::uint8_t, 3> flat{};
    auto edge = mesh.halfedge(face);
    for (std::size_t k = 0; k < 3; ++k, edge = mesh.next(edge)) {
      triangle[k] = number[mesh.target(edge).idx()];
      flat[k] = is_flat_across(mesh, edge) ? 1 : 0;
    }
    result.triangles.push_back(triangle);
    result.source.push_back(sources[face]);
    result.is_flat.push_back(flat);
  }
  return result;
}

}  // namespace displayfile
