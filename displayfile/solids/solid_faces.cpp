#include "displayfile/solids/solid_faces.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>
#include <vector>

#include "clip/geometry/back_face.h"
#include "clip/geometry/equal_points.h"

namespace displayfile {

void SolidFaces::add_loop(std::span<const Corner> loop) {
  if (loop.size() < 3) return;
  corners.insert(corners.end(), loop.begin(), loop.end());
  end_corner.push_back(corners.size());
}

void SolidFaces::add(const Face& face) {
  if (first_loop(faces.size()) == end_corner.size()) return;
  faces.push_back(face);
  faces.back().end_loop = end_corner.size();
}

void set_to_face(FacePolygon& polygon, const SolidFaces& solid, std::size_t face) {
  polygon.vertices.clear();
  polygon.edge_visible.clear();
  polygon.normals.clear();
  const bool smooth = solid.faces[face].smooth;
  const auto add = [&](const SolidFaces::Corner& corner, bool is_drawn) {
    polygon.vertices.push_back(solid.vertices[corner.vertex]);
    polygon.edge_visible.push_back(is_drawn ? corner.edge_visible : std::uint8_t{0});
    if (smooth) polygon.normals.push_back(corner.normal);
  };
  const std::size_t first = solid.first_loop(face), end = solid.faces[face].end_loop;
  for (std::size_t i = first; i < end; ++i) {
    const auto loop = solid.loop(i);
    for (std::size_t k = 0; k < loop.size(); ++k) add(loop[k], i == first || k > 0);
    if (end - first == 1) return;
    add(loop.front(), true);  // its last side
    if (i > first && i + 1 < end) add(solid.loop(first).front(), false);
  }
  // The bridge back from the last loop ends at the first vertex.
  polygon.edge_visible.front() = 0;
}

namespace {

/// A directed side: its ends in order, and its direction.
struct DirectedSide {
  std::uint32_t low, high;
  bool rises;
  auto ends() const { return std::pair(low, high); }
};

std::optional<OpenSide> open_side(std::vector<DirectedSide>& sides,
                                  std::span<const Point3> vertices) {
  std::ranges::sort(sides, {}, &DirectedSide::ends);
  for (std::size_t i = 0; i < sides.size();) {
    std::ptrdiff_t balance = 0;
    std::size_t k = i;
    for (; k < sides.size() && sides[k].ends() == sides[i].ends(); ++k) {
      balance += sides[k].rises ? 1 : -1;
    }
    const Point3 &low = vertices[sides[i].low], &high = vertices[sides[i].high];
    if (balance > 0) return OpenSide(low, high);
    if (balance < 0) return OpenSide(high, low);
    i = k;
  }
  return std::nullopt;
}

void add_side(std::uint32_t from, std::uint32_t to, std::vector<DirectedSide>& sides) {
  if (from != to) sides.push_back({std::min(from, to), std::max(from, to), from < to});
}

}  // namespace

std::optional<OpenSide> open_side(std::span<const Point3> vertices,
                                  std::span<const std::uint32_t> corners,
                                  std::span<const std::uint32_t> sides) {
  std::vector<Point3> points;
  EqualPoints table(points, vertices.size());
  std::vector<std::uint32_t> number;
  number.reserve(vertices.size());
  for (const Point3& p : vertices) number.push_back(table.number_of(p + Point3(0.0)));  // -0 is 0
  std::vector<DirectedSide> all;
  all.reserve(corners.size());
  const std::size_t polygons = sides.empty() ? corners.size() / 3 : sides.size();
  std::size_t first = 0;
  for (std::size_t i = 0; i < polygons; ++i) {
    const auto polygon = corners.subspan(first, sides.empty() ? 3 : sides[i]);
    first += polygon.size();
    std::uint32_t from = number[polygon.back()];
    for (const std::uint32_t corner : polygon) {
      add_side(from, number[corner], all);
      from = number[corner];
    }
  }
  return open_side(all, points);
}

std::optional<OpenSide> open_side(const SolidFaces& solid, std::size_t first_face,
                                  std::size_t end_face) {
  std::vector<Point3> points;
  std::size_t corners = 0;
  const std::size_t first_loop = solid.first_loop(first_face);
  const std::size_t end_loop = solid.first_loop(end_face);
  for (std::size_t i = first_loop; i < end_loop; ++i) corners += solid.loop(i).size();
  EqualPoints table(points, corners);
  std::vector<DirectedSide> all;
  all.reserve(corners);
  for (std::size_t i = first_loop; i < end_loop; ++i) {
    const auto number = [&](const SolidFaces::Corner& corner) {
      return table.number_of(solid.vertices[corner.vertex]);
    };
    std::uint32_t from = number(solid.loop(i).back());
    for (const SolidFaces::Corner& corner : solid.loop(i)) {
      const std::uint32_t to = number(corner);
      add_side(from, to, all);
      from = to;
    }
  }
  return open_side(all, points);
}

namespace {

/// Sums the volumes between polygons and a point.
class VolumeSum {
 public:
  void add(std::span<const Point3> polygon) {
    if (polygon.empty()) return;
    if (!origin_) origin_ = polygon.front();
    sum_ += glm::dot(polygon.front() - *origin_, newell_normal(polygon));
  }
  double sum() const { return sum_; }

 private:
  std::optional<Point3> origin_;
  double sum_ = 0.0;
};

}  // namespace

double enclosed_volume(std::span<const Point3> vertices, std::span<const std::uint32_t> corners,
                       std::span<const std::uint32_t> sides) {
  VolumeSum volume;
  std::vector<Point3> polygon;
  const std::size_t polygons = sides.empty() ? corners.size() / 3 : sides.size();
  std::size_t first = 0;
  for (std::size_t i = 0; i < polygons; ++i) {
    const std::size_t n = sides.empty() ? 3 : sides[i];
    polygon.clear();
    for (const std::uint32_t corner : corners.subspan(first, n)) {
      polygon.push_back(vertices[corner]);
    }
    volume.add(polygon);
    first += n;
  }
  return volume.sum();
}

double enclosed_volume(const SolidFaces& solid) {
  VolumeSum volume;
  std::vector<Point3> polygon;
  for (std::size_t i = 0; i < solid.end_corner.size(); ++i) {
    polygon.clear();
    for (const SolidFaces::Corner& corner : solid.loop(i)) {
      polygon.push_back(solid.vertices[corner.vertex]);
    }
    volume.add(polygon);
  }
  return volume.sum();
}

}  // namespace displayfile
