#include "displayfile/solids/solid_faces.h"

#include <algorithm>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <span>
#include <utility>
#include <vector>

#include "clip/geometry/back_face.h"
#include "clip/geometry/equal_points.h"
#include "clip/geometry/unit.h"

namespace displayfile {

namespace {

using CutCorner = SolidFaces::Corner;

Point3 unit_normal(const Point3& n) { return n == Point3(0.0) ? n : unit(n); }

/// The same faces, with vertices of equal position merged and normals of length 1.
SolidFaces welded(const SolidFaces& solid) {
  SolidFaces result = solid;
  result.vertices.clear();
  EqualPoints table(result.vertices, solid.corners.size());
  for (CutCorner& corner : result.corners) {
    corner.vertex = table.number_of(solid.vertices[corner.vertex] + Point3(0.0));  // -0 is 0
    corner.normal = unit_normal(corner.normal);
  }
  return result;
}

/// A side of the cut face.
struct CutLink {
  std::uint32_t from, to;
  auto operator<=>(const CutLink&) const = default;
};

/// Cuts a welded solid by one plane.
class OnePlane {
 public:
  OnePlane(const SolidFaces& solid, const CuttingPlanes& planes, int n)
      : solid_(solid), planes_(planes), n_(n), table_(points_, corners_and_vertices(solid)) {
    for (const Point3& p : solid.vertices) {
      table_.number_of(p);
      is_inside_.push_back(planes.distance(n, p) > 0.0);
    }
  }
  bool cuts() const { return std::ranges::find(is_inside_, false) != is_inside_.end(); }

  SolidFaces cut(std::uint32_t attributes) {
    result_.attributes = solid_.attributes;
    std::size_t first = 0;
    for (const SolidFaces::Face& face : solid_.faces) {
      chains_.clear();
      for (std::size_t i = first; i < face.end_loop; ++i) cut_loop(solid_.loop(i));
      first = face.end_loop;
      join_chains();
      result_.add(face);
    }
    const std::size_t loops = result_.end_corner.size();
    show_sides_along(add_cut_face(attributes), loops);
    result_.vertices = std::move(points_);
    return std::move(result_);
  }

 private:
  /// A part of a loop that is kept, from where it enters to where it leaves.
  struct Chain {
    std::vector<CutCorner> corners;
    std::size_t next;  ///< the next chain along the plane
  };
  /// An end of a chain, on the plane.
  struct End {
    double place;  ///< along the line in which the face meets the plane
    std::size_t chain;
    bool enters;
  };

  /// Value of edge_visible until the cut face is known.
  static constexpr std::uint8_t kAlongPlane = 2;

  static std::size_t corners_and_vertices(const SolidFaces& solid) {
    return solid.vertices.size() + solid.corners.size();
  }

  CutCorner crossing(const CutCorner& inside, const CutCorner& outside) {
    const auto place_of = [&](const CutCorner& c) {
      return CuttingPlanes::Place{solid_.vertices[c.vertex], c.normal};
    };
    const auto at = planes_.crossing(n_, place_of(inside), place_of(outside));
    return {table_.number_of(at.position + Point3(0.0)), kAlongPlane, at.normal};
  }

  /// Keeps or removes a loop that the plane does not cross; cuts any other into chains.
  void cut_loop(std::span<const CutCorner> loop) {
    const std::size_t n = loop.size();
    if (n == 0) return;
    const auto is_inside = [&](std::size_t k) {
      return static_cast<bool>(is_inside_[loop[k % n].vertex]);
    };
    std::size_t start = 0;
    while (start < n && !(is_inside(start + 1) && !is_inside(start))) ++start;
    if (start == n) {
      if (is_inside(0)) result_.add_loop(loop);
      return;
    }
    for (std::size_t k = start; k < start + n; ++k) {
      const CutCorner &from = loop[k % n], &to = loop[(k + 1) % n];
      if (is_inside(k + 1)) {
        if (!is_inside(k)) chains_.push_back({{crossing(to, from)}, chains_.size()});
        chains_.back().corners.push_back(to);
      } else if (is_inside(k)) {
        CutCorner exit = crossing(from, to);
        exit.edge_visible = to.edge_visible;
        chains_.back().corners.push_back(exit);
      }
    }
  }

  /// Joins the chains of one face: where the plane's line is inside of the face, an end that leaves
  /// is followed by one that enters.
  void join_chains() {
    if (chains_.size() > 1) pair_ends();
    is_joined_.assign(chains_.size(), false);
    for (std::size_t first = 0; first < chains_.size(); ++first) {
      if (is_joined_[first]) continue;
      loop_.clear();
      std::size_t chain = first;
      do {
        is_joined_[chain] = true;
        for (const CutCorner& corner : chains_[chain].corners) add_corner(corner);
        const std::size_t next = chains_[chain].next;
        add_link(chains_[next].corners.front().vertex, chains_[chain].corners.back().vertex);
        chain = next;
      } while (chain != first);
      while (loop_.size() > 1 && loop_.back().vertex == loop_.front().vertex) {
        loop_.front().edge_visible = loop_.back().edge_visible;
        loop_.pop_back();
      }
      result_.add_loop(loop_);
    }
  }

  /// Omits sides of length 0.
  void add_corner(const CutCorner& corner) {
    if (loop_.empty() || loop_.back().vertex != corner.vertex) loop_.push_back(corner);
  }
  void add_link(std::uint32_t from, std::uint32_t to) {
    if (from != to) links_.push_back({from, to});
  }

  /// Along the line, every second interval between two ends is inside of the face: from the end
  /// that leaves to the one that enters. If that is impossible (a polygon that crosses itself),
  /// each chain is closed by itself: the even-odd fill is the same.
  void pair_ends() {
    Point3 low = position(chains_[0].corners.front()), high = low;
    for (const Chain& chain : chains_) {
      for (const CutCorner* end : {&chain.corners.front(), &chain.corners.back()}) {
        low = glm::min(low, position(*end));
        high = glm::max(high, position(*end));
      }
    }
    const Point3 extent = high - low;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0
                     : extent.y >= extent.z                       ? 1
                                                                  : 2;
    ends_.clear();
    for (std::size_t k = 0; k < chains_.size(); ++k) {
      ends_.push_back({position(chains_[k].corners.front())[axis], k, true});
      ends_.push_back({position(chains_[k].corners.back())[axis], k, false});
    }
    std::ranges::stable_sort(ends_, {}, &End::place);
    for (std::size_t i = 0; i < ends_.size(); i += 2) {
      std::size_t k = i + 1;
      while (k + 1 < ends_.size() && ends_[k].enters == ends_[i].enters &&
             ends_[k + 1].place == ends_[i + 1].place) {
        ++k;
      }
      if (ends_[k].enters == ends_[i].enters) return;  // chains by themselves
      std::swap(ends_[i + 1], ends_[k]);
    }
    for (std::size_t i = 0; i < ends_.size(); i += 2) {
      const End &a = ends_[i], &b = ends_[i + 1];
      const auto& [leaves, enters] = a.enters ? std::pair(b, a) : std::pair(a, b);
      chains_[leaves.chain].next = enters.chain;
    }
  }
  const Point3& position(const CutCorner& corner) const { return points_[corner.vertex]; }

  /// Links in both directions cancel: the solid touches the plane there. The others are followed
  /// until they return, since equally many leave and reach each vertex; they are returned if there
  /// is a cut face.
  std::vector<CutLink> add_cut_face(std::uint32_t attributes) {
    std::ranges::sort(links_);
    std::vector<CutLink> left;
    for (std::size_t i = 0; i < links_.size();) {
      const CutLink link = links_[i];
      const auto same = [&](const CutLink& l) {
        return std::ranges::upper_bound(links_, l) - std::ranges::lower_bound(links_, l);
      };
      const std::ptrdiff_t there = same(link), back = same({link.to, link.from});
      for (std::ptrdiff_t k = back; k < there; ++k) left.push_back(link);
      i += static_cast<std::size_t>(there);
    }
    std::vector<bool> is_used(left.size(), false);
    std::vector<Point3> positions;
    Point3 area(0.0);
    for (std::size_t first = 0; first < left.size(); ++first) {
      if (is_used[first]) continue;
      loop_.clear();
      std::size_t at = first;
      while (true) {
        is_used[at] = true;
        loop_.push_back({left[at].to, 1});
        if (left[at].to == left[first].from) break;
        auto next = std::ranges::lower_bound(left, left[at].to, {}, &CutLink::from);
        auto k = static_cast<std::size_t>(next - left.begin());
        while (k < left.size() && left[k].from == left[at].to && is_used[k]) ++k;
        if (k == left.size() || left[k].from != left[at].to) {
          drop_cut_face();
          return {};
        }
        at = k;
      }
      result_.add_loop(loop_);
      positions.clear();
      for (const CutCorner& corner : loop_) positions.push_back(position(corner));
      area += newell_normal(positions);
    }
    SolidFaces::Face face;
    face.attributes = attributes;
    face.cut_by = n_;
    face.normal = planes_.unit_plane(n_).normal;
    if (glm::dot(face.normal, area) < 0.0) face.normal = -face.normal;
    result_.add(face);
    return left;
  }

  /// A side of the cut face is also a side of the face beside it, in the style of that face:
  /// visible where the cut face is turned away.
  void show_sides_along(const std::vector<CutLink>& of_cut_face, std::size_t loops) {
    std::size_t first = 0;
    for (std::size_t i = 0; i < loops; first = result_.end_corner[i++]) {
      const auto loop = std::span(result_.corners).subspan(first, result_.end_corner[i] - first);
      std::uint32_t from = loop.back().vertex;
      for (CutCorner& to : loop) {
        if (to.edge_visible == kAlongPlane) {
          const CutLink turned{to.vertex, from};
          to.edge_visible = std::binary_search(of_cut_face.begin(), of_cut_face.end(), turned);
        }
        from = to.vertex;
      }
    }
  }

  /// Removes the cut face, as a solid that is not closed has none.
  void drop_cut_face() {
    const std::size_t loops = result_.first_loop(result_.faces.size());
    result_.end_corner.resize(loops);
    result_.corners.resize(loops == 0 ? 0 : result_.end_corner.back());
  }

  const SolidFaces& solid_;
  const CuttingPlanes& planes_;
  int n_;
  std::vector<Point3> points_;  // the solid's vertices, and where its sides are cut
  EqualPoints table_;
  std::vector<bool> is_inside_;
  std::vector<Chain> chains_;  // of one face
  std::vector<bool> is_joined_;
  std::vector<End> ends_;
  std::vector<CutCorner> loop_;
  std::vector<CutLink> links_;
  SolidFaces result_;
};

}  // namespace

SolidFaces cut_solid(const SolidFaces& solid, const CuttingPlanes& planes,
                     std::uint32_t attributes) {
  SolidFaces result = welded(solid);
  for (int n = 1; n <= CuttingPlanes::kMost; ++n) {
    if (!planes.is_on(n)) continue;
    OnePlane by(result, planes, n);
    if (by.cuts()) result = by.cut(attributes);
  }
  return result;
}

}  // namespace displayfile
