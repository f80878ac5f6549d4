#include "displayfile/mesh/gltf_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <stdexcept>
#include <utility>

#include "clip/geometry/bounds.h"
#include "clip/surfaces.h"

namespace displayfile {

namespace {

Point3 point(const double* p) { return {p[0], p[1], p[2]}; }

std::vector<Point3> points(const GltfValues& values) {
  std::vector<Point3> all;
  all.reserve(values.count);
  for (std::size_t i = 0; i < values.count; ++i) all.push_back(point(values[i]));
  return all;
}

void require_count(std::size_t count, std::size_t expected, const char* what) {
  if (count == expected) return;
  throw std::runtime_error(
      fmt::format("glTF: {} {} for {} vertices: expected one each", count, what, expected));
}

/// Adds a morph target's differences, times its weight.
void add_target(const Json& difference, double weight, const char* what, GltfAccessors& accessors,
                std::vector<Point3>& to) {
  if (difference.is_null() || to.empty()) return;
  const GltfValues by = accessors.values(difference, 3);
  require_count(by.count, to.size(), what);
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += weight * point(by[i]);
}

std::vector<Rgba> colours_of(const Json& reference, GltfAccessors& accessors) {
  std::vector<Rgba> colours;
  if (reference.is_null()) return colours;
  const GltfValues values = accessors.values(reference, 3, 4);
  colours.reserve(values.count);
  for (std::size_t i = 0; i < values.count; ++i) {
    const double* c = values[i];
    colours.push_back(
        brought_into_range(Rgba(c[0], c[1], c[2], values.components == 4 ? c[3] : 1.0)));
  }
  return colours;
}

/// Modes of primitives; those before triangles are of points and lines.
constexpr std::size_t kPoints = 0, kLines = 1, kLoop = 2, kTriangles = 4, kStrip = 5, kFan = 6;

/// Corners of the triangles that vertices in this order form.
std::vector<std::uint32_t> corners_of(std::size_t mode, std::vector<std::uint32_t> order) {
  if (mode == kTriangles) {
    order.resize(order.size() / 3 * 3);
    return order;
  }
  std::vector<std::uint32_t> corners;
  for (std::size_t i = 0; i + 2 < order.size(); ++i) {
    const std::size_t first = mode == kFan ? 0 : i;
    const bool is_turned = mode == kStrip && i % 2 == 1;
    corners.insert(corners.end(), {order[first], order[is_turned ? i + 2 : i + 1],
                                   order[is_turned ? i + 1 : i + 2]});
  }
  return corners;
}

std::size_t points_and_lines(std::size_t mode, std::size_t vertices) {
  if (mode == kPoints || mode == kLoop) return vertices;
  if (mode == kLines) return vertices / 2;
  return vertices == 0 ? 0 : vertices - 1;
}

std::vector<std::uint32_t> order_of(const Json& primitive, std::size_t vertices,
                                    GltfAccessors& accessors) {
  const Json& reference = member(primitive, "indices");
  std::vector<std::uint32_t> order;
  if (!reference.is_null()) {
    order = accessors.indices(reference);
    for (const std::uint32_t index : order) {
      if (index >= vertices) {
        throw std::runtime_error(fmt::format(
            "glTF: vertex index {} out of range: expected less than {}", index, vertices));
      }
    }
    return order;
  }
  order.resize(vertices);
  for (std::size_t i = 0; i < vertices; ++i) order[i] = static_cast<std::uint32_t>(i);
  return order;
}

/// The matrix that transforms normals when `m` transforms positions.
glm::dmat3 cofactors(const glm::dmat3& m) {
  return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

double longest_column(const glm::dmat4& m) {
  double longest = 0.0;
  for (int k = 0; k < 3; ++k) longest = std::max(longest, glm::length(Point3(m[k])));
  return longest;
}

void turn_round(GltfPart& part) {
  for (std::size_t i = 0; i + 2 < part.corners.size(); i += 3) {
    std::swap(part.corners[i], part.corners[i + 2]);
  }
  for (Point3& normal : part.normals) normal = -normal;
}

}  // namespace

GltfPart read_gltf_part(const Json& primitive, std::span<const double> weights, bool with_normals,
                        GltfAccessors& accessors) {
  GltfPart part;
  const Json& attributes = object_in(primitive, "attributes");
  const Json& position = member(attributes, "POSITION");
  if (position.is_null()) return part;  // a primitive that only an extension would fill
  const GltfValues values = accessors.values(position, 3);
  part.positions = points(values);
  part.rounding =
      values.are_floats ? kUnitOfSingles * largest_coordinate(part.positions) : values.unit / 2.0;
  if (with_normals && attributes.contains("NORMAL")) {
    part.normals = points(accessors.values(attributes["NORMAL"], 3));
    require_count(part.normals.size(), part.positions.size(), "normals");
  }
  const Json& targets = array_in(primitive, "targets");
  for (std::size_t i = 0; i < std::min(targets.size(), weights.size()); ++i) {
    if (weights[i] == 0.0) continue;
    add_target(member(targets[i], "POSITION"), weights[i], "morphed positions", accessors,
               part.positions);
    add_target(member(targets[i], "NORMAL"), weights[i], "morphed normals", accessors,
               part.normals);
  }
  part.colours = colours_of(member(attributes, "COLOR_0"), accessors);
  if (!part.colours.empty()) require_count(part.colours.size(), part.positions.size(), "colours");

  auto order = order_of(primitive, part.positions.size(), accessors);
  const std::size_t mode = whole_number_in(primitive, "mode", kTriangles);
  if (mode > kFan) throw std::runtime_error(fmt::format("glTF: mode {}: expected 0 to 6", mode));
  if (mode < kTriangles) {
    part.points_and_lines = points_and_lines(mode, order.size());
  } else {
    part.corners = corners_of(mode, std::move(order));
  }
  return part;
}

bool move_by_skin(const Json& primitive, std::span<const glm::dmat4> joints,
                  GltfAccessors& accessors, GltfPart& part) {
  const Json& attributes = object_in(primitive, "attributes");
  std::vector<glm::dmat4> blended(part.positions.size(), glm::dmat4(0.0));
  std::vector<double> sums(part.positions.size(), 0.0);
  for (std::size_t set = 0;; ++set) {
    const Json& joints_of_set = member(attributes, fmt::format("JOINTS_{}", set).c_str());
    const Json& weights_of_set = member(attributes, fmt::format("WEIGHTS_{}", set).c_str());
    if (joints_of_set.is_null() || weights_of_set.is_null()) {
      if (set == 0) return false;
      break;
    }
    const GltfValues indices = accessors.values(joints_of_set, 4);
    const GltfValues weights = accessors.values(weights_of_set, 4);
    require_count(indices.count, blended.size(), "joints");
    require_count(weights.count, blended.size(), "weights");
    for (std::size_t i = 0; i < blended.size(); ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        const double joint = indices[i][k], weight = weights[i][k];
        if (weight == 0.0) continue;
        if (!(joint >= 0.0 && joint < static_cast<double>(joints.size()))) {
          throw std::runtime_error(fmt::format("glTF: joint {} out of range: expected less than {}",
                                               joint, joints.size()));
        }
        blended[i] += weight * joints[static_cast<std::size_t>(joint)];
        sums[i] += weight;
      }
    }
  }
  double longest = 0.0;
  for (const glm::dmat4& joint : joints) longest = std::max(longest, longest_column(joint));
  part.rounding *= longest;
  bool mirrors = false;
  for (std::size_t i = 0; i < blended.size(); ++i) {
    if (!(sums[i] > 0.0)) throw std::runtime_error("glTF: a vertex of a skin without weights");
    const glm::dmat4 m = blended[i] / sums[i];
    part.positions[i] = Point3(m * HomogeneousPoint(part.positions[i], 1.0));
    if (!part.normals.empty()) part.normals[i] = cofactors(glm::dmat3(m)) * part.normals[i];
    if (i == 0) mirrors = glm::determinant(glm::dmat3(m)) < 0.0;
  }
  if (mirrors) turn_round(part);
  return true;
}

void move_part(const glm::dmat4& to_world, GltfPart& part) {
  if (to_world == glm::dmat4(1.0)) return;
  for (Point3& p : part.positions) p = Point3(to_world * HomogeneousPoint(p, 1.0));
  const glm::dmat3 linear(to_world);
  for (Point3& normal : part.normals) normal = cofactors(linear) * normal;
  part.rounding *= longest_column(to_world);
  if (glm::determinant(linear) < 0.0) turn_round(part);
}

}  // namespace displayfile
