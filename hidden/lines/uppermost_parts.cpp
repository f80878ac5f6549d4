#include "hidden/lines/uppermost_parts.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <set>
#include <tuple>

namespace displayfile {

namespace {

constexpr std::uint32_t kNothing = 0xffffffffu;

class UppermostParts {
 public:
  UppermostParts(std::span<const LineOfPicture> lines, std::span<const RankedPiece> pieces,
                 double apart)
      : lines_(lines), pieces_(pieces), apart_(apart) {}

  std::vector<DrawnPart> parts() {
    list_lines();
    for (std::size_t from = 0; from < runs_.size();) {
      std::size_t to = from + 1;
      while (to < runs_.size() && are_on_one_line(runs_[from], runs_[to])) ++to;
      on_one_line(std::span(runs_).subspan(from, to - from));
      from = to;
    }
    std::ranges::sort(left_, {},
                      [](const DrawnPart& part) { return std::tuple(part.piece, part.from); });
    return std::move(left_);
  }

 private:
  /// Consecutive pieces of one line and one group, by number.
  struct Run {
    std::uint32_t first, end;
    std::uint32_t leader, group;  ///< the leader on which the line lies; the pieces' group
  };

  static bool are_on_one_line(const Run& a, const Run& b) {
    return a.leader == b.leader && a.group == b.group;
  }

  void list_lines() {
    assert(std::ranges::is_sorted(pieces_, {}, &RankedPiece::line));
    const std::vector<std::uint32_t> leaders = leading_lines(lines_, apart_);
    const auto goes_on = [&](std::uint32_t k) {
      return pieces_[k].line == pieces_[k - 1].line && pieces_[k].group == pieces_[k - 1].group;
    };
    for (std::uint32_t k = 0; k < pieces_.size(); ++k) {
      if (k > 0 && goes_on(k)) {
        runs_.back().end = k + 1;
      } else {
        runs_.push_back({k, k + 1, leaders[pieces_[k].line], pieces_[k].group});
      }
    }
    std::ranges::stable_sort(runs_, {},
                             [](const Run& run) { return std::tuple(run.leader, run.group); });
  }

  void leave(std::uint32_t piece) {
    if (pieces_[piece].is_wanted) left_.push_back({piece, pieces_[piece].from, pieces_[piece].to});
  }

  bool is_any_wanted(std::span<const Run> runs) const {
    for (const Run& run : runs) {
      for (std::uint32_t k = run.first; k < run.end; ++k) {
        if (pieces_[k].is_wanted) return true;
      }
    }
    return false;
  }

  // ---- Pieces on one line ------------------------------------------------------------------

  /// A piece as a range along the line: of x, or of y if it is steep.
  struct Placed {
    double low, high;
    std::uint32_t piece;
  };
  struct Event {
    double at;
    std::uint32_t placed;
    bool opens;
  };

  double place_on(const LineOfPicture& line, double share) const {
    if (share == 0.0) return line.from[axis_];
    if (share == 1.0) return line.to[axis_];
    return line.from[axis_] + share * (line.to[axis_] - line.from[axis_]);
  }

  void place(std::uint32_t piece) {
    const auto& [line, share_from, share_to, rank, group, is_wanted] = pieces_[piece];
    const double from = place_on(lines_[line], share_from), to = place_on(lines_[line], share_to);
    if (from == to) return leave(piece);  // equal after rounding
    const auto index = static_cast<std::uint32_t>(placed_.size());
    placed_.push_back({std::min(from, to), std::max(from, to), piece});
    events_.push_back({placed_.back().low, index, true});
    events_.push_back({placed_.back().high, index, false});
  }

  void on_one_line(std::span<const Run> runs) {
    if (runs.size() == 1) {
      for (std::uint32_t k = runs[0].first; k < runs[0].end; ++k) leave(k);
      return;
    }
    if (!is_any_wanted(runs)) return;
    const LineOfPicture& leader = lines_[runs.front().leader];
    const Point2 along = leader.to - leader.from;
    axis_ = std::abs(along.x) >= std::abs(along.y) ? 0 : 1;
    placed_.clear();
    events_.clear();
    for (const Run& run : runs) {
      for (std::uint32_t k = run.first; k < run.end; ++k) place(k);
    }
    std::ranges::sort(events_, {}, &Event::at);
    sweep();
  }

  /// Sweeps along the line: where several pieces overlap, the one of the lowest rank is drawn, the
  /// first of equal ones.
  void sweep() {
    std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> here;  // rank, piece, placed
    std::uint32_t drawn = kNothing;
    double since = 0.0;
    for (std::size_t k = 0; k < events_.size();) {
      const double at = events_[k].at;
      for (; k < events_.size() && events_[k].at == at; ++k) {
        const auto [_, index, opens] = events_[k];
        const std::uint32_t piece = placed_[index].piece;
        const std::tuple key(pieces_[piece].rank, piece, index);
        opens ? static_cast<void>(here.insert(key)) : static_cast<void>(here.erase(key));
      }
      const std::uint32_t next = here.empty() ? kNothing : std::get<2>(*here.begin());
      if (next == drawn) continue;
      if (drawn != kNothing) add_part(placed_[drawn], since, at);
      drawn = next;
      since = at;
    }
    assert(here.empty() && drawn == kNothing);
  }

  /// Adds a drawn part of a piece, unless it is a crumb: no longer than lines may be apart, or than
  /// the rounding error of its ends.
  void add_part(const Placed& placed, double low, double high) {
    constexpr double kRoundingOfEnds = 0x1p-46;
    const RankedPiece& whole = pieces_[placed.piece];
    if (!whole.is_wanted) return;
    if (low == placed.low && high == placed.high) return leave(placed.piece);
    const double crumb =
        std::max(apart_, kRoundingOfEnds * std::max(std::abs(low), std::abs(high)));
    if (high - low <= crumb) return;
    const LineOfPicture& line = lines_[whole.line];
    const double own_from = place_on(line, whole.from), own_to = place_on(line, whole.to);
    const auto share = [&](double at) {
      if (at == own_from) return whole.from;
      if (at == own_to) return whole.to;
      const double t = (at - line.from[axis_]) / (line.to[axis_] - line.from[axis_]);
      return std::clamp(t, whole.from, whole.to);
    };
    const bool forward = own_from < own_to;
    const double a = share(forward ? low : high), b = share(forward ? high : low);
    if (a < b) left_.push_back({placed.piece, a, b});
  }

  std::span<const LineOfPicture> lines_;
  std::span<const RankedPiece> pieces_;
  double apart_;
  std::vector<Run> runs_;
  std::vector<DrawnPart> left_;
  int axis_ = 0;
  std::vector<Placed> placed_;
  std::vector<Event> events_;
};

}  // namespace

std::vector<DrawnPart> uppermost_parts(std::span<const LineOfPicture> lines,
                                       std::span<const RankedPiece> pieces, double apart) {
  return UppermostParts(lines, pieces, apart).parts();
}

}  // namespace displayfile
