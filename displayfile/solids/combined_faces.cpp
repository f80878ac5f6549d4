#include "displayfile/solids/exact_solid.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numeric>
#include <span>
#include <tuple>
#include <vector>

#include "clip/geometry/back_face.h"
#include "clip/geometry/equal_points.h"
#include "clip/geometry/unit.h"
#include "hidden/triangles/triangulation.h"

namespace displayfile {

BoundingTriangles triangles_of(const SolidFaces& solid, std::size_t first_face,
                               std::size_t end_face) {
  BoundingTriangles result;
  std::size_t corners = 0;
  for (std::size_t i = first_face; i < end_face; ++i) {
    corners += solid.loop(solid.first_loop(i)).size();
  }
  EqualPoints table(result.vertices, corners);
  Triangulation triangulation;
  std::vector<Point3> polygon;
  std::vector<std::uint32_t> number;
  for (std::size_t i = first_face; i < end_face; ++i) {
    polygon.clear();
    number.clear();
    for (const SolidFaces::Corner& corner : solid.loop(solid.first_loop(i))) {
      polygon.push_back(solid.vertices[corner.vertex]);
      number.push_back(table.number_of(polygon.back() + Point3(0.0)));  // -0 is 0
    }
    for (const auto& [vertex, edge_visible] : triangulation.triangulate(polygon)) {
      const std::array triangle{number[vertex[0]], number[vertex[1]], number[vertex[2]]};
      if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) {
        continue;  // its two sides coincide
      }
      result.triangles.push_back(triangle);
      result.source.push_back(static_cast<std::uint32_t>(i));
    }
  }
  return result;
}

namespace {

/// A side of a triangle.
struct Side {
  std::uint32_t from, to, source;
  std::uint8_t is_flat;
  auto place() const { return std::tuple(from, to, source); }
};

/// Vertices sorted by position; those rounded to one position are merged.
struct OrderedVertices {
  std::vector<Point3> vertices;
  std::vector<std::uint32_t> number;  ///< of each vertex before

  explicit OrderedVertices(std::span<const Point3> given) : number(given.size()) {
    const auto key = [&](std::uint32_t v) {
      const Point3& p = given[v];
      return std::tuple(p.x, p.y, p.z);
    };
    std::vector<std::uint32_t> order(given.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, {}, key);
    for (const std::uint32_t v : order) {
      if (vertices.empty() || vertices.back() != given[v]) vertices.push_back(given[v] + 0.0);
      number[v] = static_cast<std::uint32_t>(vertices.size() - 1);
    }
  }
};

/// The normal, interpolated over a source's triangle, or the one that all corners share.
Point3 normal_at(const Point3& p, const SolidFaces& sources, std::size_t source) {
  const auto corners = sources.loop(sources.first_loop(source));
  if (corners.size() != 3) return corners[0].normal;
  std::array<Point3, 3> position;
  for (std::size_t k = 0; k < 3; ++k) position[k] = sources.vertices[corners[k].vertex];
  for (std::size_t k = 0; k < 3; ++k) {
    if (position[k] == p) return corners[k].normal;
  }
  const Point3 whole = glm::cross(position[1] - position[0], position[2] - position[0]);
  Point3 normal(0.0);
  for (std::size_t k = 0; k < 3; ++k) {
    const Point3 part =
        glm::cross(position[(k + 1) % 3] - p, position[(k + 2) % 3] - p);  // beside the corner
    const Point3& n = corners[k].normal;
    if (n != Point3(0.0)) normal += std::max(0.0, glm::dot(part, whole)) * unit(n);
  }
  return normal == Point3(0.0) ? corners[0].normal : unit(normal);
}

/// Assembles faces, source after source.
class Faces {
 public:
  Faces(const BoundingTriangles& triangles, const SolidFaces& sources) : sources_(sources) {
    OrderedVertices ordered(triangles.vertices);
    result_.vertices = std::move(ordered.vertices);
    is_between_.resize(result_.vertices.size(), 0);
    std::vector<std::uint8_t> is_there(result_.vertices.size(), 0);
    for (std::size_t v = 0; v < triangles.vertices.size(); ++v) {
      const std::uint32_t number = ordered.number[v];
      is_between_[number] = is_there[number] == 0 ? triangles.is_between[v] : std::uint8_t{0};
      is_there[number] = 1;
    }
    result_.attributes = sources.attributes;
    for (std::size_t i = 0; i < triangles.triangles.size(); ++i) {
      const auto& triangle = triangles.triangles[i];
      std::uint32_t from = ordered.number[triangle[2]];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t to = ordered.number[triangle[k]];
        if (from != to) sides_.push_back({from, to, triangles.source[i], triangles.is_flat[i][k]});
        from = to;
      }
    }
    // Where rounding has merged vertices, there may be several equal sides; sorting makes their
    // order definite.
    std::ranges::sort(sides_, {}, [](const Side& side) {
      return std::tuple(side.from, side.to, side.source, side.is_flat);
    });
  }

  SolidFaces put_together() {
    std::vector<Side> boundary;
    for (std::size_t i = 0; i < sides_.size();) {
      const Side& side = sides_[i];
      const std::size_t there = count(side.from, side.to, side.source);
      const std::size_t back = count(side.to, side.from, side.source);
      for (std::size_t k = back; k < there; ++k) boundary.push_back(side);
      i += there;
    }
    std::ranges::stable_sort(boundary, {}, &Side::source);
    for (std::size_t i = 0; i < boundary.size();) {
      std::size_t end = i;
      while (end < boundary.size() && boundary[end].source == boundary[i].source) ++end;
      add_face(std::span(boundary).subspan(i, end - i));
      i = end;
    }
    return std::move(result_);
  }

 private:
  std::size_t count(std::uint32_t from, std::uint32_t to, std::uint32_t source) const {
    const auto key = std::tuple(from, to, source);
    return static_cast<std::size_t>(std::ranges::upper_bound(sides_, key, {}, &Side::place) -
                                    std::ranges::lower_bound(sides_, key, {}, &Side::place));
  }

  /// True if the side is on the boundary of its source's face.
  bool is_drawn(const Side& side) const {
    const auto beyond =
        std::ranges::lower_bound(sides_, std::tuple(side.to, side.from, 0u), {}, &Side::place);
    if (beyond == sides_.end() || beyond->from != side.to || beyond->to != side.from) return true;
    const SolidFaces::Face &here = sources_.faces[side.source],
                           &there = sources_.faces[beyond->source];
    if (here.polygon == there.polygon) return false;
    return side.is_flat == 0 ||
           sources_.attributes[here.attributes] != sources_.attributes[there.attributes];
  }

  /// Adds a face from its sides, sorted by their ends.
  void add_face(std::span<const Side> sides) {
    const std::size_t source = sides[0].source;
    SolidFaces::Face face = sources_.faces[source];
    std::vector<bool> is_used(sides.size(), false);
    Point3 area(0.0);
    std::vector<std::vector<SolidFaces::Corner>> loops;
    for (std::size_t first = 0; first < sides.size(); ++first) {
      if (is_used[first]) continue;
      auto& loop = loops.emplace_back();
      std::vector<Point3> positions;
      for (std::size_t at = first;;) {
        is_used[at] = true;
        const Side& side = sides[at];
        if (is_between_[side.to] == 0) {
          loop.push_back({side.to, static_cast<std::uint8_t>(is_drawn(side) ? 1 : 0)});
          positions.push_back(result_.vertices[side.to]);
        }
        if (side.to == sides[first].from) break;
        const auto next = std::ranges::lower_bound(sides, side.to, {}, &Side::from);
        auto k = static_cast<std::size_t>(next - sides.begin());
        while (k < sides.size() && sides[k].from == side.to && is_used[k]) ++k;
        if (k == sides.size() || sides[k].from != side.to) break;  // rounding left no continuation
        at = k;
      }
      area += newell_normal(positions);
      if (loop.size() < 3) loops.pop_back();  // rounding has left nothing of it
    }
    if (loops.empty()) return;
    const bool is_turned = is_other_way(area, source);
    if (is_turned) face.normal = -face.normal;
    for (auto& loop : loops) {
      for (SolidFaces::Corner& corner : loop) {
        if (!face.smooth) break;
        const Point3 normal = normal_at(result_.vertices[corner.vertex], sources_, source);
        corner.normal = is_turned ? -normal : normal;
      }
      result_.add_loop(loop);
    }
    result_.add(face);
  }

  /// True if the light face of the rest of a polygon is the source's dark face.
  bool is_other_way(const Point3& area, std::size_t source) const {
    std::vector<Point3> polygon;
    for (const auto& corner : sources_.loop(sources_.first_loop(source))) {
      polygon.push_back(sources_.vertices[corner.vertex]);
    }
    return glm::dot(area, newell_normal(polygon)) < 0.0;
  }

  const SolidFaces& sources_;
  std::vector<Side> sides_;
  std::vector<std::uint8_t>
      is_between_;  // of the result's vertices, none of them several: left out
  SolidFaces result_;
};

}  // namespace

SolidFaces combined_faces(const BoundingTriangles& result, const SolidFaces& sources) {
  return Faces(result, sources).put_together();
}

}  // namespace displayfile
