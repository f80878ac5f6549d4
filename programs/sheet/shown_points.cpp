#include "programs/sheet/shown_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "programs/sheet/part_lines.h"

namespace displayfile {

namespace {

constexpr double kSeen = 0.01;  // in parts of the part's size

/// True if a line from a to b passes below a point, for the even-odd rule.
bool crosses_below(const Point2& a, const Point2& b, const Point2& p) {
  if ((a.x > p.x) == (b.x > p.x)) return false;
  return a.y + (p.x - a.x) / (b.x - a.x) * (b.y - a.y) < p.y;
}

/// The depth of a face, in a view's coordinates, over a place of the view.
std::optional<double> depth_at(std::span<const Point3> face, const Point2& place) {
  bool inside = false;
  Point3 normal(0.0), before = face.back();
  for (const Point3& p : face) {
    if (crosses_below(Point2(before), Point2(p), place)) inside = !inside;
    normal += glm::cross(before - face.front(), p - face.front());
    before = p;
  }
  constexpr double kEdgeOn = 1e-9;
  if (!inside || !(std::abs(normal.z) > kEdgeOn * glm::length(normal))) return std::nullopt;
  const Point2 from_first = place - Point2(face.front());
  return face.front().z - (normal.x * from_first.x + normal.y * from_first.y) / normal.z;
}

bool is_within_loops(const std::vector<PartDrawing::CutLoop>& loops, const Point2& place) {
  bool inside = false;
  for (const PartDrawing::CutLoop& loop : loops) {
    Point2 before = loop.points.back();
    for (const Point2& p : loop.points) {
      if (crosses_below(before, p, place)) inside = !inside;
      before = p;
    }
  }
  return inside;
}

}  // namespace

ShownPoints::ShownPoints(const Part& part, std::span<const ViewWanted> wanted,
                         std::span<const PartDrawing> views)
    : part_(part), wanted_(wanted), views_(views), is_whole_(wanted.size()) {
  const Bounds box = bounds_of_used(part.mesh);
  reach_ = kSeen * glm::distance(box.low, box.high);
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const ViewWanted& view = wanted[k];
    for (std::size_t i = 0; i < part.mesh.objects.size(); ++i) {
      const bool is_whole = view.position && !view.uncut.empty() &&
                            view.uncut[part.part_of[i]] != 0 &&
                            goes_through(part, i, view.kind, *view.position);
      is_whole_[k].push_back(is_whole ? 1 : 0);
    }
  }
}

/// At the place of the least of four points around it: those that lie on an edge, or on a face that
/// is seen edge-on, are seen where a face of theirs is.
double ShownPoints::depth_behind(std::size_t view, const Point3& point) const {
  const ViewWanted& wanted = wanted_[view];
  const Point3 p = in_view(wanted.kind, point);
  std::array<Point2, 4> places;
  std::array<double, 4> front;
  front.fill(-HUGE_VAL);
  for (std::size_t k = 0; k < 4; ++k) {
    places[k] = Point2(p) + 0.5 * reach_ * Point2(k % 2 == 0 ? -1.0 : 1.0, k < 2 ? -1.0 : 1.0);
    if (wanted.position && is_within_loops(views_[view].cut, places[k]))
      front[k] = *wanted.position;
  }
  std::vector<Point3> face;
  for (std::size_t i = 0; i < part_.mesh.objects.size(); ++i) {
    const Mesh::Object& object = part_.mesh.objects[i];
    const bool is_cut = wanted.position && is_whole_[view][i] == 0;
    for (std::size_t f = object.first_face; f < object.first_face + object.faces; ++f) {
      face.clear();
      for (const std::uint32_t v : part_.mesh.face(f)) {
        face.push_back(in_view(wanted.kind, part_.mesh.vertices[v]));
      }
      for (std::size_t k = 0; k < 4; ++k) {
        const auto depth = depth_at(face, places[k]);
        if (depth && !(is_cut && *depth > *wanted.position)) front[k] = std::max(front[k], *depth);
      }
    }
  }
  double least = HUGE_VAL;
  for (const double z : front) {
    if (z >= p.z - reach_) least = std::min(least, z <= p.z + reach_ ? 0.0 : z - p.z);
  }
  return least;
}

std::size_t ShownPoints::view_of(const Point3& point) const {
  std::size_t best = 0;
  double least = HUGE_VAL;
  for (std::size_t k = 0; k < wanted_.size(); ++k) {
    const double behind = depth_behind(k, point);
    if (behind == 0.0) return k;
    if (behind >= least) continue;
    least = behind;
    best = k;
  }
  return best;
}

}  // namespace displayfile
