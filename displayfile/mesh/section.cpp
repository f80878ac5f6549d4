#include "displayfile/mesh/section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>

#include "clip/error.h"
#include "displayfile/mesh/welded_faces.h"
#include "hidden/exact/double_double.h"
#include "hidden/exact/exact_number.h"
#include "hidden/exact/rounding.h"
#include "hidden/triangulation.h"

namespace displayfile {

namespace {

/// normal . p - distance: its sign is exact, its value good to some 30 digits of its terms.
class CuttingPlane {
 public:
  explicit CuttingPlane(const SectionPlane& plane) : plane_(plane) {}

  int side(const Point3& p) const {
    const double value = glm::dot(plane_.normal, p) - plane_.distance;
    const double bound =
        8.0 * kUnit * (glm::dot(glm::abs(plane_.normal), glm::abs(p)) + std::abs(plane_.distance)) +
        kTiny;
    if (std::abs(value) > bound) return sign_of(value);
    ExactNumber sum = -ExactNumber(plane_.distance);
    for (int k = 0; k < 3; ++k) sum = sum + ExactNumber(plane_.normal[k]) * ExactNumber(p[k]);
    return sum.sign();
  }
  DoubleDouble value(const Point3& p) const {
    DoubleDouble sum{-plane_.distance, 0.0};
    for (int k = 0; k < 3; ++k) sum = sum + exact_product(plane_.normal[k], p[k]);
    return sum;
  }
  /// The axis that the plane is at right angles to, or -1.
  int own_axis() const {
    for (int k = 0; k < 3; ++k) {
      if (plane_.normal[(k + 1) % 3] == 0.0 && plane_.normal[(k + 2) % 3] == 0.0) return k;
    }
    return -1;
  }
  const SectionPlane& plane() const { return plane_; }

 private:
  SectionPlane plane_;
};

/// Where an edge meets the plane, to twice the digits of a double.
using CutPoint = std::array<DoubleDouble, 3>;

CutPoint cut_point(const CuttingPlane& plane, const Point3& behind, const Point3& before) {
  const DoubleDouble v0 = plane.value(behind), v1 = plane.value(before);
  CutPoint point;
  for (int k = 0; k < 3; ++k) {
    DoubleDouble& coordinate = point[static_cast<std::size_t>(k)];
    if (v1.high == 0.0) {
      coordinate = {before[k], 0.0};
    } else {
      coordinate =
          (DoubleDouble{behind[k], 0.0} * v1 - DoubleDouble{before[k], 0.0} * v0) / (v1 - v0);
    }
  }
  if (const int k = plane.own_axis(); k >= 0) {
    point[static_cast<std::size_t>(k)] =
        DoubleDouble{plane.plane().distance, 0.0} / DoubleDouble{plane.plane().normal[k], 0.0};
  }
  return point;
}

Point3 rounded_point(const CutPoint& p) { return {p[0].high, p[1].high, p[2].high}; }

/// The edges that the plane cuts, each once, from its end behind the plane to the one before.
class CutEdges {
 public:
  CutEdges(const CuttingPlane& plane, const WeldedFaces& faces) : plane_(plane), faces_(faces) {}

  std::uint32_t number(std::uint32_t behind, std::uint32_t before) {
    const auto [at, is_new] = numbers_.try_emplace((std::uint64_t{behind} << 32) | before,
                                                   static_cast<std::uint32_t>(points.size()));
    if (is_new)
      points.push_back(cut_point(plane_, faces_.vertices[behind], faces_.vertices[before]));
    return at->second;
  }

  std::vector<CutPoint> points;

 private:
  const CuttingPlane& plane_;
  const WeldedFaces& faces_;
  std::unordered_map<std::uint64_t, std::uint32_t> numbers_;
};

/// From one cut edge to another, through a triangle.
struct Link {
  std::uint32_t from, to;
};

/// Cuts triangle after triangle, and keeps what is behind.
class Cutter {
 public:
  Cutter(const CuttingPlane& plane, const WeldedFaces& faces) : faces_(faces), edges(plane, faces) {
    for (const Point3& p : faces.vertices) is_before_.push_back(plane.side(p) >= 0);
    behind.vertices = faces.vertices;
    behind.first_corner.push_back(0);
  }

  void cut_all() {
    for (std::size_t i = 0; i < faces_.faces(); ++i) {
      const auto face = faces_.face(i);
      const auto before = std::ranges::count_if(face, [&](auto v) { return is_before_[v]; });
      if (before == std::ssize(face)) continue;
      if (before == 0) {
        keep(face);
      } else if (face.size() == 3) {
        cut(face);
      } else {
        cut_polygon(face);
      }
    }
    const auto first = static_cast<std::uint32_t>(faces_.vertices.size());
    for (const CutPoint& p : edges.points) behind.vertices.push_back(rounded_point(p));
    for (std::uint32_t& corner : behind.corners) {
      if (corner >= kOfCutEdge) corner = first + (corner - kOfCutEdge);
    }
    if (behind.faces() > 0) behind.objects.push_back({"", 0, behind.faces()});
  }

 private:
  static constexpr std::uint32_t kOfCutEdge = 0x80000000u;

  void keep(std::span<const std::uint32_t> face) {
    behind.corners.insert(behind.corners.end(), face.begin(), face.end());
    behind.first_corner.push_back(behind.corners.size());
  }

  void cut_polygon(std::span<const std::uint32_t> face) {
    polygon_.clear();
    for (const std::uint32_t v : face) polygon_.push_back(faces_.vertices[v]);
    for (const Triangulation::Triangle& t : triangulation_.triangulate(polygon_)) {
      const std::array corners{face[t.vertex[0]], face[t.vertex[1]], face[t.vertex[2]]};
      const auto before = std::ranges::count_if(corners, [&](auto v) { return is_before_[v]; });
      if (before == 0) keep(corners);
      if (before == 1 || before == 2) cut(corners);
    }
  }

  void cut(std::span<const std::uint32_t> triangle) {
    Link link{};
    piece_.clear();
    std::uint32_t from = triangle.back();
    for (const std::uint32_t to : triangle) {
      if (is_before_[from] != is_before_[to]) {
        const std::uint32_t edge = is_before_[to] ? edges.number(from, to) : edges.number(to, from);
        (is_before_[to] ? link.to : link.from) = edge;
        piece_.push_back(kOfCutEdge + edge);
      }
      if (!is_before_[to]) piece_.push_back(to);
      from = to;
    }
    links.push_back(link);
    keep(piece_);
  }

  const WeldedFaces& faces_;
  std::vector<bool> is_before_;
  Triangulation triangulation_;
  std::vector<Point3> polygon_;
  std::vector<std::uint32_t> piece_;

 public:
  CutEdges edges;
  std::vector<Link> links;
  Mesh behind;
};

/// Chains of links that come back to where they began; nothing if some do not.
bool chain(std::span<const Link> links, std::size_t edges,
           std::vector<std::vector<std::uint32_t>>& loops) {
  constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  std::vector<std::uint32_t> first(edges, kNone), next(links.size(), kNone);
  std::vector<int> balance(edges, 0);
  for (std::uint32_t i = 0; i < links.size(); ++i) {
    next[i] = std::exchange(first[links[i].from], i);
    ++balance[links[i].from];
    --balance[links[i].to];
  }
  if (std::ranges::any_of(balance, [](int b) { return b != 0; })) return false;
  for (std::uint32_t e = 0; e < edges; ++e) {
    while (first[e] != kNone) {
      auto& loop = loops.emplace_back();
      std::uint32_t at = e;
      do {
        loop.push_back(at);
        const std::uint32_t link = first[at];
        first[at] = next[link];
        at = links[link].to;
      } while (at != e);
    }
  }
  return true;
}

/// Twice the area of a loop in the projection along an axis.
DoubleDouble twice_area(std::span<const CutPoint> points, std::span<const std::uint32_t> loop,
                        std::size_t axis) {
  const std::size_t x = (axis + 1) % 3, y = (axis + 2) % 3;
  const CutPoint& origin = points[loop[0]];
  DoubleDouble sum;
  for (std::size_t k = 2; k < loop.size(); ++k) {
    const CutPoint &a = points[loop[k - 1]], &b = points[loop[k]];
    sum = sum + ((a[x] - origin[x]) * (b[y] - origin[y]) - (b[x] - origin[x]) * (a[y] - origin[y]));
  }
  return sum;
}

void require_plane(const SectionPlane& plane) {
  const auto is_finite = [](double x) { return std::isfinite(x); };
  const Point3& n = plane.normal;
  if (is_finite(n.x) && is_finite(n.y) && is_finite(n.z) && is_finite(plane.distance) &&
      n != Point3(0.0)) {
    return;
  }
  throw Error("section by a plane that is none: expected a normal that is not 0, finite numbers");
}

}  // namespace

Section section(const Mesh& mesh, const SectionPlane& plane) {
  require_plane(plane);
  const CuttingPlane cutting(plane);
  const WeldedFaces faces = weld(mesh);
  Cutter cutter(cutting, faces);
  cutter.cut_all();
  Section result;
  std::vector<std::vector<std::uint32_t>> loops;
  result.closed = chain(cutter.links, cutter.edges.points.size(), loops);
  result.behind = std::move(cutter.behind);
  if (!result.closed) return result;

  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::abs(plane.normal[k]) > std::abs(plane.normal[axis])) axis = k;
  }
  DoubleDouble sum;
  for (const auto& loop : loops) {
    sum = sum + twice_area(cutter.edges.points, loop, static_cast<std::size_t>(axis));
    std::vector<Point3> points;
    for (const std::uint32_t edge : loop) {
      const Point3 p = rounded_point(cutter.edges.points[edge]);
      if (points.empty() || points.back() != p) points.push_back(p);
    }
    while (points.size() > 1 && points.back() == points.front()) points.pop_back();
    if (points.size() > 2) result.loops.push_back(std::move(points));
  }
  result.area = 0.5 * sum.high * (glm::length(plane.normal) / plane.normal[axis]);
  return result;
}

std::vector<Point3> cap_polygon(const Section& section) {
  std::vector<Point3> polygon;
  for (const auto& loop : section.loops) {
    polygon.insert(polygon.end(), loop.begin(), loop.end());
    polygon.push_back(loop.front());
    if (&loop != &section.loops.front()) polygon.push_back(section.loops.front().front());
  }
  if (section.loops.size() == 1) polygon.pop_back();
  return polygon;
}

}  // namespace displayfile
