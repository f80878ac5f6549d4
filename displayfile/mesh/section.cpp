#include "displayfile/mesh/section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <span>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "clip/base/error.h"
#include "clip/base/round_to_nearest.h"
#include "clip/geometry/planarity.h"
#include "clip/geometry/secret_hash.h"
#include "displayfile/mesh/joined_by_bridges.h"
#include "displayfile/mesh/welded_faces.h"
#include "hidden/exact/double_double.h"
#include "hidden/exact/exact_number.h"
#include "hidden/exact/rounding.h"
#include "hidden/triangles/triangulation.h"

namespace displayfile {

namespace {

/// normal . p - distance: its sign is exact, its value accurate to about 30 digits of its terms.
class CuttingPlane {
 public:
  /// Points within reach lie in the plane.
  CuttingPlane(const SectionPlane& plane, double reach)
      : plane_(plane), reach_(reach * glm::length(plane.normal)) {}

  bool is_in_reach(const Point3& p) const { return std::abs(value(p).high) <= reach_; }
  bool is_before(const Point3& p) const { return is_in_reach(p) || side(p) >= 0; }
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
  /// The coordinate axis perpendicular to the plane, or -1.
  int own_axis() const {
    for (int k = 0; k < 3; ++k) {
      if (plane_.normal[(k + 1) % 3] == 0.0 && plane_.normal[(k + 2) % 3] == 0.0) return k;
    }
    return -1;
  }
  const SectionPlane& plane() const { return plane_; }

 private:
  SectionPlane plane_;
  double reach_;
};

/// Where an edge meets the plane, to twice the digits of a double.
using CutPoint = std::array<DoubleDouble, 3>;

CutPoint cut_point(const CuttingPlane& plane, const Point3& behind, const Point3& before) {
  const DoubleDouble v0 = plane.value(behind), v1 = plane.value(before);
  CutPoint point;
  for (int k = 0; k < 3; ++k) {
    DoubleDouble& coordinate = point[static_cast<std::size_t>(k)];
    if (v1.high == 0.0 || plane.is_in_reach(before)) {
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

/// The edges that the plane cuts, each once, from the end behind the plane to the end in front.
class CutEdges {
 public:
  CutEdges(const CuttingPlane& plane, const WeldedFaces& faces, const std::vector<bool>& is_before,
           double reach)
      : plane_(plane), faces_(faces), is_before_(is_before), sides_(faces, reach) {}

  /// The number of a cut edge. If vertices lie along the edge, it is cut between two of them, as
  /// are the neighbours' edges that end there.
  std::uint32_t number(std::uint32_t behind, std::uint32_t before) {
    for (const std::uint32_t vertex : sides_.along(behind, before)) {
      (is_before_[vertex] ? before : behind) = vertex;
      if (is_before_[vertex]) return number_of_whole(behind, before);
    }
    const auto back = sides_.along(before, behind);
    for (const std::uint32_t vertex : back) {
      (is_before_[vertex] ? before : behind) = vertex;
      if (!is_before_[vertex]) break;
    }
    return number_of_whole(behind, before);
  }

  std::vector<CutPoint> points;

 private:
  std::uint32_t number_of_whole(std::uint32_t behind, std::uint32_t before) {
    const auto [at, is_new] = numbers_.try_emplace((std::uint64_t{behind} << 32) | before,
                                                   static_cast<std::uint32_t>(points.size()));
    if (is_new)
      points.push_back(cut_point(plane_, faces_.vertices[behind], faces_.vertices[before]));
    return at->second;
  }

  const CuttingPlane& plane_;
  const WeldedFaces& faces_;
  const std::vector<bool>& is_before_;
  SidesWithVertices sides_;
  std::unordered_map<std::uint64_t, std::uint32_t, SecretHash> numbers_;
};

/// A link from one cut edge to another, through a face.
struct Link {
  std::uint32_t from, to;
};

/// A vertex of a face, or a cut edge, and the origin of the side that ends there
/// (Section::side_of).
struct Corner {
  std::uint32_t vertex;
  std::size_t side;
};

/// A part of a face's outline behind the plane, between two cut edges.
struct Chain {
  std::uint32_t enters, leaves;  ///< the cut edges
  std::size_t last_side;         ///< the side that leaves
  std::vector<Corner> kept;      ///< corners between them
  std::size_t next = 0;          ///< the next chain along the plane
};

/// Cuts one face whose outline crosses the plane more than once, such as a concave one or one with
/// holes.
class FaceCutter {
 public:
  FaceCutter(CutEdges& edges, const std::vector<bool>& is_before)
      : edges_(edges), is_before_(is_before) {}

  /// The chains of a face whose outline crosses the plane, each linked to the next.
  std::span<const Chain> chains(std::span<const Corner> face) {
    find_chains(face);
    put_ends_in_order();
    join_ends_of_bridges();
    join_other_ends();
    return chains_;
  }

 private:
  /// An end of a chain, on the plane.
  struct End {
    std::size_t chain;
    bool enters;
  };

  void find_chains(std::span<const Corner> face) {
    chains_.clear();
    const std::size_t n = face.size();
    const auto is_before = [&](std::size_t k) -> bool { return is_before_[face[k % n].vertex]; };
    std::size_t start = 0;  // the first vertex behind after one before
    while (is_before(start) || !is_before(start + n - 1)) ++start;
    std::uint32_t from = face[(start + n - 1) % n].vertex;
    for (std::size_t k = 0; k < n; ++k) {
      const Corner& to = face[(start + k) % n];
      if (!is_before_[to.vertex]) {
        if (is_before_[from]) chains_.push_back({edges_.number(to.vertex, from), 0, 0, {}});
        chains_.back().kept.push_back(to);
      } else if (!is_before_[from]) {
        chains_.back().leaves = edges_.number(from, to.vertex);
        chains_.back().last_side = to.side;
      }
      from = to.vertex;
    }
  }

  std::uint32_t edge(const End& end) const {
    return end.enters ? chains_[end.chain].enters : chains_[end.chain].leaves;
  }
  const CutPoint& place(const End& end) const { return edges_.points[edge(end)]; }

  void join(const End& a, const End& b) {
    const auto& [leaves, enters] = a.enters ? std::pair(b, a) : std::pair(a, b);
    chains_[leaves.chain].next = enters.chain;
  }

  /// Sorts the ends along the line in which the face meets the plane.
  void put_ends_in_order() {
    ends_.clear();
    for (std::size_t k = 0; k < chains_.size(); ++k) {
      ends_.push_back({k, true});
      ends_.push_back({k, false});
    }
    std::size_t axis = 0;
    double longest = -1.0;
    for (std::size_t k = 0; k < 3; ++k) {
      double low = place(ends_.front())[k].high, high = low;
      for (const End& end : ends_) {
        low = std::min(low, place(end)[k].high);
        high = std::max(high, place(end)[k].high);
      }
      if (high - low > longest) {
        longest = high - low;
        axis = k;
      }
    }
    std::ranges::stable_sort(ends_, {}, [&](const End& end) {
      const DoubleDouble& x = place(end)[axis];
      return std::tuple(x.high, x.low, edge(end));
    });
  }

  /// Joins the ends of bridges. A bridge enters and leaves in one cut edge, so it takes nothing of
  /// the plane, wherever it runs.
  void join_ends_of_bridges() {
    std::size_t left = 0;  // ends that are not of bridges, moved to the front
    for (const End end : ends_) {
      const End* const last = left > 0 ? &ends_[left - 1] : nullptr;
      if (last != nullptr && edge(*last) == edge(end) && last->enters != end.enters) {
        join(*last, end);
        --left;
      } else {
        ends_[left++] = end;
      }
    }
    ends_.resize(left);
  }

  /// Joins the other ends. Within the face, leaving and entering ends alternate: each waits for the
  /// next one of the other kind, first come, first served. Ends at one point may be in any order.
  void join_other_ends() {
    std::size_t first = 0, waiting = 0;  // waiting ends, moved to the front
    for (const End end : ends_) {
      if (first == waiting || ends_[first].enters == end.enters) {
        ends_[waiting++] = end;
      } else {
        join(ends_[first++], end);
      }
    }
  }

  CutEdges& edges_;
  const std::vector<bool>& is_before_;
  std::vector<Chain> chains_;
  std::vector<End> ends_;
};

/// Cuts faces one after another, and keeps the parts behind the plane.
class Cutter {
 public:
  Cutter(const CuttingPlane& plane, const WeldedFaces& faces, double reach)
      : faces_(faces), face_cutter_(edges, is_before_), edges(plane, faces, is_before_, reach) {
    for (const Point3& p : faces.vertices) is_before_.push_back(plane.is_before(p));
    behind.vertices = faces.vertices;
    behind.first_corner.push_back(0);
  }

  void cut_all(std::span<const Mesh::Object> objects) {
    for (const Mesh::Object& object : objects) {
      first_links.push_back(links.size());
      const std::size_t first = behind.faces();
      for (face_ = object.first_face; face_ < object.first_face + object.faces; ++face_) cut();
      behind.objects.push_back({object.name, first, behind.faces() - first});
    }
    const auto first = static_cast<std::uint32_t>(faces_.vertices.size());
    for (const CutPoint& p : edges.points) behind.vertices.push_back(rounded_point(p));
    for (std::uint32_t& corner : behind.corners) {
      if (corner >= kOfCutEdge) corner = first + (corner - kOfCutEdge);
    }
  }

 private:
  static constexpr std::uint32_t kOfCutEdge = 0x80000000u;

  void keep(std::span<const Corner> face) {
    for (const Corner& corner : face) {
      behind.corners.push_back(corner.vertex);
      side_of.push_back(corner.side);
    }
    behind.first_corner.push_back(behind.corners.size());
    face_of.push_back(face_);
  }

  void cut() {
    const std::span<const std::uint32_t> face = faces_.face(face_);
    const auto before = std::ranges::count_if(face, [&](auto v) { return is_before_[v]; });
    if (before == std::ssize(face)) return;
    corners_.clear();
    for (std::size_t k = 0; k < face.size(); ++k) {
      corners_.push_back({face[k], faces_.first_corner[face_] + k});
    }
    if (before == 0) {
      keep(corners_);
    } else if (is_flat_face(face)) {
      cut_flat();
    } else {
      cut_triangles();
    }
  }

  /// True if the face is planar; otherwise its points are in polygon_.
  bool is_flat_face(std::span<const std::uint32_t> face) {
    if (face.size() == 3) return true;
    polygon_.clear();
    for (const std::uint32_t v : face) polygon_.push_back(faces_.vertices[v]);
    return is_flat(polygon_);
  }

  /// Cuts the triangles of a face that is not planar, whose points are in polygon_.
  void cut_triangles() {
    for (const auto& [vertex, edge_visible] : triangulation_.triangulate(polygon_)) {
      std::array<Corner, 3> triangle{};
      for (std::size_t k = 0; k < 3; ++k) {
        triangle[k] = corners_[vertex[k]];
        if (edge_visible[k] == 0) triangle[k].side = Section::kNoSide;
      }
      const auto before =
          std::ranges::count_if(triangle, [&](auto& corner) { return is_before_[corner.vertex]; });
      if (before == 0) keep(triangle);
      if (before == 1 || before == 2) cut_once(triangle);
    }
  }

  void cut_flat() {
    std::size_t crossings = 0;
    std::uint32_t from = corners_.back().vertex;
    for (const Corner& to : corners_) {
      if (is_before_[from] != is_before_[to.vertex]) ++crossings;
      from = to.vertex;
    }
    if (crossings == 2) {
      cut_once(corners_);
    } else {
      cut_apart();
    }
  }

  /// Cuts a face whose outline crosses the plane exactly twice.
  void cut_once(std::span<const Corner> face) {
    Link link{};
    piece_.clear();
    std::uint32_t from = face.back().vertex;
    for (const Corner& to : face) {
      const bool leaves = is_before_[to.vertex];
      if (is_before_[from] != leaves) {
        const std::uint32_t edge =
            leaves ? edges.number(from, to.vertex) : edges.number(to.vertex, from);
        (leaves ? link.to : link.from) = edge;
        piece_.push_back({kOfCutEdge + edge, leaves ? to.side : Section::kInPlane});
      }
      if (!leaves) piece_.push_back(to);
      from = to.vertex;
    }
    links.push_back(link);
    keep(piece_);
  }

  /// Cuts a face whose outline crosses the plane more often: its chains are closed along the plane
  /// into loops, which stay one even-odd polygon.
  void cut_apart() {
    const std::span<const Chain> chains = face_cutter_.chains(corners_);
    std::vector<bool> is_taken(chains.size(), false);
    std::vector<std::vector<Corner>> loops;
    for (std::size_t first = 0; first < chains.size(); ++first) {
      if (is_taken[first]) continue;
      auto& loop = loops.emplace_back();
      for (std::size_t k = first; !is_taken[k]; k = chains[k].next) {
        is_taken[k] = true;
        add_to(loop, chains[k], chains[chains[k].next]);
      }
      if (loop.back().vertex == loop.front().vertex) {
        loop.front().side = loop.back().side;
        loop.pop_back();
      }
    }
    keep(joined_by_bridges<Corner>(loops, [](const Corner& corner) {
      return Corner{corner.vertex, Section::kNoSide};
    }));
  }

  /// Appends a chain to a loop. Where a bridge is cut in both directions, no side lies along the
  /// plane.
  void add_to(std::vector<Corner>& loop, const Chain& chain, const Chain& next) {
    const std::uint32_t enters = kOfCutEdge + chain.enters;
    if (loop.empty() || loop.back().vertex != enters) {
      loop.push_back({enters, Section::kInPlane});
    }
    loop.insert(loop.end(), chain.kept.begin(), chain.kept.end());
    loop.push_back({kOfCutEdge + chain.leaves, chain.last_side});
    if (next.enters != chain.leaves) links.push_back({next.enters, chain.leaves});
  }

  const WeldedFaces& faces_;
  std::vector<bool> is_before_;
  Triangulation triangulation_;
  std::vector<Point3> polygon_;
  std::size_t face_ = 0;         // the face being cut
  std::vector<Corner> corners_;  // its corners
  std::vector<Corner> piece_;
  FaceCutter face_cutter_;

 public:
  CutEdges edges;
  std::vector<Link> links;
  std::vector<std::size_t> first_links;  ///< where each object's links begin
  Mesh behind;
  std::vector<std::size_t> face_of, side_of;
};

using Loop = std::vector<std::uint32_t>;

/// Follows links between cut edges until they return to their start.
class LinkChains {
 public:
  explicit LinkChains(std::size_t edges) : balance_(edges, 0), first_(edges, kNone) {}

  /// Adds the loops formed by links. Adds none and returns false unless equally many links leave
  /// and reach each edge.
  bool add_loops(std::span<const Link> links, std::vector<Loop>& loops) {
    if (!come_back(links)) return false;
    next_.assign(links.size(), kNone);
    for (std::uint32_t i = 0; i < links.size(); ++i) {
      next_[i] = std::exchange(first_[links[i].from], i);
    }
    for (const Link& link : links) {
      while (first_[link.from] != kNone) add_loop(links, link.from, loops.emplace_back());
    }
    return true;
  }

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

  bool come_back(std::span<const Link> links) {
    for (const Link& link : links) {
      ++balance_[link.from];
      --balance_[link.to];
    }
    bool all = true;
    for (const Link& link : links) {
      for (const std::uint32_t edge : {link.from, link.to}) {
        if (std::exchange(balance_[edge], 0) != 0) all = false;
      }
    }
    return all;
  }

  void add_loop(std::span<const Link> links, std::uint32_t start, Loop& loop) {
    std::uint32_t at = start;
    do {
      loop.push_back(at);
      const std::uint32_t link = first_[at];
      first_[at] = next_[link];
      at = links[link].to;
    } while (at != start);
  }

  std::vector<int> balance_;          // of each edge: links that leave it, less those that arrive
  std::vector<std::uint32_t> first_;  // of those that leave an edge
  std::vector<std::uint32_t> next_;   // that leaves the same edge
};

/// Finds the loops of each object separately, so that touching objects keep the sides between them;
/// objects not closed by themselves are combined. False if those are not closed either.
bool find_loops(const Cutter& cut, std::vector<Loop>& loops, std::vector<std::size_t>& object_of) {
  LinkChains chains(cut.edges.points.size());
  std::vector<Link> others;
  for (std::size_t k = 0; k < cut.first_links.size(); ++k) {
    const std::size_t first = cut.first_links[k];
    const std::size_t end =
        k + 1 < cut.first_links.size() ? cut.first_links[k + 1] : cut.links.size();
    const auto own = std::span(cut.links).subspan(first, end - first);
    if (!chains.add_loops(own, loops)) others.insert(others.end(), own.begin(), own.end());
    object_of.resize(loops.size(), k);
  }
  const bool closed = chains.add_loops(others, loops);
  object_of.resize(loops.size(), cut.first_links.size());
  return closed;
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

/// The points of a loop, without repeated ones and without parts that run back on themselves, where
/// the plane touches an edge of the mesh.
std::vector<Point3> outline(std::span<const CutPoint> cut_points, const Loop& loop) {
  std::vector<Point3> points;
  const auto folds_at_end = [&](const Point3& next) {
    const std::size_t n = points.size();
    return n > 0 && (points[n - 1] == next || (n > 1 && points[n - 2] == next));
  };
  for (const std::uint32_t edge : loop) {
    const Point3 p = rounded_point(cut_points[edge]);
    if (folds_at_end(p)) {
      if (points.back() != p) points.pop_back();
    } else {
      points.push_back(p);
    }
  }
  std::size_t first = 0;  // the last point is followed by the first
  while (points.size() > first + 1) {
    if (folds_at_end(points[first])) {
      points.pop_back();
    } else if (points.back() == points[first + 1]) {
      ++first;
    } else {
      break;
    }
  }
  points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(first));
  return points;
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
  const RoundToNearest nearest;
  require_plane(plane);
  const double reach = entered_reach(mesh);
  const CuttingPlane cutting(plane, reach);
  const WeldedFaces faces = weld(mesh, reach);
  Cutter cutter(cutting, faces, reach);
  const Mesh::Object whole{"", 0, mesh.faces()};
  cutter.cut_all(mesh.objects.empty() ? std::span(&whole, 1) : std::span(mesh.objects));
  Section result;
  std::vector<Loop> loops;
  std::vector<std::size_t> object_of;
  result.closed = find_loops(cutter, loops, object_of);
  result.behind = std::move(cutter.behind);
  result.behind.rounding = mesh.rounding;
  result.face_of = std::move(cutter.face_of);
  result.side_of = std::move(cutter.side_of);
  if (!result.closed) return result;

  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::abs(plane.normal[k]) > std::abs(plane.normal[axis])) axis = k;
  }
  DoubleDouble sum;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    sum = sum + twice_area(cutter.edges.points, loops[i], static_cast<std::size_t>(axis));
    std::vector<Point3> points = outline(cutter.edges.points, loops[i]);
    if (points.size() <= 2) continue;
    result.loops.push_back(std::move(points));
    result.object_of.push_back(object_of[i]);
  }
  result.area = 0.5 * sum.high * (glm::length(plane.normal) / plane.normal[axis]);
  return result;
}

}  // namespace displayfile
