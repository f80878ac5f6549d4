#include "hidden/lines/hidden_pieces.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

#include "hidden/lines/line_ends.h"
#include "hidden/lines/lines_on_lines.h"

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

/// A line's pieces, by their numbers.
struct PiecesOfLine {
  std::uint32_t first_seen, end_seen, first_hidden, end_hidden;
  std::uint32_t leader;  ///< which line it lies on (leading_lines)
};

class Uncovering {
 public:
  Uncovering(const Primitives& items, std::span<const VisiblePiece> seen,
             std::span<const HiddenPiece> hidden)
      : items_(items), seen_(seen), hidden_(hidden) {}

  std::vector<HiddenPiece> pieces() {
    list_lines();
    std::ranges::stable_sort(lines_, {}, &PiecesOfLine::leader);
    for (std::size_t from = 0; from < lines_.size();) {
      std::size_t to = from + 1;
      while (to < lines_.size() && lines_[to].leader == lines_[from].leader) ++to;
      on_one_line(std::span(lines_).subspan(from, to - from));
      from = to;
    }
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
      PiecesOfLine line{};
      const auto end_of = [&](std::span<const VisiblePiece> pieces, std::size_t& k) {
        while (k < pieces.size() && name(pieces[k]) == next) ++k;
        return static_cast<std::uint32_t>(k);
      };
      line.first_seen = static_cast<std::uint32_t>(s);
      line.first_hidden = static_cast<std::uint32_t>(h);
      line.end_seen = end_of(seen_, s);
      line.end_hidden = end_of(hidden_, h);
      const LineEnds ends(items_, next);
      in_picture_.push_back({Point2(ends.from), Point2(ends.to)});
      lines_.push_back(line);
    }
    const std::vector<std::uint32_t> leaders = leading_lines(in_picture_);
    for (std::size_t k = 0; k < lines_.size(); ++k) lines_[k].leader = leaders[k];
  }

  static bool has_hidden(std::span<const PiecesOfLine> lines) {
    return std::ranges::any_of(
        lines, [](const PiecesOfLine& line) { return line.first_hidden < line.end_hidden; });
  }

  void leave(std::span<const PiecesOfLine> lines) {
    for (const PiecesOfLine& line : lines) {
      left_.insert(left_.end(), hidden_.begin() + line.first_hidden,
                   hidden_.begin() + line.end_hidden);
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

  void on_one_line(std::span<const PiecesOfLine> lines) {
    if (lines.size() == 1 || !has_hidden(lines)) return leave(lines);
    const Point2 along =
        in_picture_[lines.front().leader].to - in_picture_[lines.front().leader].from;
    axis_ = std::abs(along.x) >= std::abs(along.y) ? 0 : 1;
    placed_.clear();
    events_.clear();
    for (const PiecesOfLine& line : lines) {
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

  /// Adds what is drawn of a hidden piece. A crumb that is no longer than lines may be apart, or
  /// than the rounding of its ends, is no part.
  void add_part(const Placed& placed, double low, double high) {
    constexpr double kRoundingOfEnds = 0x1p-46;
    const HiddenPiece& whole = hidden_[placed.piece];
    if (low == placed.low && high == placed.high) return left_.push_back(whole);
    const double crumb =
        std::max(kLinesApart, kRoundingOfEnds * std::max(std::abs(low), std::abs(high)));
    if (high - low <= crumb) return;
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
  std::vector<LineOfPicture> in_picture_;
  std::vector<PiecesOfLine> lines_;
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
