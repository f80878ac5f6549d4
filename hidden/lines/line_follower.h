#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "hidden/boxes/extents.h"
#include "hidden/lines/carried_counts.h"
#include "hidden/lines/contour_edges.h"
#include "hidden/lines/depth_boxes.h"
#include "hidden/lines/end_on_plane.h"
#include "hidden/lines/line_against_polygon.h"
#include "hidden/lines/line_counts.h"
#include "hidden/lines/side_table.h"

namespace displayfile {

/// Counts are not carried over a vertex with more corners around it, since each line there would
/// examine them all.
inline constexpr std::size_t kLargestStar = 64;

/// A scene's tables for Appel's method (hidden/lines/appel.md), shared by all threads.
struct AppelTables {
  const LineTable& lines;
  SideTable sides;
  ContourEdges contours;
  LineVertices vertices;
  FarPlanes far_planes;
  DepthTree counted;    ///< counted polygons, as boxes around them
  ExtentTree compared;  ///< the others that hide

  AppelTables(const Primitives& items, const LineTable& scene, int threads)
      : lines(scene),
        sides(items),
        contours(scene, items, sides, threads),
        vertices(scene, items, sides, contours),
        far_planes(scene, threads) {
    const auto box = [&](std::uint32_t i) {
      return DepthBox{contours.way(i) != 0 ? box_of(i) : Extent::nothing()};
    };
    counted.build(scene.items(), box, threads);
    std::vector<Extent> others(scene.items(), Extent::nothing());
    bool any = false;
    for (std::uint32_t i = 0; i < scene.items(); ++i) {
      if (!scene.hides(i) || contours.way(i) != 0) continue;
      others[i] = scene.extent(i);
      any = true;
    }
    if (any) compared = extent_tree(others, threads);
  }

  /// The box around a polygon, with the depths of its plane and of its corners; and away from the
  /// viewer, as far as reach may decide that it does not hide a line (ends_at_plane.h).
  Extent box_of(std::uint32_t polygon) const {
    Extent box = lines.extent(polygon);
    if (!contours.is_even(polygon)) {
      for (std::uint32_t k = 0; k < lines.sides(polygon); ++k) {
        box.include(lines.corner(polygon, k));
      }
    }
    if (lines.touching() > 0.0) {
      const double reach = reach_in_depth(lines.touching(), lines.plane(polygon));
      box.z_min = rounded_down(box.z_min - reach);
    }
    return box;
  }

  /// Calls visit(polygon) for counted polygons whose boxes meet this one, until it returns true:
  /// then returns true.
  template <class Visit>
  bool any_counted(const Extent& box, const Visit& visit) const {
    return counted.any([&](const DepthBoxes& boxes) { return boxes.meets(box); },
                       [&](DepthTree::Position at) {
                         // An unbounded box meets empty ones, too.
                         const std::uint32_t polygon = counted.order()[at];
                         return contours.way(polygon) != 0 && visit(polygon);
                       });
  }
};

/// The range of a line's changes among those found together; and the index of its start's counts.
struct ChangesOfLine {
  std::uint32_t found, from, to, start;
  bool is_near = false;  ///< near a contour's corner, but not on it: must be compared with all
};

/// Finds the changes of the counts along lines, and the contributions of their vertices' stars.
template <class Policy>
class LineFollower {
 public:
  LineFollower(const AppelTables& scene, const Policy& policy)
      : scene_(scene),
        lines_(scene.lines),
        policy_(policy),
        counts_(scene.lines, scene.contours, scene.far_planes, policy),
        depths_(scene.lines, policy) {}

  /// True if counts are carried over a vertex: no contour edge passes in front of it, and only its
  /// star touches it.
  bool carries(std::uint32_t vertex) const {
    if (scene_.vertices.star(vertex).size() > kLargestStar) return false;
    const Point3& v = lines_.point(vertex);
    Extent box = Extent::nothing();
    box.include(v);
    const auto passes = [&](const ContourEdges::Edge& edge) {
      return edge.p != v && edge.q != v && is_between(Point2(v), Point2(edge.p), Point2(edge.q));
    };
    if (scene_.contours.any(box, passes)) return false;
    const DepthLine at{v, v, nullptr};
    return !scene_.any_counted(box, [&](std::uint32_t polygon) {
      if (has_corner(polygon, v)) return false;
      const auto is_as_near = [&] { return policy_.nearer(at, v, lines_.plane(polygon)) == 0; };
      const bool even = scene_.contours.is_even(polygon);
      if (even && !is_as_near()) return false;
      const Place place = place_in(polygon, Point2(v));
      return place == Place::on_side || (place == Place::inside && (even || is_as_near()));
    });
  }

  /// Follows the line of one name, lines()[first] and those after it, one for each of its depths.
  /// Adds the changes along each. The carried count is that at the depth of the line's own ends,
  /// which may not be one of its depths.
  CountedLine follow(std::size_t first, std::span<const std::uint8_t> carries,
                     std::vector<CountChange>& changes, std::span<ChangesOfLine> of_depths) {
    const LineTable::Line& line = lines_.lines()[first];
    const Point3 &a = lines_.point(line.a), &b = lines_.point(line.b);
    CountedLine counted{scene_.vertices.vertex(line.a), scene_.vertices.vertex(line.b), {}, {}, {}};
    counts_.look_at(b, a);
    if (carries[counted.to] != 0) counted.star_to = star(counted.to).reversed();
    counts_.look_at(a, b);
    if (carries[counted.from] != 0) counted.star_from = star(counted.from);
    Extent box = Extent::nothing();
    const OffLines off_lines = lines_.off_lines();
    const double off = std::max(off_lines.in_picture, off_lines.touching);
    box.include(Point3(std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)), off);
    box.include(Point3(std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)), off);
    counted.change = pass_contours(box);
    bool has_other_depths = false;
    for (std::size_t i = 0; i < of_depths.size(); ++i) {
      const LineTable::Line& depth = lines_.lines()[first + i];
      if (!depth.by_plane) continue;
      has_other_depths = true;
      box.include(lines_.extent(depth));
    }
    find_near(line, box, has_other_depths);
    bool at_own_depth = false;
    for (std::size_t i = 0; i < of_depths.size(); ++i) {
      const LineTable::Line& depth = lines_.lines()[first + i];
      of_depths[i].from = static_cast<std::uint32_t>(changes.size());
      changes.insert(changes.end(), passed_.begin(), passed_.end());
      const SideCounts wrong = correct(depth, changes);
      if (!depth.by_plane) counted.change += wrong;
      at_own_depth |= !depth.by_plane;
      of_depths[i].to = static_cast<std::uint32_t>(changes.size());
      of_depths[i].is_near = is_near_;
      std::ranges::sort(changes.begin() + of_depths[i].from, changes.end(),
                        [](const CountChange& p, const CountChange& q) { return p.at < q.at; });
    }
    if (!at_own_depth && !doubtful_.empty()) {
      sharers_.clear();
      counted.change += correct({line.a, line.b, line.name, LineTable::kNone, false}, passed_);
    }
    return counted;
  }

  /// The counts after the start of a line, by comparison with all polygons that may cover it.
  SideCounts ray(const LineTable::Line& line) {
    const Point3& a = lines_.point(line.a);
    counts_.look_at(a, lines_.point(line.b));
    Extent before = Extent::nothing();
    before.include(a);
    before.z_max = std::numeric_limits<float>::infinity();
    SideCounts all;
    scene_.any_counted(before, [&](std::uint32_t polygon) {
      all += counts_.after_start(polygon);
      return false;
    });
    return all;
  }

 private:
  bool has_corner(std::uint32_t polygon, const Point3& v) const {
    for (std::uint32_t k = 0; k < lines_.sides(polygon); ++k) {
      if (lines_.corner(polygon, k) == v) return true;
    }
    return false;
  }

  /// True if the point is on the segment in the projection.
  bool is_between(const Point2& v, const Point2& p, const Point2& q) const {
    const bool in_box = std::min(p.x, q.x) <= v.x && v.x <= std::max(p.x, q.x) &&
                        std::min(p.y, q.y) <= v.y && v.y <= std::max(p.y, q.y);
    return in_box && policy_.turn(p, q, v) == 0;
  }

  enum class Place : std::uint8_t { outside, on_side, inside };

  /// The point's position relative to the polygon, in the projection.
  Place place_in(std::uint32_t polygon, const Point2& v) const {
    const std::uint32_t sides = lines_.sides(polygon);
    bool inside = false;
    Point2 p(lines_.corner(polygon, sides - 1));
    for (std::uint32_t k = 0; k < sides; ++k) {
      const Point2 q(lines_.corner(polygon, k));
      if (is_between(v, p, q)) return Place::on_side;
      const bool rises = p.y <= v.y && v.y < q.y, falls = q.y <= v.y && v.y < p.y;
      if (rises || falls) inside ^= policy_.turn(p, q, v) == (rises ? 1 : -1);
      p = q;
    }
    return inside ? Place::inside : Place::outside;
  }

  /// The contribution of the star of the vertex where the line starts.
  SideCounts star(std::uint32_t vertex) const {
    SideCounts all;
    for (const auto& [item, corner] : scene_.vertices.star(vertex)) {
      all += counts_.after_corner(item, corner);
    }
    return all;
  }

  /// Records the changes where the line passes behind contour edges; returns their sum.
  SideCounts pass_contours(const Extent& box) {
    passed_.clear();
    is_near_ = false;
    SideCounts all;
    scene_.contours.any(box, [&](const ContourEdges::Edge& edge) {
      is_near_ =
          is_near_ || counts_.is_taken_for_on_line(edge.p) || counts_.is_taken_for_on_line(edge.q);
      CountChange change{};
      if (counts_.passes_behind(edge.p, edge.q, edge.more_on_left, change)) {
        passed_.push_back(change);
        all += change.by;
      }
      return false;
    });
    return all;
  }

  /// As LineCounts::is_doubtful, for a line between these points.
  bool is_doubtful(const LineTable::Line& line, const Point3& a, const Point3& b,
                   std::uint32_t polygon) const {
    return counts_.is_doubtful(line, polygon, {has_corner(polygon, a), has_corner(polygon, b)});
  }

  /// Finds the polygons in the box that may cover the line and are near it in space: those that may
  /// be neither nearer nor farther along all of its own ends' depth, or whose plane it touches; if
  /// it has other depths, all; and those with the line as a side that may have another depth.
  void find_near(const LineTable::Line& line, const Extent& box, bool has_other_depths) {
    const Point3 &a = lines_.point(line.a), &b = lines_.point(line.b);
    near_.clear();
    doubtful_.clear();
    sharers_.clear();
    scene_.any_counted(box, [&](std::uint32_t polygon) {
      const bool doubtful = !scene_.contours.is_even(polygon) || is_doubtful(line, a, b, polygon);
      if (!doubtful && !has_other_depths) return false;
      if (counts_.is_side_of(polygon)) {
        sharers_.push_back(polygon);
      } else if (counts_.reaches_over(polygon)) {
        if (doubtful) doubtful_.push_back(polygon);
        if (has_other_depths) near_.push_back(polygon);
      } else {
        return false;
      }
      // A comparison takes such a corner for one on the line, counts do not.
      is_near_ = is_near_ || counts_.has_corner_taken_for_on_line(polygon);
      return false;
    });
  }

  /// Adds corrections for the contour edges at one of the line's depths. Returns the correction of
  /// the count at its end.
  SideCounts correct(const LineTable::Line& line, std::vector<CountChange>& changes) {
    const std::vector<std::uint32_t>& polygons = line.by_plane ? near_ : doubtful_;
    SideCounts all;
    if (polygons.empty() && sharers_.empty()) return all;
    depths_.look_at(line);
    for (const std::uint32_t polygon : polygons) all += counts_.correct(polygon, depths_, changes);
    for (const std::uint32_t polygon : sharers_) counts_.compare(polygon, depths_, changes);
    return all;
  }

  const AppelTables& scene_;
  const LineTable& lines_;
  const Policy& policy_;
  LineCounts<Policy> counts_;
  LineAgainstPolygon<Policy> depths_;
  bool is_near_ = false;  // of the line that is followed
  std::vector<CountChange> passed_;
  std::vector<std::uint32_t> near_, doubtful_, sharers_;
};

}  // namespace displayfile
