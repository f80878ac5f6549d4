#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <span>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "clip/base/round_to_nearest.h"
#include "clip/geometry/back_face.h"
#include "clip/geometry/corners.h"
#include "clip/geometry/crease_angle.h"
#include "clip/geometry/point_row.h"
#include "clip/geometry/unit.h"
#include "displayfile/graphics_system.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/mesh/welded_faces.h"
#include "hidden/disjoint_sets.h"
#include "hidden/touching/needle.h"

namespace displayfile {

namespace {

constexpr std::uint32_t kNoCorner = 0xFFFFFFFFu;

/// Faces with area, without corners that repeat the one before, and with the vertices that lie
/// along their sides as corners. Corners are counted through all faces.
struct SmoothedFaces {
  WeldedFaces welded;
  std::vector<std::size_t> first_corner;  // of welded
  std::vector<std::uint32_t> of_entered;  // of each corner of the entered faces, or kNoCorner

  SmoothedFaces() = default;
  SmoothedFaces(const SmoothedFaces&) = delete;
  SmoothedFaces& operator=(const SmoothedFaces&) = delete;
  std::size_t faces() const { return first_corner.size() - 1; }
  const Point3& point(std::size_t corner) const { return welded.vertices[welded.corners[corner]]; }
};

/// Adds a face's corners, except those that repeat the one before.
void add_corners(std::span<const std::uint32_t> face, std::size_t first, SmoothedFaces& kept) {
  std::vector<std::uint32_t>& corners = kept.welded.corners;
  const std::size_t start = corners.size();
  for (std::size_t k = 0; k < face.size(); ++k) {
    const bool repeats = corners.size() > start && corners.back() == face[k];
    if (!repeats) corners.push_back(face[k]);
    kept.of_entered[first + k] = static_cast<std::uint32_t>(corners.size() - 1);
  }
  if (corners.back() == corners[start]) {  // a face with area has others between
    corners.pop_back();
    for (std::size_t k = 0; k < face.size(); ++k) {
      std::uint32_t& of_corner = kept.of_entered[first + k];
      if (of_corner == corners.size()) of_corner = static_cast<std::uint32_t>(start);
    }
  }
  kept.first_corner.push_back(corners.size());
}

/// Keeps the faces that are not needles.
void keep_faces_with_area(WeldedFaces entered, double reach, SmoothedFaces& kept) {
  kept.first_corner.assign(1, 0);
  kept.of_entered.assign(entered.corners.size(), kNoCorner);
  kept.welded.corners.reserve(entered.corners.size());
  std::size_t corner = 0;  // of those entered
  for (std::size_t i = 0; i < entered.faces(); ++i) {
    const auto face = entered.face(i);
    const PointRow polygon(entered.vertices, face);
    const bool has_area =
        !is_within_reach_of_line(polygon, reach) && newell_normal(polygon.row()) != Point3(0.0);
    if (has_area) add_corners(face, corner, kept);
    corner += face.size();
  }
  kept.welded.vertices = std::move(entered.vertices);
  kept.welded.first_corner = kept.first_corner;
}

/// Makes vertices along sides into corners.
void add_vertices_along_sides(SmoothedFaces& faces, double reach) {
  const SidesWithVertices sides(faces.welded, reach);
  if (!sides.any()) return;
  std::vector<std::uint32_t> corners, now(faces.welded.corners.size());
  std::vector<std::size_t> first_corner(1, 0);
  std::size_t corner = 0;
  for (std::size_t i = 0; i < faces.faces(); ++i) {
    std::uint32_t from = faces.welded.face(i).back();
    for (const std::uint32_t to : faces.welded.face(i)) {
      const auto along = sides.along(from, to);
      corners.insert(corners.end(), along.begin(), along.end());
      now[corner++] = static_cast<std::uint32_t>(corners.size());
      corners.push_back(to);
      from = to;
    }
    first_corner.push_back(corners.size());
  }
  for (std::uint32_t& of_corner : faces.of_entered) {
    if (of_corner != kNoCorner) of_corner = now[of_corner];
  }
  faces.welded.corners = std::move(corners);
  faces.first_corner = std::move(first_corner);
  faces.welded.first_corner = faces.first_corner;
}

/// A face's use of the side between two vertices.
struct SideUse {
  std::uint32_t low, high;  // vertices
  std::uint32_t face;
  std::uint32_t at_low, at_high;  // its corners there
  bool runs_up;                   // from low to high
};

/// Joins the corners around each vertex between which no crease runs. Each corner has two members,
/// 2 k as it is and 2 k + 1 for the face reversed, so that the sets know which faces of one surface
/// run the other way.
class CornersJoined {
 public:
  CornersJoined(const SmoothedFaces& faces, const CreaseAngle& crease)
      : faces_(faces), crease_(crease), sets_(2 * faces.welded.corners.size()) {
    find_normals();
    find_uses();
    for (auto first = uses_.cbegin(); first != uses_.cend();) {
      const auto end = std::find_if(first, uses_.cend(), [&](const SideUse& use) {
        return use.low != first->low || use.high != first->high;
      });
      join_around({&*first, static_cast<std::size_t>(end - first)});
      first = end;
    }
  }

  const Point3& normal(std::size_t face) const { return normals_[face]; }
  std::uint32_t set_of(std::size_t corner) {
    return sets_.name(static_cast<std::uint32_t>(2 * corner));
  }
  std::uint32_t set_of_reversed(std::size_t corner) {
    return sets_.name(static_cast<std::uint32_t>(2 * corner + 1));
  }

 private:
  void find_normals() {
    normals_.reserve(faces_.faces());
    for (std::size_t i = 0; i < faces_.faces(); ++i) {
      const PointRow polygon(faces_.welded.vertices, faces_.welded.face(i));
      normals_.push_back(unit(newell_normal(polygon.row())));
    }
  }

  void find_uses() {
    const std::vector<std::uint32_t>& vertex = faces_.welded.corners;
    uses_.reserve(vertex.size());
    for (std::size_t i = 0; i < faces_.faces(); ++i) {
      auto from = static_cast<std::uint32_t>(faces_.first_corner[i + 1] - 1);
      for (std::size_t k = faces_.first_corner[i]; k < faces_.first_corner[i + 1]; ++k) {
        const auto to = static_cast<std::uint32_t>(k);
        const std::uint32_t a = vertex[from], b = vertex[to];
        const auto face = static_cast<std::uint32_t>(i);
        uses_.push_back(a < b ? SideUse{a, b, face, from, to, true}
                              : SideUse{b, a, face, to, from, false});
        from = to;
      }
    }
    std::ranges::sort(uses_, [](const SideUse& a, const SideUse& b) {
      return std::tie(a.low, a.high, a.at_high) < std::tie(b.low, b.high, b.at_high);
    });
  }

  /// The normal of the face, reversed unless it uses the side from low to high, as CreaseAngle
  /// requires.
  Point3 turned_normal(const SideUse& use) const {
    return use.runs_up ? normals_[use.face] : -normals_[use.face];
  }

  void join_around(std::span<const SideUse> uses) {
    if (uses.size() == 2) join(uses[0], uses[1]);
    if (uses.size() > 2) join_most_level(uses);
  }

  void join(const SideUse& a, const SideUse& b) {
    if (crease_.exceeded(turned_normal(a), turned_normal(b))) return;
    const bool reversed = a.runs_up == b.runs_up;
    const auto join_corners = [&](std::uint32_t i, std::uint32_t j) {
      sets_.join(2 * i, 2 * j + (reversed ? 1 : 0));
      sets_.join(2 * i + 1, 2 * j + (reversed ? 0 : 1));
    };
    join_corners(a.at_low, b.at_low);
    join_corners(a.at_high, b.at_high);
  }

  /// Where more than two faces share a side, compares each with the one that it meets at the
  /// smallest angle: the one whose turned normal is nearest to the opposite of its own.
  void join_most_level(std::span<const SideUse> uses) {
    const Point3 along = faces_.point(uses[0].at_high) - faces_.point(uses[0].at_low);
    const Point3 right = turned_normal(uses[0]);
    const Point3 up = glm::cross(unit(along), right);
    around_.clear();
    for (const SideUse& use : uses) around_.push_back({place_around(right, up, use), &use});
    std::ranges::sort(around_, [](const Around& a, const Around& b) {
      return std::tie(a.place, a.use->at_high) < std::tie(b.place, b.use->at_high);
    });
    for (const Around& one : around_) {
      const double opposite = one.place < 2.0 ? one.place + 2.0 : one.place - 2.0;
      const auto after = std::ranges::lower_bound(around_, opposite, {}, &Around::place);
      const SideUse& next = *(after == around_.end() ? around_.front() : *after).use;
      const SideUse& before = *(after == around_.begin() ? around_.back() : *(after - 1)).use;
      const Point3 own = turned_normal(*one.use);
      const bool next_is_nearer =
          glm::dot(own, turned_normal(next)) <= glm::dot(own, turned_normal(before));
      const SideUse& other = next_is_nearer ? next : before;
      if (&other != one.use) join(*one.use, other);
    }
  }

  /// Increases with the angle of the turned normal around the side, from 0 to 4 for a full turn.
  double place_around(const Point3& right, const Point3& up, const SideUse& use) const {
    const Point3 normal = turned_normal(use);
    const double x = glm::dot(normal, right), y = glm::dot(normal, up);
    const double size = std::abs(x) + std::abs(y);
    if (!(size > 0.0)) return 0.0;
    return y >= 0.0 ? 1.0 - x / size : 3.0 + x / size;
  }

  struct Around {
    double place;
    const SideUse* use;
  };

  const SmoothedFaces& faces_;
  const CreaseAngle& crease_;
  DisjointSets sets_;
  std::vector<Point3> normals_;  // of the faces, of length 1
  std::vector<SideUse> uses_;
  std::vector<Around> around_;
};

/// Returns the sum of the weighted normals of each set of corners.
std::vector<Point3> sums_of_sets(const SmoothedFaces& faces, CornersJoined& joined) {
  std::vector<Point3> sums(2 * faces.welded.corners.size(), Point3(0.0));
  for (std::size_t i = 0; i < faces.faces(); ++i) {
    const std::size_t first = faces.first_corner[i], sides = faces.first_corner[i + 1] - first;
    const auto point = [&](std::size_t k) { return faces.point(first + k); };
    for (std::size_t k = 0; k < sides; ++k) {
      const Point3 before = point(previous_corner(k, sides)) - point(k);
      const Point3 after = point(next_corner(k, sides)) - point(k);
      const Point3 weighted = angle_between(before, after) * joined.normal(i);
      sums[joined.set_of(first + k)] += weighted;
      sums[joined.set_of_reversed(first + k)] -= weighted;
    }
  }
  return sums;
}

/// For each corner of the faces, the mean of the normals of the faces around its vertex that are
/// connected with its own by sides that end there and are not creases, weighted by their angles
/// there (displayfile/looks/gouraud.md). Faces of opposite orientation are reversed for it. Sides
/// on which others end, within reach, are shared with these; needles count for nothing. Of any
/// length; zero: the face's own normal, also where the mean is within CreaseAngle::kCoplanar of it.
std::vector<Point3> crease_normals(WeldedFaces entered, double reach, const CreaseAngle& crease) {
  SmoothedFaces faces;
  keep_faces_with_area(std::move(entered), reach, faces);
  add_vertices_along_sides(faces, reach);
  CornersJoined joined(faces, crease);
  std::vector<Point3> mean = sums_of_sets(faces, joined);
  // Backward, since a set's sum is at the smallest of its members.
  for (std::size_t i = faces.faces(); i-- > 0;) {
    for (std::size_t k = faces.first_corner[i + 1]; k-- > faces.first_corner[i];) {
      const Point3 sum = mean[joined.set_of(k)];
      const bool is_own = angle_between(sum, joined.normal(i)) <= CreaseAngle::kCoplanar;
      mean[2 * k] = is_own ? Point3(0.0) : sum;
    }
  }
  std::vector<Point3> normals;
  normals.reserve(faces.of_entered.size());
  for (const std::uint32_t k : faces.of_entered) {
    normals.push_back(k == kNoCorner ? Point3(0.0) : mean[2 * std::size_t{k}]);
  }
  return normals;
}

constexpr std::string_view kHasNormals =
    "the crease angle has no effect: the file has normals of all vertices";

/// The angle between the sides that meet in the corner; 0 if one has no length.
double angle_at(const Point3& corner, const Point3& before, const Point3& after) {
  return angle_between(before - corner, after - corner);
}

/// For each vertex, the sum of the normals of the faces around it, times their angles there.
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
      const Point3& before = polygon[previous_corner(k, polygon.size())];
      const Point3& after = polygon[next_corner(k, polygon.size())];
      sum[face[k]] += angle_at(polygon[k], before, after) * unit(normal);
    }
  }
  return sum;
}

bool has_normal(const Mesh& mesh, std::size_t corner) { return mesh.normal(corner) != Point3(0.0); }

bool has_all_normals(const Mesh& mesh) {
  for (std::size_t k = 0; k < mesh.corners.size(); ++k) {
    if (!has_normal(mesh, k)) return false;
  }
  return true;
}

/// Sets the normal of each corner for which the mesh has none.
void add_normals(std::span<const Point3> of_corners, Mesh& mesh) {
  for (std::size_t k = 0; k < mesh.corners.size(); ++k) {
    if (has_normal(mesh, k)) continue;
    mesh.corner_normals[k] = static_cast<std::uint32_t>(mesh.normals.size());
    mesh.normals.push_back(of_corners[k]);
  }
}

}  // namespace

void complete_normals(Mesh& mesh, double crease_degrees) {
  const RoundToNearest nearest;
  require_crease_angle(crease_degrees);
  mesh.corner_normals.resize(mesh.corners.size(), Mesh::kNoNormal);
  if (has_all_normals(mesh)) return;
  const double reach = entered_reach(mesh);
  WeldedFaces faces = weld(mesh, reach);
  if (crease_degrees < kNoCrease) {
    return add_normals(crease_normals(std::move(faces), reach, CreaseAngle(crease_degrees)), mesh);
  }
  const std::vector<Point3> around = angle_weighted_normals(faces);
  const auto first = static_cast<std::uint32_t>(mesh.normals.size());
  for (std::size_t k = 0; k < mesh.corners.size(); ++k) {
    if (!has_normal(mesh, k)) mesh.corner_normals[k] = first + faces.corners[k];
  }
  mesh.normals.insert(mesh.normals.end(), around.begin(), around.end());
}

void complete_normals(Mesh& mesh, const GraphicsSystem& system) {
  mesh.corner_normals.resize(mesh.corners.size(), Mesh::kNoNormal);
  if (system.explicit_settings().contains(Setting::crease_angle) && has_all_normals(mesh)) {
    mesh.skipped.warnings.emplace_back(kHasNormals);
  }
  complete_normals(mesh, system.looks().crease_degrees);
}

}  // namespace displayfile
