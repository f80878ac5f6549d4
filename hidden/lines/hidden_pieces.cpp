#include "hidden/lines/hidden_pieces.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

#include "hidden/exact/exact_number.h"
#include "hidden/exact/orientation.h"
#include "hidden/lines/line_ends.h"

namespace displayfile {

std::vector<HiddenPiece> hidden_pieces(std::span<const LineName> lines, const SeenLines& seen) {
  std::vector<HiddenPiece> hidden;
  auto piece = seen.pieces.begin();
  for (const LineName& line : lines) {
    double from = 0.0;
    for (; piece != seen.pieces.end() && LineName{piece->item, piece->corner} == line; ++piece) {
      if (from < piece->from) hidden.push_back({line.item, line.corner, from, piece->from});
      from = piece->to;
    }
    if (from < 1.0) hidden.push_back({line.item, line.corner, from, 1.0});
  }
  return hidden;
}

namespace {

/// Which way the direction from c to d is turned from that from a to b: 1 counterclockwise, 0 if
/// they are parallel. The true sign: each factor is a difference of two doubles, as in
/// orientation_value, whose bound holds here.
int turn_of_direction(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  if (a == c && b == d) return 0;
  constexpr double kBound = 4.0 * kUnit * kInflate;
  const double left = (b.x - a.x) * (d.y - c.y), right = (b.y - a.y) * (d.x - c.x);
  const double turn = left - right;
  if (std::abs(turn) > kBound * std::abs(left + right) + kTiny) return decided_sign(turn);
  const auto difference = [](double p, double q) { return ExactNumber(p) - ExactNumber(q); };
  return (difference(b.x, a.x) * difference(d.y, c.y) - difference(b.y, a.y) * difference(d.x, c.x))
      .sign();
}

/// A line that has pieces, with what its supporting line is about. Lines of which pieces can cover
/// each other have the same direction and distance but for rounding.
struct SupportedLine {
  double direction;  ///< as angles grow: the slope, from 0 to 1, and so on up to 4 at half a turn
  double distance;   ///< from the origin, times the larger part of the direction
  Point2 from, to;   ///< the line's own ends, or exchanged: it runs up, or to the right
  std::uint32_t first_seen, end_seen, first_hidden, end_hidden;
};

// Rounding of either is less than 2^-49.
constexpr double kDirectionsApart = 0x1p-46;
constexpr double kDistancesApart = 0x1p-46;  // times the largest coordinate

/// Where the measure begins and ends, at lines that run to the right, signs decide, which are
/// exact: lines of one direction are not parted there.
void find_support(SupportedLine& line) {
  double dx = line.to.x - line.from.x, dy = line.to.y - line.from.y;
  if (dy < 0.0 || (dy == 0.0 && dx < 0.0)) {
    std::swap(line.from, line.to);
    dx = -dx;
    dy = -dy;
  }
  const double larger = std::max(std::abs(dx), dy);
  line.direction = dy >= std::abs(dx) ? 2.0 - dx / dy : dy / dx + (dx < 0.0 ? 4.0 : 0.0);
  line.distance = line.from.y * (dx / larger) - line.from.x * (dy / larger);
}

/// By direction, then from right to left: lines that are neither before nor after each other lie on
/// one line.
bool lies_before(const SupportedLine& one, const SupportedLine& other) {
  const int turn = turn_of_direction(one.from, one.to, other.from, other.to);
  if (turn != 0) return turn > 0;
  if (one.from == other.from || one.to == other.from) return false;
  return orientation(one.from, one.to, other.from) > 0;
}

/// Calls visit with the runs of what is in order, no more than `slack` apart by its value, one to
/// the next.
template <class T, class Value, class Visit>
void for_each_run(std::span<T> all, double slack, const Value& value, const Visit& visit) {
  for (std::size_t from = 0; from < all.size();) {
    std::size_t to = from + 1;
    while (to < all.size() && value(all[to]) - value(all[to - 1]) <= slack) ++to;
    visit(all.subspan(from, to - from));
    from = to;
  }
}

class Uncovering {
 public:
  Uncovering(const Primitives& items, std::span<const VisiblePiece> seen,
             std::span<const HiddenPiece> hidden)
      : items_(items), seen_(seen), hidden_(hidden) {}

  std::vector<HiddenPiece> pieces() {
    list_lines();
    std::ranges::sort(lines_, {}, &SupportedLine::direction);
    for_each_run(
        std::span(lines_), kDirectionsApart, [](const auto& line) { return line.direction; },
        [&](std::span<SupportedLine> alike) { among_directions(alike); });
    std::ranges::sort(left_, [](const HiddenPiece& a, const HiddenPiece& b) {
      return std::tie(a.item, a.corner, a.from) < std::tie(b.item, b.corner, b.from);
    });
    return std::move(left_);
  }

 private:
  static LineName name(const VisiblePiece& piece) { return {piece.item, piece.corner}; }

  void list_lines() {
    std::size_t s = 0, h = 0;
    while (s < seen_.size() || h < hidden_.size()) {
      const bool seen_next =
          h == hidden_.size() || (s < seen_.size() && name(seen_[s]) < name(hidden_[h]));
      const LineName next = name(seen_next ? seen_[s] : hidden_[h]);
      SupportedLine line{};
      const auto end_of = [&](std::span<const VisiblePiece> pieces, std::size_t& k) {
        while (k < pieces.size() && name(pieces[k]) == next) ++k;
        return static_cast<std::uint32_t>(k);
      };
      line.first_seen = static_cast<std::uint32_t>(s);
      line.first_hidden = static_cast<std::uint32_t>(h);
      line.end_seen = end_of(seen_, s);
      line.end_hidden = end_of(hidden_, h);
      const LineEnds ends(items_, next);
      line.from = Point2(ends.from);
      line.to = Point2(ends.to);
      for (const Point2& p : {line.from, line.to}) {
        largest_ = std::max({largest_, std::abs(p.x), std::abs(p.y)});
      }
      find_support(line);
      lines_.push_back(line);
    }
  }

  static bool has_hidden(std::span<const SupportedLine> lines) {
    return std::ranges::any_of(
        lines, [](const SupportedLine& line) { return line.first_hidden < line.end_hidden; });
  }

  void leave(std::span<const SupportedLine> lines) {
    for (const SupportedLine& line : lines) {
      left_.insert(left_.end(), hidden_.begin() + line.first_hidden,
                   hidden_.begin() + line.end_hidden);
    }
  }

  void among_directions(std::span<SupportedLine> lines) {
    if (lines.size() == 1 || !has_hidden(lines)) return leave(lines);
    std::ranges::sort(lines, {}, &SupportedLine::distance);
    for_each_run(
        lines, kDistancesApart * largest_, [](const auto& line) { return line.distance; },
        [&](std::span<SupportedLine> close) { among_close(close); });
  }

  /// What is close may lie on one line; that is decided exactly.
  void among_close(std::span<SupportedLine> lines) {
    if (lines.size() == 1 || !has_hidden(lines)) return leave(lines);
    std::ranges::sort(lines, lies_before);
    for (std::size_t from = 0; from < lines.size();) {
      std::size_t to = from + 1;
      while (to < lines.size() && !lies_before(lines[from], lines[to])) ++to;
      on_one_line(lines.subspan(from, to - from));
      from = to;
    }
  }

  // ---- Pieces on one line ------------------------------------------------------------------

  /// A piece by places along the line: coordinates along x, or y if it is steep.
  struct Placed {
    double low, high;
    std::uint32_t piece;
    bool is_hidden;
  };
  struct Event {
    double at;
    std::uint32_t placed;
    bool opens;
  };

  /// A piece's two ends as they are along the line.
  struct Places {
    double from, to;
  };
  Places places(const VisiblePiece& piece) const {
    const LineEnds ends(items_, name(piece));
    return {ends.at(piece.from)[axis_], ends.at(piece.to)[axis_]};
  }

  void place(std::uint32_t number, const VisiblePiece& piece, bool is_hidden) {
    const auto [from, to] = places(piece);
    if (from == to) {  // for rounding
      if (is_hidden) left_.push_back(piece);
      return;
    }
    const auto index = static_cast<std::uint32_t>(placed_.size());
    placed_.push_back({std::min(from, to), std::max(from, to), number, is_hidden});
    events_.push_back({placed_.back().low, index, true});
    events_.push_back({placed_.back().high, index, false});
  }

  void on_one_line(std::span<SupportedLine> lines) {
    if (lines.size() == 1 || !has_hidden(lines)) return leave(lines);
    std::ranges::sort(lines, [](const SupportedLine& a, const SupportedLine& b) {
      return std::tie(a.first_seen, a.first_hidden) < std::tie(b.first_seen, b.first_hidden);
    });
    const Point2 along = lines.front().to - lines.front().from;
    axis_ = std::abs(along.x) >= std::abs(along.y) ? 0 : 1;
    placed_.clear();
    events_.clear();
    for (const SupportedLine& line : lines) {
      for (std::uint32_t k = line.first_seen; k < line.end_seen; ++k) place(k, seen_[k], false);
      for (std::uint32_t k = line.first_hidden; k < line.end_hidden; ++k)
        place(k, hidden_[k], true);
    }
    std::ranges::sort(events_, {}, &Event::at);
    sweep();
  }

  /// From place to place along the line: where nothing is seen, the first of the hidden pieces that
  /// are there is drawn.
  void sweep() {
    std::size_t seen_here = 0;
    std::set<std::pair<std::uint32_t, std::uint32_t>> hidden_here;  // and where they are placed
    std::uint32_t drawn = kNone;
    double since = 0.0;
    for (std::size_t k = 0; k < events_.size();) {
      const double at = events_[k].at;
      for (; k < events_.size() && events_[k].at == at; ++k) {
        const auto [_, index, opens] = events_[k];
        const Placed& placed = placed_[index];
        if (!placed.is_hidden) {
          opens ? ++seen_here : --seen_here;
        } else if (opens) {
          hidden_here.emplace(placed.piece, index);
        } else {
          hidden_here.erase({placed.piece, index});
        }
      }
      const bool draws = seen_here == 0 && !hidden_here.empty();
      const std::uint32_t next = draws ? hidden_here.begin()->second : kNone;
      if (next == drawn) continue;
      if (drawn != kNone) add_part(placed_[drawn], since, at);
      drawn = next;
      since = at;
    }
  }

  /// Adds what is drawn of a hidden piece. A crumb that is no longer than the rounding of its ends
  /// is no part.
  void add_part(const Placed& placed, double low, double high) {
    constexpr double kCrumb = 0x1p-46;
    const HiddenPiece& whole = hidden_[placed.piece];
    if (low == placed.low && high == placed.high) return left_.push_back(whole);
    if (high - low <= kCrumb * std::max(std::abs(low), std::abs(high))) return;
    const LineEnds ends(items_, name(whole));
    const Places own = places(whole);
    const auto share = [&](double at) {
      if (at == own.from) return whole.from;
      if (at == own.to) return whole.to;
      const double t = (at - ends.from[axis_]) / (ends.to[axis_] - ends.from[axis_]);
      return std::clamp(t, whole.from, whole.to);
    };
    const bool forward = own.from < own.to;
    const double a = share(forward ? low : high), b = share(forward ? high : low);
    if (a < b) left_.push_back({whole.item, whole.corner, a, b});
  }

  static constexpr std::uint32_t kNone = 0xffffffffu;

  const Primitives& items_;
  std::span<const VisiblePiece> seen_;
  std::span<const HiddenPiece> hidden_;
  std::vector<SupportedLine> lines_;
  double largest_ = 0.0;
  std::vector<HiddenPiece> left_;
  int axis_ = 0;
  std::vector<Placed> placed_;
  std::vector<Event> events_;
};

}  // namespace

std::vector<HiddenPiece> uncovered_pieces(const Primitives& items, const SeenLines& seen,
                                          std::span<const HiddenPiece> hidden) {
  if (hidden.empty()) return {};
  return Uncovering(items, seen.pieces, hidden).pieces();
}

}  // namespace displayfile
