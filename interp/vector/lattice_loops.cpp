#include "interp/vector/lattice_loops.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace displayfile {

namespace {

/// The sides that occur an odd number of times in the loops, once each, sorted.
std::vector<LatticeSide> odd_sides(std::span<const std::span<const LatticePoint>> loops) {
  std::vector<LatticeSide> sides;
  std::size_t corners = 0;
  for (const auto& loop : loops) corners += loop.size();
  sides.reserve(corners);
  for (const auto& loop : loops) {
    for_each_side(loop, [&](const LatticePoint& from, const LatticePoint& to) {
      if (from != to) sides.emplace_back(from, to);
    });
  }
  std::ranges::sort(sides);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i;
    while (end < sides.size() && sides[end] == sides[i]) ++end;
    if ((end - i) % 2 == 1) sides[kept++] = sides[i];
    i = end;
  }
  sides.erase(sides.begin() + static_cast<std::ptrdiff_t>(kept), sides.end());
  return sides;
}

using Wide = std::int64_t;

/// The cross product of the vectors from o to p and to q. Differences have 31 bits at most.
Wide turn(const LatticePoint& o, const LatticePoint& p, const LatticePoint& q) {
  return (Wide{p.x} - o.x) * (Wide{q.y} - o.y) - (Wide{p.y} - o.y) * (Wide{q.x} - o.x);
}

/// An end of a side, with the side, which determines its line.
struct EndOnLine {
  LatticeSide side;
  LatticePoint at;
};

/// Orders by the direction of the line, then by the line, then along it.
bool before_along_lines(const EndOnLine& p, const EndOnLine& q) {
  const auto [from, to] = p.side;
  const auto [other_from, other_to] = q.side;
  const Wide turned = (Wide{to.x} - from.x) * (Wide{other_to.y} - other_from.y) -
                      (Wide{to.y} - from.y) * (Wide{other_to.x} - other_from.x);
  if (turned != 0) return turned > 0;
  const Wide beside = turn(from, to, other_from);
  return beside != 0 ? beside > 0 : p.at < q.at;
}

/// The parts covered by an odd number of sides, where sides overlap partially: the points of a line
/// with an odd number of ends before them. A line has an even number of ends.
std::vector<LatticeSide> odd_parts(std::span<const LatticeSide> sides) {
  std::vector<EndOnLine> ends;
  ends.reserve(2 * sides.size());
  for (const LatticeSide& side : sides) {
    ends.push_back({side, side.a});
    ends.push_back({side, side.b});
  }
  std::ranges::sort(ends, before_along_lines);
  std::vector<LatticeSide> parts;
  parts.reserve(sides.size());
  for (std::size_t i = 0; i < ends.size(); i += 2) {
    if (ends[i].at != ends[i + 1].at) parts.emplace_back(ends[i].at, ends[i + 1].at);
  }
  return parts;
}

/// A side as it leaves one of its ends.
struct LeavingSide {
  LatticePoint from, to;
  std::size_t side;
};

/// Orders by the angle from the direction of -x, and in one direction by the other end.
bool before_in_angle(const LeavingSide& p, const LeavingSide& q) {
  const auto upper = [](const LeavingSide& s) {
    return s.to.y > s.from.y || (s.to.y == s.from.y && s.to.x > s.from.x);
  };
  if (upper(p) != upper(q)) return upper(q);
  const Wide turned = turn(p.from, p.to, q.to);
  return turned != 0 ? turned > 0 : p.to < q.to;
}

/// At each vertex the outgoing sides are paired: neighbours in angle, so that no two pairs cross.
/// Their number is even.
class PairedSides {
 public:
  explicit PairedSides(std::span<const LatticeSide> sides) : twins_(2 * sides.size()) {
    leaving_.reserve(2 * sides.size());
    for (std::size_t s = 0; s < sides.size(); ++s) {
      leaving_.push_back({sides[s].a, sides[s].b, s});
      leaving_.push_back({sides[s].b, sides[s].a, s});
    }
    std::ranges::sort(leaving_, [](const LeavingSide& p, const LeavingSide& q) {
      return std::tie(p.from, p.to) < std::tie(q.from, q.to);
    });
    for (std::size_t i = 0; i < leaving_.size();) {
      std::size_t end = i;
      while (end < leaving_.size() && leaving_[end].from == leaving_[i].from) ++end;
      if (end - i > 2) {
        std::ranges::sort(leaving_.begin() + static_cast<std::ptrdiff_t>(i),
                          leaving_.begin() + static_cast<std::ptrdiff_t>(end), before_in_angle);
      }
      i = end;
    }
    std::vector<std::size_t> other(sides.size(), kNone);
    for (std::size_t i = 0; i < leaving_.size(); ++i) {
      std::size_t& seen = other[leaving_[i].side];
      if (seen == kNone) {
        seen = i;
      } else {
        twins_[i] = seen;
        twins_[seen] = i;
      }
    }
  }

  std::size_t size() const { return leaving_.size(); }
  const LeavingSide& operator[](std::size_t i) const { return leaving_[i]; }
  /// The side with which a loop that arrived along i continues.
  std::size_t next(std::size_t i) const { return twins_[i] ^ 1; }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  // Sorted by `from`, of which each has an even number: 2k and 2k + 1 are a pair.
  std::vector<LeavingSide> leaving_;
  std::vector<std::size_t> twins_;  // the same side as it leaves its other end
};

/// Chains the sides to loops, using each once. Every vertex has an even number of them.
LatticeLoops chained_loops(std::span<const LatticeSide> sides) {
  const PairedSides paired(sides);
  std::vector<bool> chained(sides.size());
  LatticeLoops loops;
  for (std::size_t first = 0; first < paired.size(); ++first) {
    if (chained[paired[first].side]) continue;
    for (std::size_t i = first; !chained[paired[i].side]; i = paired.next(i)) {
      chained[paired[i].side] = true;
      loops.points.push_back(paired[i].from);
    }
    loops.close();
  }
  return loops;
}

}  // namespace

LatticeLoops boundary_of(std::span<const std::span<const LatticePoint>> loops) {
  return chained_loops(odd_sides(loops));
}

LatticeLoops outline_of(std::span<const std::span<const LatticePoint>> loops) {
  LatticeLoops outline = chained_loops(odd_parts(odd_sides(loops)));
  LatticeLoops* const alone = &outline;
  drop_straight_vertices(std::span(&alone, 1));
  return outline;
}

namespace {

/// A corner of a loop: its vertex, and the end of one of its sides.
struct EndOfSide {
  LatticePoint vertex, other;
  friend auto operator<=>(const EndOfSide&, const EndOfSide&) = default;
};

std::vector<LatticePoint> straight_vertices(std::span<LatticeLoops* const> all) {
  std::vector<EndOfSide> ends;
  for (const LatticeLoops* loops : all) {
    for_each_side(*loops, [&](const LatticePoint& from, const LatticePoint& to) {
      ends.push_back({from, to});
      ends.push_back({to, from});
    });
  }
  std::ranges::sort(ends);
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  std::vector<LatticePoint> straight;
  for (std::size_t i = 0; i < ends.size();) {
    const LatticePoint v = ends[i].vertex;
    std::size_t end = i;
    while (end < ends.size() && ends[end].vertex == v) ++end;
    if (end - i == 2) {
      const LatticePoint p = ends[i].other, q = ends[i + 1].other;
      const Wide along =
          (Wide{p.x} - v.x) * (Wide{q.x} - v.x) + (Wide{p.y} - v.y) * (Wide{q.y} - v.y);
      if (turn(v, p, q) == 0 && along < 0) straight.push_back(v);
    }
    i = end;
  }
  return straight;
}

}  // namespace

void drop_straight_vertices(std::span<LatticeLoops* const> all) {
  const std::vector<LatticePoint> straight = straight_vertices(all);
  if (straight.empty()) return;
  for (LatticeLoops* loops : all) {
    LatticeLoops kept;
    kept.points.reserve(loops->points.size());
    kept.ends.reserve(loops->size());
    for (std::size_t k = 0; k < loops->size(); ++k) {
      const std::size_t first = kept.points.size();
      for (const LatticePoint& p : loops->loop(k)) {
        if (!std::ranges::binary_search(straight, p)) kept.points.push_back(p);
      }
      if (kept.points.size() - first >= 3) {
        kept.close();
      } else {
        kept.points.resize(first);  // it covers nothing
      }
    }
    *loops = std::move(kept);
  }
}

}  // namespace displayfile
