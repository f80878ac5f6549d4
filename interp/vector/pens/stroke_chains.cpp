#include "interp/vector/pens/stroke_chains.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

#include "hidden/disjoint_sets.h"
#include "hidden/lines/chains.h"

namespace displayfile {

double length_of(const PenPath& path) {
  double length = 0.0;
  const auto& p = path.points;
  for (std::size_t i = path.closed ? 0 : 1; i < p.size(); ++i) {
    length +=
        std::sqrt(static_cast<double>(squared_distance(p[i == 0 ? p.size() - 1 : i - 1], p[i])));
  }
  return length;
}

namespace {

using StrokeEnd = std::uint32_t;  // 2 * stroke where it starts, + 1 where it ends
constexpr StrokeEnd kNoEnd = 0xffffffffu;

/// The ends that follow each other on a path. Chains that continue straight on at crossings leave
/// loops that touch other paths: these are opened where they touch, and drawn on the way.
class StrokeJoints {
 public:
  explicit StrokeJoints(std::span<const Stroke> strokes)
      : strokes_(strokes), mate_(2 * strokes.size(), kNoEnd) {
    std::vector<ChainLink> links;
    links.reserve(strokes.size());
    const auto point = [](const SheetPoint& p) { return Point3(p.x, p.y, 0.0); };
    for (const Stroke& s : strokes) links.push_back({point(s.from), point(s.to), 0});
    const Chains chains = chains_of(links);
    chain_of_.resize(strokes.size());
    for (std::uint32_t c = 0; c < chains.first.size(); ++c) {
      const auto places = chains.chain(c);
      for (const Chains::Place& place : places) chain_of_[place.piece] = c;
      for (std::size_t i = 1; i < places.size(); ++i) join(last(places[i - 1]), first(places[i]));
      const StrokeEnd start = first(places.front()), end = last(places.back());
      closed_.push_back(places.size() > 1 && at(start) == at(end) ? 1 : 0);
      if (closed_.back() != 0) join(end, start);
    }
    splice_loops();
  }

  StrokeEnd mate(StrokeEnd end) const { return mate_[end]; }

 private:
  static StrokeEnd first(const Chains::Place& place) {
    return 2 * place.piece + (place.reversed ? 1 : 0);
  }
  static StrokeEnd last(const Chains::Place& place) { return first(place) ^ 1u; }
  const SheetPoint& at(StrokeEnd end) const {
    return end % 2 == 0 ? strokes_[end / 2].from : strokes_[end / 2].to;
  }
  void join(StrokeEnd a, StrokeEnd b) {
    mate_[a] = b;
    mate_[b] = a;
  }

  void splice_loops() {
    std::vector<StrokeEnd> ends(mate_.size());
    std::iota(ends.begin(), ends.end(), StrokeEnd{0});
    std::ranges::sort(
        ends, [&](StrokeEnd a, StrokeEnd b) { return std::pair(at(a), a) < std::pair(at(b), b); });
    DisjointSets paths(closed_.size());
    for (std::size_t from = 0; from < ends.size();) {
      std::size_t to = from + 1;
      while (to < ends.size() && at(ends[to]) == at(ends[from])) ++to;
      for (std::size_t i = from + 1; i < to; ++i) splice(paths, ends[from], ends[i]);
      from = to;
    }
  }

  /// Merges two paths that pass here, if one of them is closed.
  void splice(DisjointSets& paths, StrokeEnd a, StrokeEnd b) {
    const std::uint32_t of_a = paths.name(chain_of_[a / 2]), of_b = paths.name(chain_of_[b / 2]);
    if (of_a == of_b || (closed_[of_a] == 0 && closed_[of_b] == 0)) return;
    const std::uint8_t closed = closed_[of_a] & closed_[of_b];
    const StrokeEnd after_a = mate_[a], after_b = mate_[b];
    join(a, b);
    if (after_a != kNoEnd && after_b != kNoEnd) {
      join(after_a, after_b);
    } else {  // one of the paths ended here; now the loop's other end does
      if (after_a != kNoEnd) mate_[after_a] = kNoEnd;
      if (after_b != kNoEnd) mate_[after_b] = kNoEnd;
    }
    paths.join(of_a, of_b);
    closed_[paths.name(of_a)] = closed;
  }

  std::span<const Stroke> strokes_;
  std::vector<StrokeEnd> mate_;
  std::vector<std::uint32_t> chain_of_;
  std::vector<std::uint8_t> closed_;  // of the path that a chain stands for
};

/// The directions from the apex in which a stroke passes within kOnStroke of all points so far.
class Wedge {
 public:
  explicit Wedge(const SheetPoint& apex) : apex_(apex) {}

  /// True if the stroke from the apex to p passes by all points, none of them beyond it.
  bool reaches(const SheetPoint& p) const {
    const double x = p.x - apex_.x, y = p.y - apex_.y;
    const double squared = x * x + y * y;
    if (squared < farthest_) return false;
    if (!bounded_) return true;
    return right_x_ * y - right_y_ * x >= 0.0 && x * left_y_ - y * left_x_ >= 0.0;
  }

  /// Must be called with points for which reaches() is true.
  void add(const SheetPoint& p) {
    const double x = p.x - apex_.x, y = p.y - apex_.y;
    const double squared = x * x + y * y;
    farthest_ = std::max(farthest_, squared);
    if (squared <= kOnStroke * kOnStroke) return;
    // A right angle's share of the way: the tangents to the circle around p.
    const double sine = kOnStroke / std::sqrt(squared), cosine = std::sqrt(1.0 - sine * sine);
    const double rx = x * cosine + y * sine, ry = y * cosine - x * sine;
    const double lx = x * cosine - y * sine, ly = y * cosine + x * sine;
    if (!bounded_ || right_x_ * ry - right_y_ * rx > 0.0) {
      right_x_ = rx;
      right_y_ = ry;
    }
    if (!bounded_ || left_x_ * ly - left_y_ * lx < 0.0) {
      left_x_ = lx;
      left_y_ = ly;
    }
    bounded_ = true;
  }

 private:
  SheetPoint apex_;
  bool bounded_ = false;
  double left_x_ = 0.0, left_y_ = 0.0, right_x_ = 0.0, right_y_ = 0.0;
  double farthest_ = 0.0;
};

/// Removes the points on straight runs. The first and the last are kept.
std::vector<SheetPoint> straightened(std::span<const SheetPoint> points) {
  std::vector<SheetPoint> kept{points.front()};
  Wedge wedge(points.front());
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!wedge.reaches(points[i])) {
      kept.push_back(points[i - 1]);
      wedge = Wedge(points[i - 1]);
    }
    wedge.add(points[i]);
  }
  if (points.size() > 1) kept.push_back(points.back());
  return kept;
}

/// The index of a loop's sharpest turn, a corner that is always kept.
std::size_t sharpest_corner(std::span<const SheetPoint> loop) {
  std::size_t sharpest = 0;
  double least = 2.0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const SheetPoint& before = loop[i == 0 ? loop.size() - 1 : i - 1];
    const SheetPoint& after = loop[i + 1 == loop.size() ? 0 : i + 1];
    const double straight = static_cast<double>(dot(before, loop[i], loop[i], after)) /
                            std::sqrt(static_cast<double>(squared_distance(before, loop[i])) *
                                      static_cast<double>(squared_distance(loop[i], after)));
    if (straight < least) {
      least = straight;
      sharpest = i;
    }
  }
  return sharpest;
}

PenPath straightened(std::vector<SheetPoint> points, bool closed) {
  if (closed) {
    const auto corner = static_cast<std::ptrdiff_t>(sharpest_corner(points));
    std::rotate(points.begin(), points.begin() + corner, points.end());
    points.push_back(points.front());
  }
  PenPath path{straightened(points), closed};
  if (!closed) return path;
  path.points.pop_back();
  if (path.points.size() < 3) path.closed = false;  // what comes back lies on what went there
  return path;
}

}  // namespace

std::vector<PenPath> stroke_chains(std::span<const Stroke> strokes) {
  std::vector<PenPath> paths;
  std::vector<Stroke> lines;
  for (const Stroke& s : strokes) {
    if (s.is_dot()) {
      paths.push_back({{s.from}, false});
    } else {
      lines.push_back(s);
    }
  }
  const StrokeJoints joints(lines);
  std::vector<std::uint8_t> drawn(lines.size(), 0);
  const auto at = [&](StrokeEnd end) {
    return end % 2 == 0 ? lines[end / 2].from : lines[end / 2].to;
  };
  std::vector<SheetPoint> points;
  for (StrokeEnd stroke = 0; stroke < lines.size(); ++stroke) {
    if (drawn[stroke] != 0) continue;
    // Back to where the path begins, or around to the stroke itself.
    StrokeEnd start = 2 * stroke;
    bool closed = false;
    for (StrokeEnd before = joints.mate(start); before != kNoEnd && !closed;
         before = joints.mate(start)) {
      start = before ^ 1u;
      closed = start == 2 * stroke;
    }
    points.assign(1, at(start));
    for (StrokeEnd end = start; end != kNoEnd && drawn[end / 2] == 0; end = joints.mate(end ^ 1u)) {
      drawn[end / 2] = 1;
      points.push_back(at(end ^ 1u));
    }
    if (closed) points.pop_back();
    paths.push_back(straightened(points, closed));
  }
  return paths;
}

}  // namespace displayfile
