#include "hidden/triangles/uncrossed_loops.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <tuple>
#include <utility>

#include "clip/geometry/corners.h"
#include "hidden/triangles/ear_cutting.h"

namespace displayfile {

namespace {

constexpr double kRelativeReach = 0x1p-40;

double reach_of_rounding(std::span<const Point2> polygon) {
  double largest = 0.0;
  for (const Point2& p : polygon) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  return kRelativeReach * largest;
}

double cross_of(const Point2& a, const Point2& b) { return a.x * b.y - a.y * b.x; }

/// Two sides, and how their ends lie beside the other.
struct TwoSides {
  Point2 a, b, c, d;
  bool are_near = false;  ///< their boxes meet, within reach
  /// Distances from the other side's line, positive on the left, where they are near.
  double c_off = 0.0, d_off = 0.0, a_off = 0.0, b_off = 0.0;

  TwoSides(const Point2& from, const Point2& to, const Point2& other_from, const Point2& other_to,
           double reach)
      : a(from), b(to), c(other_from), d(other_to) {
    are_near = std::max(a.x, b.x) + reach >= std::min(c.x, d.x) &&
               std::max(c.x, d.x) + reach >= std::min(a.x, b.x) &&
               std::max(a.y, b.y) + reach >= std::min(c.y, d.y) &&
               std::max(c.y, d.y) + reach >= std::min(a.y, b.y);
    if (!are_near) return;
    const double ab = glm::length(b - a), cd = glm::length(d - c);
    c_off = cross_of(b - a, c - a) / ab;
    d_off = cross_of(b - a, d - a) / ab;
    a_off = cross_of(d - c, a - c) / cd;
    b_off = cross_of(d - c, b - c) / cd;
  }
  bool cross(double reach) const {
    const auto differ = [reach](double p, double q) {
      return (p > reach && q < -reach) || (p < -reach && q > reach);
    };
    return are_near && differ(c_off, d_off) && differ(a_off, b_off);
  }
};

/// The share of the way from a to b at which p is, if it is within reach between them.
double share_between(const Point2& p, const Point2& a, const Point2& b, double off, double reach) {
  const double length = glm::length(b - a), along = glm::dot(p - a, b - a) / length;
  return std::abs(off) <= reach && along > reach && along < length - reach ? along / length : -1.0;
}

}  // namespace

bool UncrossedLoops::crosses(std::span<const Point2> polygon, std::span<const std::uint32_t> next) {
  if (polygon.size() > kMostCorners) return false;
  const double reach = reach_of_rounding(polygon);
  const auto n = static_cast<std::uint32_t>(polygon.size());
  const auto end_of = [&](std::uint32_t k) { return next.empty() ? next_corner(k, n) : next[k]; };
  for (std::uint32_t i = 0; i < n; ++i) {
    if (end_of(i) == kInNoLoop) continue;
    for (std::uint32_t k = i + 1; k < n; ++k) {
      if (end_of(k) == kInNoLoop) continue;
      const TwoSides two(polygon[i], polygon[end_of(i)], polygon[k], polygon[end_of(k)], reach);
      if (two.cross(reach)) return true;
    }
  }
  return false;
}

/// Places within reach of each other are one.
std::uint32_t UncrossedLoops::node_at(const Point2& place, std::uint32_t vertex) {
  const auto near = std::ranges::find_if(
      nodes_, [&](const Node& node) { return glm::distance(node.place, place) <= reach_; });
  if (near != nodes_.end()) return static_cast<std::uint32_t>(near - nodes_.begin());
  nodes_.push_back({place, vertex});
  return static_cast<std::uint32_t>(nodes_.size() - 1);
}

/// Notes where two sides meet other than at their ends.
void UncrossedLoops::meet(std::span<const Point2> polygon, std::uint32_t first,
                          std::uint32_t second) {
  const auto n = static_cast<std::uint32_t>(polygon.size());
  const TwoSides two(polygon[first], polygon[next_corner(first, n)], polygon[second],
                     polygon[next_corner(second, n)], reach_);
  if (!two.are_near) return;
  if (two.cross(reach_)) {
    const double share = two.a_off / (two.a_off - two.b_off);
    const double other = two.c_off / (two.c_off - two.d_off);
    const auto number = n + static_cast<std::uint32_t>(crossings_.size());
    const std::size_t before = nodes_.size();
    const std::uint32_t node = node_at(two.a + share * (two.b - two.a), number);
    if (nodes_.size() > before) crossings_.push_back({{first, second}, {share, other}});
    on_sides_.push_back({first, share, node});
    on_sides_.push_back({second, other, node});
    return;
  }
  const auto note = [&](std::uint32_t side, double share, const Point2& end, std::uint32_t vertex) {
    if (share > 0.0) on_sides_.push_back({side, share, node_at(end, vertex)});
  };
  note(first, share_between(two.c, two.a, two.b, two.c_off, reach_), two.c, second);
  note(first, share_between(two.d, two.a, two.b, two.d_off, reach_), two.d, next_corner(second, n));
  note(second, share_between(two.a, two.c, two.d, two.a_off, reach_), two.a, first);
  note(second, share_between(two.b, two.c, two.d, two.b_off, reach_), two.b, next_corner(first, n));
}

/// Parts sides into edges between nodes.
void UncrossedLoops::part_sides(std::span<const Point2> polygon) {
  const auto n = static_cast<std::uint32_t>(polygon.size());
  for (std::uint32_t side = 0; side < n; ++side) {
    on_sides_.push_back({side, 0.0, node_at(polygon[side], side)});
  }
  std::ranges::sort(on_sides_, {}, [](const OnSide& at) { return std::tie(at.side, at.share); });
  for (std::size_t k = 0; k < on_sides_.size(); ++k) {
    const std::uint32_t from = on_sides_[k].node;
    const std::uint32_t to = on_sides_[next_corner(k, on_sides_.size())].node;
    if (from != to) edges_.push_back({from, to});
  }
}

/// The even-odd rule sees no edge that is there twice.
void UncrossedLoops::keep_odd_edges() {
  const auto ends = [](const Edge& e) { return std::minmax(e.from, e.to); };
  std::ranges::sort(edges_, [&](const Edge& a, const Edge& b) { return ends(a) < ends(b); });
  std::vector<Edge> odd;
  for (const Edge& edge : edges_) {
    if (!odd.empty() && ends(odd.back()) == ends(edge)) {
      odd.pop_back();
    } else {
      odd.push_back(edge);
    }
  }
  edges_ = std::move(odd);
}

/// Counts the edges to the right of its middle, or above that of an edge that is nearly level.
bool UncrossedLoops::has_inside_on_left(const Edge& edge) const {
  const Point2 a = nodes_[edge.from].place, b = nodes_[edge.to].place, way = b - a;
  const Point2 middle = 0.5 * a + 0.5 * b;
  const bool is_steep = std::abs(way.y) >= std::abs(way.x);
  const auto swapped = [is_steep](const Point2& p) { return is_steep ? p : Point2(p.y, p.x); };
  const Point2 from = swapped(middle);
  bool is_odd = false;  // beyond the edge, on its right or above it
  for (const Edge& other : edges_) {
    if (&other == &edge) continue;
    const Point2 p = swapped(nodes_[other.from].place), q = swapped(nodes_[other.to].place);
    if ((p.y > from.y) == (q.y > from.y)) continue;
    if (from.x < p.x + (q.x - p.x) * (from.y - p.y) / (q.y - p.y)) is_odd = !is_odd;
  }
  const bool left_is_beyond = is_steep ? way.y < 0.0 : way.x > 0.0;
  return left_is_beyond == is_odd;
}

/// Links each edge, with the inside on its left, to the next one around the same piece of it.
bool UncrossedLoops::link() {
  std::vector<Edge> directed;
  for (const Edge& edge : edges_) {
    directed.push_back(has_inside_on_left(edge) ? edge : Edge{edge.to, edge.from});
  }
  std::ranges::stable_sort(directed, {}, &Edge::from);
  const auto direction = [&](std::uint32_t from, std::uint32_t to) {
    const Point2 way = nodes_[to].place - nodes_[from].place;
    return std::atan2(way.y, way.x);
  };
  const auto edges = static_cast<std::uint32_t>(directed.size());
  std::vector<char> is_linked(edges, 0);
  for (const Edge& edge : directed) {
    const double back = direction(edge.to, edge.from);
    std::uint32_t following = edges;
    double least = 0.0;
    const auto out = std::ranges::lower_bound(directed, edge.to, {}, &Edge::from);
    for (auto k = static_cast<std::uint32_t>(out - directed.begin());
         k < edges && directed[k].from == edge.to; ++k) {
      double clockwise = back - direction(edge.to, directed[k].to);
      if (clockwise <= 0.0) clockwise += 2.0 * std::numbers::pi;
      if (following != edges && clockwise >= least) continue;
      least = clockwise;
      following = k;
    }
    if (following == edges || is_linked[following] != 0) return false;
    is_linked[following] = 1;
    next_.push_back(following);
    corners_.push_back(nodes_[edge.from].place);
    vertex_.push_back(nodes_[edge.from].vertex);
  }
  return edges >= 3;
}

bool UncrossedLoops::find(std::span<const Point2> polygon) {
  nodes_.clear();
  on_sides_.clear();
  edges_.clear();
  crossings_.clear();
  corners_.clear();
  next_.clear();
  vertex_.clear();
  const auto n = static_cast<std::uint32_t>(polygon.size());
  if (n > kMostCorners) return false;
  reach_ = reach_of_rounding(polygon);
  for (std::uint32_t i = 0; i < n; ++i) node_at(polygon[i], i);
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = i + 1; k < n; ++k) meet(polygon, i, k);
    if (crossings_.size() > kMostCrossings) return false;
  }
  part_sides(polygon);
  keep_odd_edges();
  return link();
}

}  // namespace displayfile
