#include "displayfile/mesh/cad/cad_faces.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <gp_Pnt.hxx>
#include <gp_Trsf.hxx>
#include <gp_Vec.hxx>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "clip/base/error.h"

namespace displayfile {

namespace {

Point3 point_of(const gp_XYZ& p) { return {p.X(), p.Y(), p.Z()}; }

/// The indices of the nodes along the only outline of a triangulation, in the order of its
/// triangles; nothing if it has several outlines, or one that touches itself.
std::optional<std::vector<int>> only_outline(const Poly_Triangulation& triangulation) {
  std::set<std::pair<int, int>> sides;  // directed, of one triangle alone
  for (int i = 1; i <= triangulation.NbTriangles(); ++i) {
    std::array<int, 3> n;
    triangulation.Triangle(i).Get(n[0], n[1], n[2]);
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = n[k], to = n[(k + 1) % 3];
      const auto reverse = sides.find({to, from});
      if (reverse != sides.end()) {
        sides.erase(reverse);
      } else if (!sides.insert({from, to}).second) {
        return std::nullopt;
      }
    }
  }
  std::map<int, int> next;
  for (const auto& [from, to] : sides) {
    if (!next.insert({from, to}).second) return std::nullopt;
  }
  if (next.size() < 3) return std::nullopt;
  std::vector<int> outline;
  for (int node = next.begin()->first; outline.size() < next.size();) {
    outline.push_back(node);
    const auto found = next.find(node);
    if (found == next.end()) return std::nullopt;
    node = found->second;
    if (node == outline.front()) break;
  }
  if (outline.size() != next.size()) return std::nullopt;
  return outline;
}

/// The normals at the nodes, from the surface; zero where it has none, as at the tip of a cone.
std::vector<Point3> normals_of(const TopoDS_Face& face, const Poly_Triangulation& triangulation) {
  std::vector<Point3> normals(static_cast<std::size_t>(triangulation.NbNodes()), Point3(0.0));
  if (!triangulation.HasUVNodes()) return normals;
  const BRepAdaptor_Surface surface(face, Standard_False);
  for (int i = 1; i <= triangulation.NbNodes(); ++i) {
    const gp_Pnt2d uv = triangulation.UVNode(i);
    gp_Pnt at;
    gp_Vec along_u, along_v;
    surface.D1(uv.X(), uv.Y(), at, along_u, along_v);
    const Point3 u = point_of(along_u.XYZ()), v = point_of(along_v.XYZ());
    const Point3 normal = glm::cross(u, v);
    constexpr double kLeastSine = 1e-9;
    const double length = glm::length(normal);
    const double most = std::max(glm::dot(u, u), glm::dot(v, v));
    if (length > kLeastSine * most) normals[static_cast<std::size_t>(i - 1)] = normal / length;
  }
  return normals;
}

}  // namespace

glm::dmat4 matrix_of(const TopLoc_Location& location) {
  glm::dmat4 matrix(1.0);
  if (location.IsIdentity()) return matrix;
  const gp_Trsf transformation = location.Transformation();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      matrix[column][row] = transformation.Value(row + 1, column + 1);
    }
  }
  return matrix;
}

void CadFaces::begin(const glm::dmat4& to_world) {
  to_world_ = to_world;
  vertices_.clear();
}

std::uint32_t CadFaces::vertex(const Point3& p) {
  const auto [found, is_new] = vertices_.insert({p, static_cast<std::uint32_t>(mesh_.vertices())});
  if (is_new) mesh_.add_vertex(p);
  return found->second;
}

void CadFaces::add_polygon(std::span<const int> numbers, bool turned) {
  corners_.clear();
  normals_.clear();
  for (const int number : numbers) {
    const Corner& corner = nodes_[static_cast<std::size_t>(number - 1)];
    corners_.push_back(corner.vertex);
    if (with_normals_) normals_.push_back(corner.normal);
  }
  const bool is_triangle = corners_.size() == 3;
  // At the tip of a cone, or a pole, some triangles have no area.
  if (is_triangle &&
      (corners_[0] == corners_[1] || corners_[1] == corners_[2] || corners_[2] == corners_[0])) {
    return;
  }
  if (turned) {
    std::ranges::reverse(corners_);
    std::ranges::reverse(normals_);
  }
  mesh_.add_face(corners_, normals_);
}

void CadFaces::add_nodes(const TopoDS_Face& face, const Poly_Triangulation& triangulation,
                         const glm::dmat4& matrix) {
  const bool moved = matrix != glm::dmat4(1.0);
  nodes_.clear();
  for (int i = 1; i <= triangulation.NbNodes(); ++i) {
    Point3 p = point_of(triangulation.Node(i).XYZ());
    if (moved) p = Point3(matrix * HomogeneousPoint(p, 1.0));
    if (!in_range(p)) throw Error("a face is out of range: expected finite coordinates");
    nodes_.push_back({vertex(p + 0.0), Mesh::kNoNormal});
  }
  if (!with_normals_) return;
  // Cofactors turn normals as the matrix turns planes; of mirrored faces they stay outward.
  const glm::dmat3 m(matrix);
  const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]),
                             glm::cross(m[0], m[1]));
  const bool inward = (face.Orientation() == TopAbs_REVERSED) != (glm::determinant(m) < 0.0);
  const std::vector<Point3> normals = normals_of(face, triangulation);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (normals[i] == Point3(0.0)) continue;
    nodes_[i].normal = static_cast<std::uint32_t>(mesh_.normals());
    mesh_.add_normal((inward ? -1.0 : 1.0) * (cofactors * normals[i]));
  }
}

bool CadFaces::add(const TopoDS_Face& face) {
  TopLoc_Location location;
  const opencascade::handle<Poly_Triangulation> triangulation =
      BRep_Tool::Triangulation(face, location);
  if (triangulation.IsNull() || triangulation->NbTriangles() == 0) return false;
  const glm::dmat4 matrix = to_world_ * matrix_of(location);
  add_nodes(face, *triangulation, matrix);
  const bool mirrors = glm::determinant(glm::dmat3(matrix)) < 0.0;
  const bool turned = (face.Orientation() == TopAbs_REVERSED) != mirrors;
  if (BRepAdaptor_Surface(face, Standard_False).GetType() == GeomAbs_Plane) {
    if (const auto outline = only_outline(*triangulation)) {
      add_polygon(*outline, turned);
      return true;
    }
  }
  for (int i = 1; i <= triangulation->NbTriangles(); ++i) {
    std::array<int, 3> numbers;
    triangulation->Triangle(i).Get(numbers[0], numbers[1], numbers[2]);
    add_polygon(numbers, turned);
  }
  return true;
}

}  // namespace displayfile
