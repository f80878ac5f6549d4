#include "hidden/triangles/ear_cutting.h"

#include <algorithm>
#include <cassert>
#include <iterator>
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
  Kind kind = Kind::one_below;
  int turn = 0;                  ///< 1 if the polygon is convex there
  Point2 left{0.0}, right{0.0};  ///< its neighbours, if they are on the same side of it
};

class Sweep {
 public:
  Sweep(std::span<const Point2> polygon, std::vector<CornerTriple>& triangles)
      : polygon_(polygon), triangles_(triangles), order_(RightSideIsLeftOf{this}) {}

  bool run() {
    drop_repeated_points();
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
  void drop_repeated_points();
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
  std::vector<Corner> corners_;            // without successive equal points
  std::vector<VertexIndex> sequence_;      // of corners, in order of visits
  std::vector<VertexIndex> rank_;          // per corner, its position in the sequence
  std::vector<VertexIndex> slab_of_side_;  // side i runs from corner i to the next
  std::vector<Link> links_;
  std::vector<Slab> slabs_;
  Order order_;                          // of slabs, from left to right
  std::vector<Order::iterator> places_;  // per slab
};

/// Cuts off a corner that repeats the previous point: its triangle has no area.
void Sweep::drop_repeated_points() {
  const auto n = static_cast<VertexIndex>(polygon_.size());
  VertexIndex first = 0;  // so that a run of equal points does not begin at the polygon's end
  while (first < n && polygon_[first] == polygon_[previous_corner(first, n)]) ++first;
  if (first == n) return;
  for (VertexIndex k = 0; k < n; ++k) {
    const VertexIndex v = first + k < n ? first + k : first + k - n;
    if (corners_.empty() || polygon_[v] != corners_.back().at) {
      corners_.push_back({polygon_[v], v});
    } else {
      triangles_.push_back({corners_.back().of_polygon, v, next_corner(v, n)});
    }
  }
}

/// Exchanges x and y if the polygon runs clockwise: rounded Newell's sums may misjudge its
/// direction.
void Sweep::turn_counterclockwise() {
  VertexIndex lowest = 0;
  for (VertexIndex v = 1; v < size(); ++v) {
    if (is_below(corners_[v].at, corners_[lowest].at)) lowest = v;
  }
  const auto at = [&](VertexIndex v) { return corners_[v].at; };
  if (orientation(at(previous_corner(lowest, size())), at(lowest),
                  at(next_corner(lowest, size()))) >= 0)
    return;
  for (Corner& corner : corners_) std::swap(corner.at.x, corner.at.y);
}

void Sweep::find_kinds() {
  for (VertexIndex v = 0; v < size(); ++v) {
    Corner& corner = corners_[v];
    const Point2& p = corners_[previous_corner(v, size())].at;
    const Point2& q = corners_[next_corner(v, size())].at;
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
  const VertexIndex next = next_corner(side, size());
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
  const bool falls = rank_[previous_corner(v, size())] > rank_[v];
  bend(v, falls);
  return true;
}

/// Handles a corner where a side ends and the next continues.
void Sweep::bend(VertexIndex v, bool on_the_left) {
  const VertexIndex ended = on_the_left ? v : previous_corner(v, size());
  const VertexIndex begun = on_the_left ? previous_corner(v, size()) : v;
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
  const VertexIndex falling = previous_corner(v, size()), rising = v;
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
  const VertexIndex s = slab_of_side_[previous_corner(v, size())], t = slab_of_side_[v];
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

}  // namespace

bool sweep_triangles(std::span<const Point2> polygon, std::vector<CornerTriple>& triangles) {
  assert(polygon.size() >= 3);
  const std::size_t before = triangles.size();
  const bool all =
      Sweep(polygon, triangles).run() && triangles.size() - before == polygon.size() - 2;
  if (!all) triangles.resize(before);
  return all;
}

}  // namespace displayfile
