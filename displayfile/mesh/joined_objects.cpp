#include "displayfile/mesh/joined_objects.h"

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <utility>

#include "displayfile/mesh/welded_faces.h"
#include "hidden/disjoint_sets.h"

namespace displayfile {

namespace {

/// A side of a face, and the place of its object in the mesh of the objects.
struct SideOfObject {
  std::uint32_t low, high, object;
  int way;
  auto place() const { return std::tie(low, high, object); }
  bool has_ends_of(const SideOfObject& other) const {
    return low == other.low && high == other.high;
  }
};

std::vector<SideOfObject> sides_of(const WeldedFaces& faces, const Mesh& mesh) {
  std::vector<SideOfObject> sides;
  sides.reserve(faces.corners.size());
  for (std::uint32_t k = 0; k < mesh.objects.size(); ++k) {
    const auto& [name, first_face, count] = mesh.objects[k];
    for (std::size_t i = first_face; i < first_face + count; ++i) {
      std::uint32_t from = faces.face(i).back();
      for (const std::uint32_t to : faces.face(i)) {
        if (from != to) {
          sides.push_back({std::min(from, to), std::max(from, to), k, from < to ? 1 : -1});
        }
        from = to;
      }
    }
  }
  return sides;
}

/// Joins the objects that have the same side open.
void join_by_open_sides(std::vector<SideOfObject> sides, DisjointSets& groups) {
  std::ranges::sort(sides, {}, &SideOfObject::place);
  const SideOfObject* open = nullptr;  // the last one
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    int sum = 0;
    for (; last < sides.size() && sides[last].place() == sides[first].place(); ++last) {
      sum += sides[last].way;
    }
    if (sum == 0) continue;
    if (open != nullptr && open->has_ends_of(sides[first])) {
      groups.join(open->object, sides[first].object);
    }
    open = &sides[first];
  }
}

}  // namespace

Mesh mesh_of_objects(const Mesh& mesh, std::span<const std::size_t> objects) {
  Mesh part;
  part.materials = mesh.materials;
  part.first_corner.push_back(0);
  for (const std::size_t k : objects) {
    const Mesh::Object& object = mesh.objects[k];
    part.objects.push_back({object.name, part.faces(), object.faces});
    for (std::size_t i = object.first_face; i < object.first_face + object.faces; ++i) {
      const auto face = mesh.face(i);
      part.corners.insert(part.corners.end(), face.begin(), face.end());
      part.first_corner.push_back(part.corners.size());
      if (!mesh.face_materials.empty()) part.face_materials.push_back(mesh.face_materials[i]);
    }
  }
  std::vector<std::uint32_t> used = part.corners;
  std::ranges::sort(used);
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (const std::uint32_t v : used) part.vertices.push_back(mesh.vertices[v]);
  for (std::uint32_t& corner : part.corners) {
    corner = static_cast<std::uint32_t>(std::ranges::lower_bound(used, corner) - used.begin());
  }
  return part;
}

std::vector<std::vector<std::size_t>> objects_that_meet(const Mesh& mesh,
                                                        std::span<const std::size_t> objects,
                                                        double reach) {
  const Mesh part = mesh_of_objects(mesh, objects);
  const WeldedFaces welded = weld(part, reach);
  const SidesWithVertices along(welded, reach);
  DisjointSets sets(objects.size());
  if (along.any()) {
    join_by_open_sides(sides_of(FacesWithCorners(welded, along).faces(), part), sets);
  } else {
    join_by_open_sides(sides_of(welded, part), sets);
  }
  std::vector<std::vector<std::size_t>> groups(objects.size());
  for (std::uint32_t k = 0; k < objects.size(); ++k) groups[sets.name(k)].push_back(objects[k]);
  std::erase_if(groups, [](const auto& group) { return group.size() < 2; });
  return groups;
}

}  // namespace displayfile
