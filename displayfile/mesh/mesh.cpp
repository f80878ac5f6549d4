#include "displayfile/mesh/mesh.h"

#include <fmt/format.h>

#include <assimp/config.h>
#include <assimp/scene.h>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <new>
#include <numeric>
#include <utility>

#include "clip/back_face.h"
#include "clip/error.h"
#include "displayfile/mesh/fitted_view.h"
#include "displayfile/mesh/mesh_file_check.h"
#include "hidden/disjoint_sets.h"

namespace displayfile {

namespace {

// ---- Reading ---------------------------------------------------------------------------

const aiScene& import_scene(Assimp::Importer& importer, const std::string& path) {
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  const aiScene* scene = importer.ReadFile(path, 0);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    throw Error(
        fmt::format("{}: not a mesh that can be read: {}", path, importer.GetErrorString()));
  }
  return *scene;
}

glm::dmat4 matrix(const aiMatrix4x4& m) {
  glm::dmat4 result(1.0);  // [column][row]
  for (unsigned row = 0; row < 4; ++row) {
    for (unsigned column = 0; column < 4; ++column) {
      result[static_cast<int>(column)][static_cast<int>(row)] = m[row][column];
    }
  }
  return result;
}

struct Node {
  const aiNode* node;
  glm::dmat4 to_world;
};

/// The nodes in the order of the file, parents first.
std::vector<Node> nodes_in_order(const aiScene& scene) {
  std::vector<Node> order, waiting{{scene.mRootNode, matrix(scene.mRootNode->mTransformation)}};
  while (!waiting.empty()) {
    const Node next = waiting.back();
    waiting.pop_back();
    order.push_back(next);
    for (unsigned i = next.node->mNumChildren; i-- > 0;) {
      const aiNode* child = next.node->mChildren[i];
      if (child == nullptr) continue;  // the RAW importer leaves gaps
      waiting.push_back({child, next.to_world * matrix(child->mTransformation)});
    }
  }
  return order;
}

/// True if the corners have at least three different positions.
bool has_three_positions(const std::vector<Point3>& vertices,
                         std::span<const std::uint32_t> corners) {
  const Point3& first = vertices[corners[0]];
  const Point3* second = nullptr;
  for (const std::uint32_t corner : corners) {
    const Point3& p = vertices[corner];
    if (p == first) continue;
    if (second == nullptr) {
      second = &p;
    } else if (p != *second) {
      return true;
    }
  }
  return false;
}

/// Copies the scene's meshes into a Mesh, checking every number on the way.
class MeshBuilder {
 public:
  MeshBuilder(const std::string& path, bool with_normals)
      : path_(path), with_normals_(with_normals) {
    mesh_.first_corner = {0};
  }

  void add(const aiScene& scene, const Node& node) {
    Mesh::Object object{node.node->mName.C_Str(), mesh_.faces(), 0};
    for (unsigned i = 0; i < node.node->mNumMeshes; ++i) {
      const unsigned m = node.node->mMeshes[i];
      if (m >= scene.mNumMeshes) {
        fail(object, fmt::format("mesh {}: expected one of {}", m, scene.mNumMeshes));
      }
      add_part(object, *scene.mMeshes[m], node.to_world);
    }
    object.faces = mesh_.faces() - object.first_face;
    if (object.faces > 0) mesh_.objects.push_back(std::move(object));
  }

  Mesh take() && {
    if (mesh_.faces() == 0) {
      throw Error(
          fmt::format("{}: no faces: expected polygons (found {} points and lines, and {} faces of "
                      "fewer than 3 "
                      "different vertices)",
                      path_, mesh_.skipped.points_and_lines, mesh_.skipped.degenerate_faces));
    }
    return std::move(mesh_);
  }

 private:
  void add_part(const Mesh::Object& object, const aiMesh& part, const glm::dmat4& to_world) {
    const std::size_t first_vertex = mesh_.vertices.size();
    if (first_vertex + part.mNumVertices > std::numeric_limits<std::uint32_t>::max()) {
      fail(object, "more than 4294967295 vertices");
    }
    add_vertices(object, part, to_world);
    if (with_normals_) add_normals(part, glm::dmat3(to_world));
    const bool mirrored = glm::determinant(glm::dmat3(to_world)) < 0.0;
    for (unsigned i = 0; i < part.mNumFaces; ++i) {
      const std::span indices(part.mFaces[i].mIndices, part.mFaces[i].mNumIndices);
      for (const unsigned index : indices) {
        if (index >= part.mNumVertices) {
          fail(object, fmt::format("face {}: vertex index {} out of range: expected 0 to {}", i,
                                   index, part.mNumVertices - 1.0));
        }
      }
      add_face(indices, first_vertex, mirrored);
    }
  }

  void add_vertices(const Mesh::Object& object, const aiMesh& part, const glm::dmat4& to_world) {
    const bool moved = to_world != glm::dmat4(1.0);
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
      const aiVector3D& v = part.mVertices[i];
      Point3 p(v.x, v.y, v.z);
      if (moved) p = Point3(to_world * HomogeneousPoint(p, 1.0));
      if (!in_range(p)) {
        fail(object, fmt::format("vertex {} is ({}, {}, {}): expected finite coordinates", i, p.x,
                                 p.y, p.z));
      }
      mesh_.vertices.push_back(p);
    }
  }

  /// They stay outward when the node's transformation mirrors, as the faces do.
  void add_normals(const aiMesh& part, const glm::dmat3& m) {
    const double outward = glm::determinant(m) < 0.0 ? -1.0 : 1.0;
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]),
                               glm::cross(m[0], m[1]));
    mesh_.normals.resize(mesh_.vertices.size(), Point3(0.0));
    if (!part.HasNormals()) return;
    const std::size_t first = mesh_.vertices.size() - part.mNumVertices;
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
      const aiVector3D& n = part.mNormals[i];
      const Point3 normal = outward * (cofactors * Point3(n.x, n.y, n.z));
      if (in_range(normal)) mesh_.normals[first + i] = normal;
    }
  }

  void add_face(std::span<const unsigned> indices, std::size_t first_vertex, bool mirrored) {
    if (indices.size() < 3) {
      ++mesh_.skipped.points_and_lines;
      return;
    }
    const std::size_t start = mesh_.corners.size();
    for (const unsigned index : indices) {
      mesh_.corners.push_back(static_cast<std::uint32_t>(first_vertex + index));
    }
    const std::span face = std::span(mesh_.corners).subspan(start);
    if (mirrored) std::ranges::reverse(face);
    if (has_three_positions(mesh_.vertices, face)) {
      mesh_.first_corner.push_back(mesh_.corners.size());
    } else {
      mesh_.corners.resize(start);
      ++mesh_.skipped.degenerate_faces;
    }
  }

  [[noreturn]] void fail(const Mesh::Object& object, const std::string& what) const {
    throw Error(fmt::format("{}: object '{}': {}", path_, object.name, what));
  }

  const std::string& path_;
  bool with_normals_;
  Mesh mesh_;
};

bool is_stl(const std::string& path) {
  constexpr std::string_view kStl = ".stl";
  const auto lower = [](char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c | 32 : c); };
  return path.size() >= kStl.size() &&
         std::ranges::equal(std::string_view(path).substr(path.size() - kStl.size()), kStl, {},
                            lower);
}

Mesh read_checked(const std::string& path, bool with_normals) {
  Assimp::Importer importer;
  const aiScene& scene = import_scene(importer, path);
  MeshBuilder builder(path, with_normals && !is_stl(path));
  for (const Node& node : nodes_in_order(scene)) builder.add(scene, node);
  return std::move(builder).take();
}

// ---- Topology --------------------------------------------------------------------------

/// Some faces of a mesh, their vertices of equal position made one.
struct WeldedFaces {
  std::vector<Point3> vertices;
  std::vector<std::uint32_t> corners;
  std::span<const std::size_t> first_corner;  ///< of each face; one more at the end

  std::size_t faces() const { return first_corner.size() - 1; }
  std::span<const std::uint32_t> face(std::size_t i) const {
    return std::span(corners).subspan(first_corner[i] - first_corner[0],
                                      first_corner[i + 1] - first_corner[i]);
  }
};

std::uint64_t hash(const Point3& p) {
  constexpr std::uint64_t odd = 0x9E3779B97F4A7C15u;  // 2^64 over the golden ratio
  std::uint64_t h = 0;
  for (int axis = 0; axis < 3; ++axis) {
    h = (h ^ std::bit_cast<std::uint64_t>(p[axis] + 0.0)) * odd;  // -0 is 0
    h ^= h >> 32;
  }
  return h;
}

WeldedFaces weld(const Mesh& mesh, std::size_t first_face, std::size_t end_face) {
  constexpr std::uint32_t empty = std::numeric_limits<std::uint32_t>::max();
  WeldedFaces welded;
  welded.first_corner = std::span(mesh.first_corner).subspan(first_face, end_face - first_face + 1);
  const std::size_t start = welded.first_corner.front();
  const std::size_t corners = welded.first_corner.back() - start;
  std::vector<std::uint32_t> table(std::bit_ceil(2 * corners), empty);  // open addressing
  welded.corners.reserve(corners);
  for (const std::uint32_t corner : std::span(mesh.corners).subspan(start, corners)) {
    const Point3& p = mesh.vertices[corner];
    std::size_t slot = hash(p) & (table.size() - 1);
    while (table[slot] != empty && welded.vertices[table[slot]] != p) {
      slot = (slot + 1) & (table.size() - 1);
    }
    if (table[slot] == empty) {
      table[slot] = static_cast<std::uint32_t>(welded.vertices.size());
      welded.vertices.push_back(p);
    }
    welded.corners.push_back(table[slot]);
  }
  return welded;
}

/// Calls visit(from, to) for every edge of every face, but for those of no length.
template <class Visitor>
void for_each_edge(const WeldedFaces& faces, Visitor&& visit) {
  for (std::size_t i = 0; i < faces.faces(); ++i) {
    std::uint32_t from = faces.face(i).back();
    for (const std::uint32_t to : faces.face(i)) {
      if (from != to) visit(from, to);
      from = to;
    }
  }
}

/// True if every edge is used exactly twice, once in each direction.
bool edges_pair_up(const WeldedFaces& faces) {
  const std::size_t vertices = faces.vertices.size();
  std::vector<std::size_t> end(vertices + 1, 0);  // of the edges that leave each vertex
  for_each_edge(faces, [&](std::uint32_t from, std::uint32_t) { ++end[from + 1]; });
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<std::uint32_t> leads_to(end.back());
  for_each_edge(faces, [&](std::uint32_t from, std::uint32_t to) { leads_to[end[from]++] = to; });

  const auto leaving = [&](std::uint32_t v) {
    const std::size_t begin = v == 0 ? 0 : end[v - 1];
    return std::span(leads_to).subspan(begin, end[v] - begin);
  };
  for (std::uint32_t v = 0; v < vertices; ++v) {
    std::ranges::sort(leaving(v));
    if (std::ranges::adjacent_find(leaving(v)) != leaving(v).end()) return false;
  }
  for (std::uint32_t v = 0; v < vertices; ++v) {
    for (const std::uint32_t to : leaving(v)) {
      if (!std::ranges::binary_search(leaving(to), v)) return false;
    }
  }
  return true;
}

/// The vertices in their connected parts.
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

bool bounds_solids(const Mesh& mesh, std::size_t first_face, std::size_t end_face) {
  const WeldedFaces faces = weld(mesh, first_face, end_face);
  return edges_pair_up(faces) && volumes_are_positive(faces);
}

// ---- Normals ---------------------------------------------------------------------------

/// Between the sides that meet in the corner; 0 if one has no length.
double angle_at(const Point3& corner, const Point3& before, const Point3& after) {
  const Point3 a = before - corner, b = after - corner;
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// Of the faces' vertices made one: the sum of the normals of the faces around each, times their
/// angles there.
std::vector<Point3> angle_weighted_normals(const WeldedFaces& faces) {
  std::vector<Point3> sum(faces.vertices.size(), Point3(0.0));
  std::vector<Point3> polygon;
  for (std::size_t i = 0; i < faces.faces(); ++i) {
    const auto face = faces.face(i);
    polygon.clear();
    for (const std::uint32_t v : face) polygon.push_back(faces.vertices[v]);
    const Point3 normal = newell_normal(polygon);
    if (normal == Point3(0.0)) continue;
    for (std::size_t k = 0; k < face.size(); ++k) {
      const Point3& before = polygon[k == 0 ? face.size() - 1 : k - 1];
      const Point3& after = polygon[k + 1 == face.size() ? 0 : k + 1];
      sum[face[k]] += angle_at(polygon[k], before, after) * unit(normal);
    }
  }
  return sum;
}

// ---- Entering --------------------------------------------------------------------------

constexpr Colour kNeutral(0.87, 0.85, 0.81);

void require_no_open_segment(const GraphicsSystem& system) {
  if (const auto open = system.open_segment_name()) {
    throw Error(fmt::format("segment already open: segment {}; close it first", *open));
  }
}

void require_free_names(const Mesh& mesh, const GraphicsSystem& system, std::int64_t first) {
  const std::int64_t last = first + static_cast<std::int64_t>(mesh.objects.size()) - 1;
  if (first < 1 || last > std::numeric_limits<int>::max()) {
    throw Error(
        fmt::format("segment names {} to {}: expected positive 32-bit numbers", first, last));
  }
  for (std::int64_t name = first; name <= last; ++name) {
    if (system.display_file().contains(static_cast<int>(name))) {
      throw Error(fmt::format("segment name in use: {}", name));
    }
  }
}

std::int64_t name_after_all_in_use(const DisplayFile& display_file) {
  std::int64_t largest = 0;
  for (const Segment& s : display_file.segments()) {
    largest = std::max<std::int64_t>(largest, s.name());
  }
  return largest + 1;
}

void enter_object(const Mesh& mesh, const Mesh::Object& object, GraphicsSystem& system) {
  std::vector<Point3> polygon, normals;
  for (std::size_t i = object.first_face; i < object.first_face + object.faces; ++i) {
    polygon.clear();
    for (const std::uint32_t corner : mesh.face(i)) polygon.push_back(mesh.vertices[corner]);
    if (!mesh.normals.empty()) {
      normals.clear();
      for (const std::uint32_t corner : mesh.face(i)) normals.push_back(mesh.normals[corner]);
      system.set_vertex_normals(normals);
    }
    system.polygon_abs_3(polygon);
  }
}

}  // namespace

Mesh read_mesh(const std::string& path, bool with_normals) {
  check_mesh_file(path);
  try {
    return read_checked(path, with_normals);
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw Error(fmt::format("{}: not enough memory for the mesh", path));
  } catch (const std::exception& e) {  // what an importer of the library let through
    throw Error(fmt::format("{}: not a mesh that can be read: {}", path, e.what()));
  }
}

void complete_normals(Mesh& mesh) {
  mesh.normals.resize(mesh.vertices.size(), Point3(0.0));
  const auto is_missing = [&](std::uint32_t v) { return mesh.normals[v] == Point3(0.0); };
  if (std::ranges::none_of(mesh.corners, is_missing)) return;
  const WeldedFaces faces = weld(mesh, 0, mesh.faces());
  const std::vector<Point3> around = angle_weighted_normals(faces);
  for (std::size_t k = 0; k < mesh.corners.size(); ++k) {
    if (is_missing(mesh.corners[k])) mesh.normals[mesh.corners[k]] = around[faces.corners[k]];
  }
}

bool closed_and_consistently_oriented(const Mesh& mesh) {
  const auto object_bounds_solids = [&](const Mesh::Object& o) {
    return bounds_solids(mesh, o.first_face, o.first_face + o.faces);
  };
  if (mesh.objects.empty()) return false;
  return std::ranges::all_of(mesh.objects, object_bounds_solids) ||
         bounds_solids(mesh, 0, mesh.faces());
}

void enter_mesh(const Mesh& mesh, GraphicsSystem& system, int first_segment_name) {
  require_no_open_segment(system);
  require_free_names(mesh, system, first_segment_name);
  int next = first_segment_name;
  try {
    for (const Mesh::Object& object : mesh.objects) {
      system.open_segment(next++);
      enter_object(mesh, object, system);
      system.close_segment();
    }
  } catch (...) {
    if (system.open_segment_name()) system.close_segment();
    for (int name = first_segment_name; name < next; ++name) {
      if (system.display_file().contains(name)) system.delete_segment(name);
    }
    throw;
  }
}

Mesh::Skipped import_meshes(std::span<const std::string> paths, GraphicsSystem& system,
                            double aspect) {
  require_no_open_segment(system);
  std::vector<Mesh> meshes;
  std::int64_t name = name_after_all_in_use(system.display_file());
  std::int64_t end = name;
  for (const std::string& path : paths) {
    const bool smooth = system.shading() == Shading::gouraud;
    meshes.push_back(read_mesh(path, smooth));
    if (smooth) complete_normals(meshes.back());
    require_free_names(meshes.back(), system, end);
    end += static_cast<std::int64_t>(meshes.back().objects.size());
  }
  const bool bare = !system.view_was_set();
  if (bare && !meshes.empty()) {
    fit_view(meshes, system, aspect);
    system.create_transformation_3();
    system.set_fill_style({FillStyle::Kind::solid, kNeutral});
    system.set_line_style({LineStyle::Kind::none});
    system.set_hidden_line_removal(true);
  }
  Mesh::Skipped skipped;
  for (const Mesh& mesh : meshes) {
    if (bare) {  // removed faces would hide no light
      system.set_back_face_removal(!system.shadows() && closed_and_consistently_oriented(mesh));
    }
    enter_mesh(mesh, system, static_cast<int>(name));
    name += static_cast<std::int64_t>(mesh.objects.size());
    skipped.points_and_lines += mesh.skipped.points_and_lines;
    skipped.degenerate_faces += mesh.skipped.degenerate_faces;
  }
  return skipped;
}

Mesh::Skipped import_mesh(const std::string& path, GraphicsSystem& system, double aspect) {
  return import_meshes(std::span(&path, 1), system, aspect);
}

}  // namespace displayfile
