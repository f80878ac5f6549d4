#include "displayfile/mesh/solid_triangles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "clip/base/error.h"
#include "clip/geometry/equal_points.h"
#include "displayfile/mesh/joined_objects.h"
#include "displayfile/mesh/turned_shells.h"
#include "displayfile/mesh/welded_faces.h"
#include "hidden/triangles/triangulation.h"

namespace displayfile {

namespace {

using SolidObject = SolidTriangles::Object;
using CornersOfTriangle = SolidTriangles::Triangle;

/// The number of unpaired sides: for each pair of ends, the sides in one direction less those in
/// the other.
std::size_t open_sides_of(const std::vector<CornersOfTriangle>& triangles) {
  std::vector<std::tuple<std::uint32_t, std::uint32_t, int>> sides;
  sides.reserve(3 * triangles.size());
  for (const CornersOfTriangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = t[k], to = t[(k + 1) % 3];
      sides.emplace_back(std::min(from, to), std::max(from, to), from < to ? 1 : -1);
    }
  }
  std::ranges::sort(sides);
  std::size_t open = 0;
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    const auto [low, high, way] = sides[first];
    int sum = 0;
    for (;
         last < sides.size() && std::get<0>(sides[last]) == low && std::get<1>(sides[last]) == high;
         ++last) {
      sum += std::get<2>(sides[last]);
    }
    open += static_cast<std::size_t>(std::abs(sum));
  }
  return open;
}

/// Triangulates faces; `first_face` is the number of the first one in the mesh.
SolidObject triangles_of_faces(const WeldedFaces& faces, const Mesh& mesh, std::size_t first_face) {
  SolidObject object;
  object.vertices = faces.vertices;
  Triangulation triangulation;
  std::vector<Point3> polygon;
  for (std::size_t i = 0; i < faces.faces(); ++i) {
    const auto face = faces.face(i);
    polygon.clear();
    for (const std::uint32_t v : face) polygon.push_back(faces.vertices[v]);
    const std::uint32_t colour = mesh.face_materials.empty() ? SolidTriangles::kNoColour
                                                             : mesh.face_materials[first_face + i];
    const std::size_t before = object.triangles.size();
    for (const auto& triangle : triangulation.triangulate(polygon)) {
      const CornersOfTriangle t{face[triangle.vertex[0]], face[triangle.vertex[1]],
                                face[triangle.vertex[2]]};
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;  // two sides coincide
      object.triangles.push_back(t);
      object.colours.push_back(colour);
    }
    if (object.triangles.size() == before) ++object.faces_without_area;
    if (triangulation.crosses_itself()) ++object.crossing_faces;
  }
  object.open_sides = open_sides_of(object.triangles);
  return object;
}

/// Triangulates the faces with corners added where vertices are on their sides.
SolidObject closed_triangles(const WeldedFaces& faces, const Mesh& mesh, std::size_t first_face,
                             double reach) {
  const SidesWithVertices sides(faces, reach);
  if (!sides.any()) return triangles_of_faces(faces, mesh, first_face);
  return triangles_of_faces(FacesWithCorners(faces, sides).faces(), mesh, first_face);
}

/// The objects of the welded faces.
std::vector<SolidObject> each_object(const Mesh& mesh, const WeldedFaces& all, double reach) {
  std::vector<SolidObject> objects;
  WeldedObjects faces_of(all);
  for (const Mesh::Object& object : mesh.objects) {
    objects.push_back(closed_triangles(faces_of(object), mesh, object.first_face, reach));
    objects.back().name = object.name;
  }
  return objects;
}

bool is_open(const SolidObject& object) { return object.open_sides > 0; }

/// Joins groups of open objects that are closed together: the first takes in the triangles of all,
/// and nothing is left of the others.
void join_open(const Mesh& mesh, double reach, std::vector<SolidObject>& objects) {
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    if (is_open(objects[k])) open.push_back(k);
  }
  if (open.size() < 2) return;
  for (const std::vector<std::size_t>& group : objects_that_meet(mesh, open, reach)) {
    const Mesh part = mesh_of_objects(mesh, group);
    SolidObject together = closed_triangles(weld(part, reach), part, 0, reach);
    if (is_open(together)) continue;
    for (const std::size_t k : group) objects[k].triangles.clear();
    together.name = mesh.objects[group.front()].name;
    for (const std::size_t k : group) objects[k].faces_without_area = 0;
    objects[group.front()] = std::move(together);
  }
}

/// Removes the vertices that no triangle uses.
void keep_used(SolidObject& object) {
  std::vector<std::uint32_t> number(object.vertices.size(), SolidTriangles::kNoColour);
  std::vector<Point3> used;
  for (CornersOfTriangle& t : object.triangles) {
    for (std::uint32_t& v : t) {
      if (number[v] == SolidTriangles::kNoColour) {
        number[v] = static_cast<std::uint32_t>(used.size());
        used.push_back(object.vertices[v]);
      }
      v = number[v];
    }
  }
  object.vertices = std::move(used);
}

/// Merges equal colours, in all triangles.
void share_colours(const Mesh& mesh, SolidTriangles& solid) {
  std::map<std::tuple<double, double, double>, std::uint32_t> known;
  std::vector<std::uint32_t> number;
  for (const Mesh::Material& material : mesh.materials) {
    if (!material.colour) {
      number.push_back(SolidTriangles::kNoColour);
      continue;
    }
    const Colour& c = *material.colour;
    const auto next = static_cast<std::uint32_t>(solid.colours.size());
    const auto [at, is_new] = known.try_emplace({c.r, c.g, c.b}, next);
    if (is_new) solid.colours.push_back(c);
    number.push_back(at->second);
  }
  for (SolidObject& object : solid.objects) {
    for (std::uint32_t& colour : object.colours) {
      if (colour != SolidTriangles::kNoColour) colour = number[colour];
    }
  }
}

/// Must not be inlined: GCC 12 drops the conversion where it vectorizes several of them.
[[gnu::noinline]] double as_single(double v) {
  const auto rounded = static_cast<double>(static_cast<float>(v));
  return rounded == 0.0 ? 0.0 : rounded;  // not -0
}

}  // namespace

std::size_t SolidTriangles::triangles() const {
  std::size_t count = 0;
  for (const SolidObject& object : objects) count += object.triangles.size();
  return count;
}

SolidTriangles solid_triangles(const Mesh& mesh) {
  const double reach = entered_reach(mesh);
  SolidTriangles solid;
  solid.objects = each_object(mesh, weld(mesh), reach);
  if (std::ranges::any_of(solid.objects, is_open)) {
    std::vector<SolidObject> others = each_object(mesh, weld(mesh, reach), reach);
    for (std::size_t k = 0; k < others.size(); ++k) {
      if (others[k].open_sides < solid.objects[k].open_sides) {
        solid.objects[k] = std::move(others[k]);
      }
    }
    join_open(mesh, reach, solid.objects);
  }
  for (SolidObject& object : solid.objects) {
    solid.faces_without_area += object.faces_without_area;
    turn_shells_out(object);
    keep_used(object);
  }
  std::erase_if(solid.objects, [](const SolidObject& object) { return object.triangles.empty(); });
  share_colours(mesh, solid);
  return solid;
}

SingleTriangles in_single_precision(const SolidTriangles& solid) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  SingleTriangles single;
  single.solid.colours = solid.colours;
  for (const SolidObject& object : solid.objects) {
    SolidObject rounded;
    rounded.name = object.name;
    rounded.crossing_faces = object.crossing_faces;
    EqualPoints table(rounded.vertices, object.vertices.size());
    std::vector<std::uint32_t> number;
    for (const Point3& p : object.vertices) {
      const double farthest = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
      if (!(farthest <= kLargest)) {
        throw Error(fmt::format("a coordinate of {} is too large for single precision", farthest));
      }
      number.push_back(table.number_of({as_single(p.x), as_single(p.y), as_single(p.z)}));
    }
    single.merged += object.vertices.size() - rounded.vertices.size();
    for (std::size_t i = 0; i < object.triangles.size(); ++i) {
      const auto& [a, b, c] = object.triangles[i];
      const CornersOfTriangle t{number[a], number[b], number[c]};
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
        ++single.left_out;
        continue;
      }
      rounded.triangles.push_back(t);
      rounded.colours.push_back(object.colours[i]);
    }
    rounded.open_sides = open_sides_of(rounded.triangles);
    if (rounded.triangles.empty()) {
      throw Error(fmt::format("{} is too small for single precision: nothing would be left of it",
                              object.name));
    }
    single.solid.objects.push_back(std::move(rounded));
  }
  return single;
}

}  // namespace displayfile
