#include "hidden/lines/intersection_lines.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "clip/base/budgeted_work.h"
#include "clip/base/parallel.h"
#include "clip/base/work_budget.h"
#include "hidden/exact/depth_order.h"
#include "hidden/exact/order_on_line.h"
#include "hidden/lines/depth_boxes.h"
#include "hidden/lines/line_table.h"

namespace displayfile {

namespace {

/// Finds the lines of pairs of polygons, one pair at a time. Reuses its memory, so that nothing is
/// allocated per pair.
class Intersections {
 public:
  Intersections(const Primitives& items, const LineTable& scene, IntersectionEnds ends)
      : items_(items), scene_(scene), ends_(ends) {}

  /// Adds the lines of a pair of polygons that hide, in order along the line. Pairs with the same
  /// first polygon should follow each other: mostly its plane decides, and the other's is not
  /// needed.
  void find(std::uint32_t first, std::uint32_t second, std::vector<IntersectionLine>& lines) {
    assert(first != second);
    const auto [a, b] = std::minmax(first, second);  // a was entered first
    pair_ = {a, b};
    const std::uint32_t own = first == a ? kA : kB;
    if (!reaches_through(1 - own) || !reaches_through(own)) return;
    planes_ = {plane(kA), plane(kB)};
    order_ = OrderOnLine(planes_[kA], planes_[kB]);
    inside_.clear();
    add_inside(a, kA, true);
    meet_inside(b, kB, true);
    if (touches_line(kA)) meet_inside(a, kA, false);
    if (touches_line(kB)) meet_inside(b, kB, false);
    join_inside();
    if (inside_.empty()) return;
    if (ends_ == IntersectionEnds::rounded) {
      if (share_a_side(a, b) || touch_as_entered()) return;
      leave_out_sides_in_planes();
    }
    for (const auto& [from, to] : inside_) {
      if (ends_ == IntersectionEnds::defined) {
        lines.push_back({a, b, well_known(from), well_known(to), {}, {}});
        continue;
      }
      IntersectionLine line{a, b, rounded_once(from), rounded_once(to), {}, {}};
      if (Point2(line.from.near) == Point2(line.to.near)) continue;
      line.start = drawn(line.from);
      line.end = drawn(line.to);
      lines.push_back(line);
    }
  }

 private:
  static constexpr std::uint32_t kA = 0, kB = 1;  // the polygons, and their planes
  struct Part {
    DefinedPoint from, to;
  };

  Definitions definitions() const { return {items_.points, planes_}; }

  /// The plane of one of the pair's polygons; planes of previous pairs are cached, since neighbours
  /// follow each other.
  const Plane& plane(std::uint32_t own) {
    const std::uint32_t item = pair_[own];
    Known& known = known_[own][item % kKnown];
    if (known.item != item) known = {item, scene_.plane(item)};
    return known.plane;
  }

  /// Finds the side of the other polygon's plane for each corner, at the depth of its own plane: 1
  /// where the corner is nearer, -1, 0. False unless there are corners on both sides.
  bool reaches_through(std::uint32_t own) {
    const std::uint32_t item = pair_[own];
    const Plane& of_other = plane(1 - own);
    const std::uint32_t sides = scene_.sides(item);
    std::vector<std::int8_t>& side = side_[own];
    side.resize(sides);
    bool before = false, behind = false;
    for (std::uint32_t k = 0; k < sides; ++k) {
      const Point3& corner = scene_.corner(item, k);
      int s = 0;
      if (scene_.is_off_plane(item, k)) {
        s = depth_order(plane(own), of_other, Point2(corner));
      } else if (!of_other.goes_through(corner)) {  // most neighbours in a mesh pass through it
        s = side_of_plane(corner, of_other);
      }
      side[k] = static_cast<std::int8_t>(s);
      before |= s > 0;
      behind |= s < 0;
    }
    return before && behind;
  }

  /// True if a polygon does not pass through the other's plane, when corners within reach of that
  /// plane count as on it. A corner made by clipping counts as viewed. Also records these corners.
  bool touch_as_entered() {
    if (items_.ends == nullptr) return false;
    bool touch = false;
    for (const std::uint32_t own : {kA, kB}) {
      bool before = false, behind = false;
      on_plane_[own].resize(side_[own].size());
      for (std::uint32_t k = 0; k < side_[own].size(); ++k) {
        const bool is_on = side_[own][k] == 0 || is_on_plane_as_entered(own, k);
        on_plane_[own][k] = is_on ? 1 : 0;
        before |= !is_on && side_[own][k] > 0;
        behind |= !is_on && side_[own][k] < 0;
      }
      touch |= !(before && behind);
    }
    return touch;
  }
  /// Removes parts along sides with both corners in the other's plane: such a side is drawn
  /// already, and its polygon lies on one side of it; only rounding may put it on both.
  void leave_out_sides_in_planes() {
    if (items_.ends == nullptr) return;
    for (const std::uint32_t own : {kA, kB}) {
      const auto sides = static_cast<std::uint32_t>(on_plane_[own].size());
      for (std::uint32_t next = 0, k = sides - 1; next < sides; k = next++) {
        if (on_plane_[own][k] != 0 && on_plane_[own][next] != 0) leave_out_side(own, k, next);
      }
    }
  }
  void leave_out_side(std::uint32_t own, std::uint32_t k, std::uint32_t next) {
    const DefinedPoint at_k = at_corner(pair_[own], own, k),
                       at_next = at_corner(pair_[own], own, next);
    const Point3 p = items_.points[point(pair_[own], k)],
                 q = items_.points[point(pair_[own], next)];
    others_.clear();
    for (const Part& part : inside_) {
      const Point3 from = rounded(definitions(), part.from), to = rounded(definitions(), part.to);
      const int axis = std::abs(to.x - from.x) >= std::abs(to.y - from.y) ? 0 : 1;
      const double sign = to[axis] < from[axis] ? -1.0 : 1.0;
      const bool in_order = sign * p[axis] < sign * q[axis];
      const double low = sign * (in_order ? p : q)[axis], high = sign * (in_order ? q : p)[axis];
      const double crumb = std::max(kCrumb, 4.0 * std::min(items_.touching, kCrumbAtMost));
      if (std::abs(to[axis] - from[axis]) <= crumb) continue;
      if (std::min(high, sign * to[axis]) - std::max(low, sign * from[axis]) <= crumb) {
        others_.push_back(part);
        continue;
      }
      if (low - sign * from[axis] > crumb)
        others_.push_back({part.from, in_order ? at_k : at_next});
      if (sign * to[axis] - high > crumb) others_.push_back({in_order ? at_next : at_k, part.to});
    }
    std::swap(inside_, others_);
  }
  /// Shorter pieces are artefacts of viewing and of the reach.
  static constexpr double kCrumb = 1e-12, kCrumbAtMost = 1e-3;
  /// True if the corner is on the plane as an end of both of its sides.
  bool is_on_plane_as_entered(std::uint32_t own, std::uint32_t k) const {
    constexpr auto kOnPlane = EndsAsEntered::Place::on_plane;
    const std::uint32_t item = pair_[own], other = pair_[1 - own];
    const std::uint32_t next = k + 1 == scene_.sides(item) ? 0 : k + 1;
    return items_.places(item, k, other)[1] == kOnPlane &&
           items_.places(item, next, other)[0] == kOnPlane;
  }

  /// True if the polygons share a side: then they meet only along it, and any other line is due to
  /// rounding.
  bool share_a_side(std::uint32_t a, std::uint32_t b) {
    list_sides(a, sides_of_[kA]);
    list_sides(b, sides_of_[kB]);
    const auto &of_a = sides_of_[kA], &of_b = sides_of_[kB];
    for (std::size_t i = 0, j = 0; i < of_a.size() && j < of_b.size();) {
      if (of_a[i] == of_b[j]) return true;
      ++(of_a[i] < of_b[j] ? i : j);
    }
    return false;
  }
  using Side = std::array<double, 6>;  // its ends, the smaller one first
  void list_sides(std::uint32_t item, std::vector<Side>& sides) const {
    sides.clear();
    const std::uint32_t n = scene_.sides(item);
    std::uint32_t k = n - 1;
    for (std::uint32_t next = 0; next < n; k = next++) {
      const Point3 &p = items_.points[point(item, k)], &q = items_.points[point(item, next)];
      const bool in_order = std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
      const Point3 &from = in_order ? p : q, &to = in_order ? q : p;
      sides.push_back({from.x, from.y, from.z, to.x, to.y, to.z});
    }
    std::ranges::sort(sides);
  }

  bool touches_line(std::uint32_t own) const {
    return std::ranges::find(side_[own], std::int8_t{0}) != side_[own].end();
  }

  /// Finds where the polygon's boundary crosses a line close to the common line of both planes, on
  /// the side where its own plane is in front of the other, or where it is behind; in order along
  /// the line. The polygon's inside is between the first and second crossing, the third and fourth,
  /// and so on (even-odd).
  void find_crossings(std::uint32_t item, std::uint32_t own, bool before) {
    crossings_.clear();
    const std::uint32_t sides = scene_.sides(item);
    const std::vector<std::int8_t>& side = side_[own];
    const auto is_beyond = [&](std::uint32_t k) { return before ? side[k] > 0 : side[k] < 0; };
    std::uint32_t k = sides - 1;
    for (std::uint32_t next = 0; next < sides; k = next++) {
      if (is_beyond(k) == is_beyond(next)) continue;
      crossings_.push_back(side[k] == 0      ? at_corner(item, own, k)
                           : side[next] == 0 ? at_corner(item, own, next)
                                             : on_side(item, own, k, next));
    }
    assert(!crossings_.empty() && crossings_.size() % 2 == 0);  // reaches_through was true
    const auto is_less = [&](const DefinedPoint& v, const DefinedPoint& w) {
      return compare(v, w) < 0;
    };
    if (crossings_.size() > 2) {
      std::ranges::sort(crossings_, is_less);
    } else if (is_less(crossings_[1], crossings_[0])) {
      std::swap(crossings_[0], crossings_[1]);
    }
  }

  std::uint32_t point(std::uint32_t item, std::uint32_t corner) const {
    return items_.point(items_.items[item].first + corner);
  }
  DefinedPoint at_corner(std::uint32_t item, std::uint32_t own, std::uint32_t k) const {
    const std::uint32_t p = point(item, k);
    DefinedPoint v = scene_.is_off_plane(item, k) ? lifted_point(definitions(), p, own)
                                                  : stored_point(items_.points[p]);
    v.a = p;  // also for a stored point: its index among the items' points
    return v;
  }
  DefinedPoint on_side(std::uint32_t item, std::uint32_t own, std::uint32_t k,
                       std::uint32_t next) const {
    const bool is_flat = !scene_.is_off_plane(item, k) && !scene_.is_off_plane(item, next);
    const std::uint32_t p = point(item, k), q = point(item, next), other = 1 - own;
    return is_flat ? edge_cut(definitions(), p, q, other)
                   : lifted_edge_cut(definitions(), p, q, own, other);
  }

  // ---- Parts of the line, in order ----------------------------------------------------------

  int compare(const DefinedPoint& v, const DefinedPoint& w) const {
    return order_.compare(definitions(), v, w);
  }

  void add_inside(std::uint32_t item, std::uint32_t own, bool before) {
    find_crossings(item, own, before);
    for (std::size_t k = 0; k + 1 < crossings_.size(); k += 2) {
      add_part(crossings_[k], crossings_[k + 1]);
    }
  }
  void add_part(const DefinedPoint& from, const DefinedPoint& to) {
    if (compare(from, to) < 0) inside_.push_back({from, to});
  }
  /// Intersects the parts found so far with the inside of this polygon.
  void meet_inside(std::uint32_t item, std::uint32_t own, bool before) {
    if (inside_.empty()) return;
    std::swap(inside_, others_);
    inside_.clear();
    add_inside(item, own, before);
    std::swap(inside_, more_);
    inside_.clear();
    for (std::size_t i = 0, j = 0; i < others_.size() && j < more_.size();) {
      const Part &p = others_[i], &q = more_[j];
      const bool ends_first = compare(p.to, q.to) < 0;
      add_part(compare(p.from, q.from) < 0 ? q.from : p.from, ends_first ? p.to : q.to);
      ++(ends_first ? i : j);
    }
  }
  /// Joins adjacent parts: where a boundary only touches the line, no part ends.
  void join_inside() {
    if (inside_.size() < 2) return;
    std::size_t last = 0;
    for (std::size_t k = 1; k < inside_.size(); ++k) {
      if (compare(inside_[last].to, inside_[k].from) == 0) {
        inside_[last].to = inside_[k].to;
      } else {
        inside_[++last] = inside_[k];
      }
    }
    inside_.resize(last + 1);
  }

  DefinedPoint well_known(const DefinedPoint& v) const {
    return is_badly_known(v) ? refined(definitions(), v) : v;
  }
  DefinedPoint rounded_once(DefinedPoint v) const {
    v.near = rounded(definitions(), v) + 0.0;  // + 0.0: a zero has one sign, however defined
    if (v.kind == DefinedPoint::Kind::stored) return v;
    const double size = std::max({std::abs(v.near.x), std::abs(v.near.y), std::abs(v.near.z)});
    v.radius = size <= kCoordinateLimit ? kUnit * size * kInflate + kTiny
                                        : std::numeric_limits<double>::infinity();
    return v;
  }

  Point3 drawn(const DefinedPoint& v) const {
    if (v.kind != DefinedPoint::Kind::lifted_edge_cut) return v.near;
    const Plane& plane = planes_[v.cut];
    const int at_a = side_of_plane(items_.points[v.a], plane);
    const int at_b = side_of_plane(items_.points[v.b], plane);
    if (at_a * at_b > 0 || (at_a == 0 && at_b == 0)) return v.near;  // no crossing
    return rounded(definitions(), edge_cut(definitions(), v.a, v.b, v.cut)) + 0.0;
  }

  const Primitives& items_;
  const LineTable& scene_;
  IntersectionEnds ends_;
  struct Known {
    std::uint32_t item = LineTable::kNone;
    Plane plane;
  };
  static constexpr std::size_t kKnown = 64;
  std::array<std::array<Known, kKnown>, 2> known_;
  std::array<std::uint32_t, 2> pair_{};
  std::array<Plane, 2> planes_;
  OrderOnLine order_;
  std::array<std::vector<std::int8_t>, 2> side_;       // per corner, the side of the other's plane
  std::array<std::vector<std::uint8_t>, 2> on_plane_;  // likewise: 1 if within reach, as entered
  std::vector<DefinedPoint> crossings_;
  std::vector<Part> inside_, others_, more_;
  std::array<std::vector<Side>, 2> sides_of_;
};

}  // namespace

std::vector<IntersectionLine> intersection_lines(const Primitives& items, int threads) {
  const LineTable scene(items, {}, threads);
  std::vector<std::uint32_t> solids;
  for (std::uint32_t i = 0; i < scene.items(); ++i) {
    if (scene.hides(i)) solids.push_back(i);
  }
  return intersection_lines(items, scene, solids, IntersectionEnds::rounded, threads);
}

std::vector<IntersectionLine> intersection_lines(const Primitives& items, const LineTable& scene,
                                                 std::span<const std::uint32_t> solids,
                                                 IntersectionEnds ends, int threads) {
  constexpr std::uint32_t kLeavesOfAPart = 64;
  DepthTree tree;
  tree.build(
      solids.size(), [&](DepthTree::Item k) { return DepthBox{scene.extent(solids[k])}; }, threads);
  std::vector<std::vector<IntersectionLine>> found((tree.leaves() + kLeavesOfAPart - 1) /
                                                   kLeavesOfAPart);
  in_parallel(threads, found.size(), [&](std::size_t part) {
    Intersections intersections(items, scene, ends);
    WorkSteps steps;
    constexpr std::uint32_t kCornersOfAStep = 16;
    const auto first = static_cast<std::uint32_t>(part) * kLeavesOfAPart;
    const std::uint32_t end = std::min(first + kLeavesOfAPart, tree.leaves());
    tree.pairs(first, end, [&](DepthTree::Position p, DepthTree::Position q) {
      const std::uint32_t i = solids[tree.order()[p]], j = solids[tree.order()[q]];
      steps.step(1 + (scene.sides(i) + scene.sides(j)) / kCornersOfAStep);
      intersections.find(i, j, found[part]);
    });
  });
  std::vector<IntersectionLine> lines;
  for (const auto& of_part : found) lines.insert(lines.end(), of_part.begin(), of_part.end());
  std::ranges::stable_sort(lines, [](const IntersectionLine& l, const IntersectionLine& m) {
    return std::tie(l.item_b, l.item_a) < std::tie(m.item_b, m.item_a);
  });
  return lines;
}

}  // namespace displayfile
