#include "hidden/triangles/ear_cutting.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <numeric>
#include <set>

#include "clip/geometry/corners.h"
#include "hidden/exact/orientation.h"

namespace displayfile {

namespace {

using VertexIndex = std::uint32_t;
constexpr VertexIndex kNone = 0xFFFFFFFFu;

/// From bottom to top, of equally high points from left to right.
bool is_below(const Point2& p, const Point2& q) { return p.y != q.y ? p.y < q.y : p.x < q.x; }

/// The number of a corner's neighbours below it: the order in which corners at one point are
/// visited.
enum class Kind { both_below, one_below, both_above };

struct Corner {
  Point2 at;
  VertexIndex of_polygon;
  VertexIndex previous = kNone, next = kNone;  ///< in its loop
  Kind kind = Kind::one_below;
  int turn = 0;                  ///< 1 if the polygon is convex there
  Point2 left{0.0}, right{0.0};  ///< its neighbours, if they are on the same side of it
};

/// The corners of each loop: of one, the polygon's, if `next` is empty.
std::vector<std::vector<VertexIndex>> loops_of(std::size_t corners,
                                               std::span<const VertexIndex> next) {
  std::vector<std::vector<VertexIndex>> loops;
  if (next.empty()) {
    loops.emplace_back(corners);
    std::iota(loops.back().begin(), loops.back().end(), VertexIndex{0});
    return loops;
  }
  std::vector<char> is_taken(corners, 0);
  for (std::size_t k = 0; k < corners; ++k) {
    if (next[k] == kInNoLoop || is_taken[k] != 0) continue;
    std::vector<VertexIndex>& loop = loops.emplace_back();
    for (auto v = static_cast<VertexIndex>(k); is_taken[v] == 0; v = next[v]) {
      is_taken[v] = 1;
      loop.push_back(v);
    }
  }
  return loops;
}

/// Twice the area, positive if the loop runs counterclockwise.
double area_of(std::span<const Point2> polygon, std::span<const VertexIndex> loop) {
  const Point2& origin = polygon[loop.front()];
  double area = 0.0;
  for (std::size_t k = 1; k + 1 < loop.size(); ++k) {
    const Point2 p = polygon[loop[k]] - origin, q = polygon[loop[k + 1]] - origin;
    area += p.x * q.y - q.x * p.y;
  }
  return area;
}

class Sweep {
 public:
  Sweep(std::span<const Point2> polygon, std::vector<CornerTriple>& triangles)
      : polygon_(polygon), triangles_(triangles), order_(RightSideIsLeftOf{this}) {}

  bool run(std::span<const VertexIndex> next) {
    for (const std::vector<VertexIndex>& loop : loops_of(polygon_.size(), next)) {
      if (!enter_loop(loop)) return false;
    }
    if (corners_.size() < 3) return false;
    turn_counterclockwise();
    find_kinds();
    put_in_order();
    slab_of_side_.assign(corners_.size(), kNone);
    return std::ranges::all_of(sequence_, [this](VertexIndex v) { return meet(v); }) &&
           order_.empty();
  }

 private:
  /// A corner in a chain: visited by the sweep, with untriangulated parts above it.
  struct Link {
    VertexIndex corner, left, right;
  };
  /// A part of the polygon's inside between two sides that the sweep line crosses. It is bounded
  /// below by a chain of corners, from the lower end of the left side to that of the right side;
  /// the chain rises to the peak, the corner visited last, and falls from there.
  struct Slab {
    VertexIndex left_side, right_side;
    VertexIndex first, last, peak;
  };
  /// Finds a slab by a corner's position among the slabs; a new slab is inserted beside a known
  /// one.
  struct RightSideIsLeftOf {
    using is_transparent = void;
    const Sweep* sweep;
    bool operator()(VertexIndex, VertexIndex) const { return false; }
    bool operator()(VertexIndex slab, const Corner& corner) const {
      return sweep->is_right_of(corner, sweep->slabs_[slab].right_side, corner.turn > 0);
    }
  };

  using Order = std::multiset<VertexIndex, RightSideIsLeftOf>;

  VertexIndex size() const { return static_cast<VertexIndex>(corners_.size()); }
  bool enter_loop(std::span<const VertexIndex> loop);
  void turn_counterclockwise();
  void find_kinds();
  void put_in_order();
  bool is_right_of(const Corner& corner, VertexIndex side, bool if_on_it) const;

  bool meet(VertexIndex v);
  void bend(VertexIndex v, bool on_the_left);
  bool start_or_split(VertexIndex v);
  bool end_or_merge(VertexIndex v);

  VertexIndex add_link(VertexIndex corner) {
    links_.push_back({corner, kNone, kNone});
    return static_cast<VertexIndex>(links_.size() - 1);
  }
  void join(VertexIndex left, VertexIndex right) {
    links_[left].right = right;
    links_[right].left = left;
  }
  void add_slab(const Slab& slab, Order::iterator next) {
    const auto added = static_cast<VertexIndex>(slabs_.size());
    slabs_.push_back(slab);
    slab_of_side_[slab.left_side] = slab_of_side_[slab.right_side] = added;
    places_.push_back(order_.emplace_hint(next, added));
  }
  void put_first(Slab& slab, VertexIndex v) {
    const VertexIndex link = slab.peak = add_link(v);
    join(link, slab.first);
    slab.first = link;
  }
  void put_last(Slab& slab, VertexIndex v) {
    const VertexIndex link = slab.peak = add_link(v);
    join(slab.last, link);
    slab.last = link;
  }
  bool cut_off(VertexIndex middle);
  void cut_to_the_right(VertexIndex link) {
    while (links_[link].right != kNone && cut_off(links_[link].right)) {
    }
  }
  void cut_to_the_left(VertexIndex link) {
    while (links_[link].left != kNone && cut_off(links_[link].left)) {
    }
  }

  std::span<const Point2> polygon_;
  std::vector<CornerTriple>& triangles_;
  std::vector<Corner> corners_;            // of all loops, without successive equal points
  std::vector<VertexIndex> sequence_;      // of corners, in order of visits
  std::vector<VertexIndex> rank_;          // per corner, its position in the sequence
  std::vector<VertexIndex> slab_of_side_;  // side i runs from corner i to the next
  std::vector<Link> links_;
  std::vector<Slab> slabs_;
  Order order_;                          // of slabs, from left to right
  std::vector<Order::iterator> places_;  // per slab
};

/// Cuts off a corner that repeats the previous point: its triangle has no area. False if all
/// corners of the loop are at one point.
bool Sweep::enter_loop(std::span<const VertexIndex> loop) {
  const auto n = static_cast<VertexIndex>(loop.size());
  const auto at = [&](VertexIndex k) { return polygon_[loop[k]]; };
  VertexIndex first = 0;  // so that a run of equal points does not begin at the loop's end
  while (first < n && at(first) == at(previous_corner(first, n))) ++first;
  if (first == n) return false;
  const VertexIndex begin = size();
  for (VertexIndex i = 0; i < n; ++i) {
    const VertexIndex k = first + i < n ? first + i : first + i - n;
    if (begin == size() || at(k) != corners_.back().at) {
      corners_.push_back({at(k), loop[k]});
    } else {
      triangles_.push_back({corners_.back().of_polygon, loop[k], loop[next_corner(k, n)]});
    }
  }
  const VertexIndex corners = size() - begin;
  for (VertexIndex k = 0; k < corners; ++k) {
    corners_[begin + k].previous = begin + previous_corner(k, corners);
    corners_[begin + k].next = begin + next_corner(k, corners);
  }
  return true;
}

/// Exchanges x and y if the polygon runs clockwise: rounded Newell's sums may misjudge its
/// direction.
void Sweep::turn_counterclockwise() {
  VertexIndex lowest = 0;
  for (VertexIndex v = 1; v < size(); ++v) {
    if (is_below(corners_[v].at, corners_[lowest].at)) lowest = v;
  }
  const auto at = [&](VertexIndex v) { return corners_[v].at; };
  const Corner& corner = corners_[lowest];
  if (orientation(at(corner.previous), corner.at, at(corner.next)) >= 0) return;
  for (Corner& each : corners_) std::swap(each.at.x, each.at.y);
}

void Sweep::find_kinds() {
  for (VertexIndex v = 0; v < size(); ++v) {
    Corner& corner = corners_[v];
    const Point2& p = corners_[corner.previous].at;
    const Point2& q = corners_[corner.next].at;
    corner.turn = orientation(p, corner.at, q);
    const bool p_below = is_below(p, corner.at), q_below = is_below(q, corner.at);
    if (p_below != q_below) continue;
    corner.kind = p_below ? Kind::both_below : Kind::both_above;
    const bool p_is_left = p_below != (corner.turn > 0);
    corner.left = p_is_left ? p : q;
    corner.right = p_is_left ? q : p;
  }
}

/// Sorts the corners. At one point, those where slabs end come first, then those where a side
/// continues, then those where slabs start; of two that end the inner first, of two that start the
/// outer.
void Sweep::put_in_order() {
  const auto comes_first = [this](VertexIndex u, VertexIndex v) {
    const Corner &a = corners_[u], &b = corners_[v];
    if (a.at != b.at) return is_below(a.at, b.at);
    if (a.kind != b.kind) return a.kind < b.kind;
    if (a.kind == Kind::one_below) return u < v;
    // Facing away from the sweep line below it, the right of one is to its left.
    if (const int side = orientation(a.at, b.left, a.left)) return side > 0;
    if (const int side = orientation(a.at, b.right, a.right)) return side < 0;
    return u < v;
  };
  sequence_.resize(corners_.size());
  for (VertexIndex v = 0; v < size(); ++v) sequence_[v] = v;
  std::ranges::sort(sequence_, comes_first);
  rank_.resize(corners_.size());
  for (VertexIndex k = 0; k < size(); ++k) rank_[sequence_[k]] = k;
}

/// True if a corner with both neighbours above it is right of a side that the sweep line crosses.
/// If the corner is on the side, its neighbours decide; if these are on it too, the result is
/// `if_on_it`.
bool Sweep::is_right_of(const Corner& corner, VertexIndex side, bool if_on_it) const {
  const VertexIndex next = corners_[side].next;
  const bool rises = rank_[side] < rank_[next];
  const Point2 &low = corners_[rises ? side : next].at, &high = corners_[rises ? next : side].at;
  if (const int of_corner = orientation(low, high, corner.at)) return of_corner < 0;
  const int of_left = orientation(corner.at, high, corner.left);
  const int of_right = orientation(corner.at, high, corner.right);
  if (of_left == 0 && of_right == 0) return if_on_it;
  return of_left <= 0 && of_right <= 0;
}

/// Cuts the triangle of a link and its neighbours off the chain, if it is inside, or has no area
/// and would block others.
bool Sweep::cut_off(VertexIndex middle) {
  const auto [b, left, right] = links_[middle];
  if (left == kNone || right == kNone) return false;
  const VertexIndex a = links_[left].corner, c = links_[right].corner;
  if (a == c) return false;  // the end of a slab
  const Point2 &p = corners_[a].at, &q = corners_[b].at, &r = corners_[c].at;
  const int turn = orientation(p, q, r);
  const bool is_low = rank_[b] < rank_[a] && rank_[b] < rank_[c];
  if (turn < 0 || (turn == 0 && !is_low && p != q && q != r)) return false;
  triangles_.push_back({corners_[a].of_polygon, corners_[b].of_polygon, corners_[c].of_polygon});
  join(left, right);
  return true;
}

/// False if the polygon crosses itself.
bool Sweep::meet(VertexIndex v) {
  switch (corners_[v].kind) {
    case Kind::both_above: return start_or_split(v);
    case Kind::both_below: return end_or_merge(v);
    case Kind::one_below: break;
  }
  const bool falls = rank_[corners_[v].previous] > rank_[v];
  bend(v, falls);
  return true;
}

/// Handles a corner where a side ends and the next continues.
void Sweep::bend(VertexIndex v, bool on_the_left) {
  const VertexIndex ended = on_the_left ? v : corners_[v].previous;
  const VertexIndex begun = on_the_left ? corners_[v].previous : v;
  const VertexIndex s = slab_of_side_[begun] = slab_of_side_[ended];
  assert(s != kNone);  // the ended side's lower end was met
  Slab& slab = slabs_[s];
  if (on_the_left) {
    slab.left_side = begun;
    put_first(slab, v);
    cut_to_the_right(slab.first);
  } else {
    slab.right_side = begun;
    put_last(slab, v);
    cut_to_the_left(slab.last);
  }
}

/// Outside, starts a slab; inside, splits the slab, whose peak is visible from the corner.
bool Sweep::start_or_split(VertexIndex v) {
  const Corner& corner = corners_[v];
  const VertexIndex falling = corner.previous, rising = v;
  const auto at = order_.lower_bound(corner);
  const bool inside =
      at != order_.end() && is_right_of(corner, slabs_[*at].left_side, corner.turn <= 0);
  if (inside ? corner.turn > 0 : corner.turn < 0) return false;
  if (!inside) {
    const VertexIndex link = add_link(v);
    add_slab({falling, rising, link, link, link}, at);
    return true;
  }
  const Slab whole = slabs_[*at];
  const VertexIndex peak = add_link(links_[whole.peak].corner), link = add_link(v);
  join(link, peak);
  if (whole.peak != whole.last) join(peak, links_[whole.peak].right);
  const VertexIndex last = whole.peak != whole.last ? whole.last : peak;
  Slab& left = slabs_[*at];
  left.right_side = rising;
  slab_of_side_[rising] = *at;
  left.last = whole.peak;
  links_[whole.peak].right = kNone;
  put_last(left, v);
  cut_to_the_left(left.last);
  add_slab({falling, whole.right_side, link, last, link}, std::next(at));
  cut_to_the_right(link);
  return true;
}

/// Ends the slab between both sides, or the gap between two slabs, which are merged.
bool Sweep::end_or_merge(VertexIndex v) {
  const VertexIndex s = slab_of_side_[corners_[v].previous], t = slab_of_side_[v];
  assert(s != kNone && t != kNone);  // both sides' lower ends were met
  Slab &left = slabs_[s], &right = slabs_[t];
  const int turn = corners_[v].turn;
  if (s == t ? turn < 0 : turn > 0 || std::next(places_[s]) != places_[t]) return false;
  put_last(left, v);
  cut_to_the_left(left.last);
  put_first(right, v);
  cut_to_the_right(right.first);
  order_.erase(places_[t]);
  if (s == t) return links_[links_[left.first].right].right == left.last;  // two corners are left
  left.peak = left.last;
  join(left.last, links_[right.first].right);
  left.last = right.last;
  left.right_side = right.right_side;
  slab_of_side_[left.right_side] = s;
  return true;
}

/// The number of triangles of a tiling: two fewer than corners, and for each hole two more than
/// its corners.
std::size_t triangles_of_loops(std::span<const Point2> polygon, std::span<const VertexIndex> next) {
  if (next.empty()) return polygon.size() - 2;
  std::size_t corners = 0;
  std::ptrdiff_t outlines = 0, holes = 0;
  for (const std::vector<VertexIndex>& loop : loops_of(polygon.size(), next)) {
    corners += loop.size();
    ++(area_of(polygon, loop) > 0.0 ? outlines : holes);
  }
  const std::ptrdiff_t more = 2 * (holes - outlines);
  return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(corners) + more);
}

}  // namespace

bool sweep_triangles(std::span<const Point2> polygon, std::vector<CornerTriple>& triangles,
                     std::span<const std::uint32_t> next) {
  assert(polygon.size() >= 3);
  const std::size_t before = triangles.size();
  const bool all = Sweep(polygon, triangles).run(next) &&
                   triangles.size() - before == triangles_of_loops(polygon, next);
  if (!all) triangles.resize(before);
  return all;
}

}  // namespace displayfile
