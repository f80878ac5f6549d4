#include "hidden/lines/lines_on_lines.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "clip/geometry/secret_hash.h"

namespace displayfile {

namespace {

constexpr std::uint32_t kNoLine = std::numeric_limits<std::uint32_t>::max();

/// If the directions of a short line and of one near it differ by more, they do not belong
/// together.
constexpr double kMostTurned = 0x1p-16;
/// The same for lines that may be farther apart, as a multiple of that distance.
constexpr double kTurnedByApart = 64.0;

/// Uncertainty of a leader's supporting line at the leader's length beyond its ends, relative to
/// the uncertainty between them.
constexpr double kBeyond = 3.0;

/// Bounds the rounding error of a direction, and of a distance as a fraction of the largest
/// coordinate: these are below 2^-49.
constexpr double kRounding = 0x1p-46;

/// The approximate supporting line of a line. Only lines of nearly equal direction and distance can
/// lie on each other.
struct Support {
  double direction;  ///< radians, 0 to half a turn
  double distance;   ///< from the middle of all lines, on its left
};

Support support_of(const LineOfPicture& line, const Point2& middle) {
  Point2 way = line.to - line.from;
  if (way.y < 0.0 || (way.y == 0.0 && way.x < 0.0)) way = -way;
  const Point2 from = line.from - middle;
  return {std::atan2(way.y, way.x), (from.y * way.x - from.x * way.y) / std::hypot(way.x, way.y)};
}

double length_of(const LineOfPicture& line) {
  return std::hypot(line.to.x - line.from.x, line.to.y - line.from.y);
}

/// Leaders by cells of directions and distances, large enough that few lines are close to another
/// cell. Leaders of one cell are adjacent in memory.
class LeaderTable {
 public:
  /// The maximum differences of direction and of distance of a line and its leader, and the number
  /// of lines, at least 1.
  LeaderTable(double directions, double distances, std::size_t lines)
      : directions_(directions),
        distances_(distances),
        first_(std::bit_ceil(lines) + 1, 0),
        place_(lines) {}

  /// Reserves room for a line that may be added later; called for all such lines first.
  void make_room_for(const Support& support, std::uint32_t line) {
    place_[line] = static_cast<std::uint32_t>(
        place_of_cell(cell(support.direction, directions_), cell(support.distance, distances_)));
    ++first_[place_[line]];
  }
  void begin() {
    std::uint32_t sum = 0;
    for (std::uint32_t& first : first_) first = std::exchange(sum, sum + first);
    end_ = first_;
    leaders_.resize(sum);
  }
  /// Adds one of the lines with reserved room; called after begin().
  void add(const Support& support, std::uint32_t leader) {
    leaders_[end_[place_[leader]]++] = {support.direction, support.distance, leader};
  }

  /// Calls visit for the leaders whose directions and distances differ by at most these, which must
  /// not exceed the table's; for some twice.
  template <class Visit>
  void near(const Support& support, double directions, double distances, const Visit& visit) const {
    const auto around = [&](double direction, double distance) {
      visit_around({direction, distance}, directions, distances, visit);
    };
    around(support.direction, support.distance);
    // Lines close to either end of the half turn have two representations.
    if (support.direction <= directions) {
      around(support.direction + kHalfTurn, -support.distance);
    } else if (support.direction >= kHalfTurn - directions) {
      around(support.direction - kHalfTurn, -support.distance);
    }
  }

 private:
  static constexpr double kOfCell = 2.0;
  static constexpr double kHalfTurn = std::numbers::pi;

  struct Leader {
    double direction, distance;
    std::uint32_t line;
  };

  static double cell(double value, double part) { return std::floor(value / (kOfCell * part)); }
  /// The hash table's place of a cell; several cells may share one.
  std::size_t place_of_cell(double direction, double distance) const {
    return hash_({direction, distance, 0.0}) & (first_.size() - 2);
  }

  template <class Visit>
  void visit_around(const Support& support, double directions, double distances,
                    const Visit& visit) const {
    const auto [direction, distance] = support;
    if (!std::isfinite(direction) || !std::isfinite(distance)) return;
    const double last_i = cell(direction + directions, directions_),
                 last_k = cell(distance + distances, distances_);
    for (double i = cell(direction - directions, directions_); i <= last_i; ++i) {
      for (double k = cell(distance - distances, distances_); k <= last_k; ++k) {
        const std::size_t place = place_of_cell(i, k);
        for (std::uint32_t n = first_[place]; n < end_[place]; ++n) {
          const Leader& leader = leaders_[n];
          const bool is_near = std::abs(leader.direction - direction) <= directions &&
                               std::abs(leader.distance - distance) <= distances;
          if (is_near) visit(leader.line);
        }
      }
    }
  }

  double directions_, distances_;
  SecretHash hash_;
  std::vector<std::uint32_t> first_, end_;  // per place, among the leaders
  std::vector<std::uint32_t> place_;        // per line
  std::vector<Leader> leaders_;
};

class LeadingLines {
 public:
  LeadingLines(std::span<const LineOfPicture> lines, double apart)
      : lines_(lines), most_turned_(std::max(kMostTurned, kTurnedByApart * apart)) {
    Point2 low(std::numeric_limits<double>::infinity()), high(-low);
    double largest = 0.0;
    for (const LineOfPicture& line : lines) {
      for (const Point2& p : {line.from, line.to}) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
      }
    }
    middle_ = low + 0.5 * (high - low);
    reach_ = std::max(high.x - low.x, high.y - low.y);
    apart_ = std::max(apart, kRounding * largest);
  }

  std::vector<std::uint32_t> numbers() {
    leader_.assign(lines_.size(), kNoLine);
    order_lines();
    for (std::size_t from = 0; from < order_.size();) from = find_leaders_of_level(from);
    return std::move(leader_);
  }

 private:
  /// Sorts lines from the longest to the shortest; `rank_` are the positions in this order.
  void order_lines() {
    order_.resize(lines_.size());
    std::iota(order_.begin(), order_.end(), 0u);
    length_.reserve(lines_.size());
    supports_.reserve(lines_.size());
    for (const LineOfPicture& line : lines_) {
      length_.push_back(length_of(line));
      supports_.push_back(support_of(line, middle_));
    }
    std::ranges::stable_sort(order_, std::greater(), [&](std::uint32_t k) { return length_[k]; });
    rank_.resize(lines_.size());
    for (std::uint32_t n = 0; n < order_.size(); ++n) rank_[order_[n]] = n;
  }

  /// Processes lines of similar length with cells of one size, beginning at that rank. Returns the
  /// rank at which the next level begins.
  std::size_t find_leaders_of_level(std::size_t from) {
    constexpr double kOfLevel = 1.0 / 16.0;
    const double least_turned = 2.0 * kBeyond * apart_ / most_turned_;
    const double longest = length_[order_[from]];
    const bool is_last = longest * kOfLevel <= least_turned;
    const double shortest = is_last ? 0.0 : longest * kOfLevel;
    const double turned = turned_of(shortest);
    std::size_t end = from;
    while (end < order_.size() && (is_last || length_[order_[end]] > shortest)) ++end;
    const auto level = std::span(order_).subspan(from, end - from);
    LeaderTable table(turned, distances_of(turned, reach_), lines_.size());
    for (const std::uint32_t leader : leaders_) table.make_room_for(supports_[leader], leader);
    for (const std::uint32_t line : level) table.make_room_for(supports_[line], line);
    table.begin();
    for (const std::uint32_t leader : leaders_) table.add(supports_[leader], leader);
    for (const std::uint32_t line : level) find_leader(line, table);
    return end;
  }

  /// The maximum angle between a line of that length and its leader: its sine is at most the sum of
  /// both ends' errors over the length.
  double turned_of(double length) const {
    constexpr double kOfSine = 1.02;  // bounds angle / sine for angles below a fifth
    return kOfSine * std::min(kBeyond * most_turned_, 2.0 * kBeyond * apart_ / length) + kRounding;
  }
  /// The maximum difference of distances, for a line with a point at this distance from the middle.
  double distances_of(double turned, double from_middle) const {
    return turned * from_middle + 2.0 * kBeyond * apart_;
  }

  void find_leader(std::uint32_t line, LeaderTable& table) {
    const Support& own = supports_[line];
    const double turned = turned_of(length_[line]);
    const Point2 from = lines_[line].from - middle_;
    const double distances = distances_of(turned, std::hypot(from.x, from.y));
    std::uint32_t first = kNoLine;
    table.near(own, turned, distances, [&](std::uint32_t leader) {
      if (first != kNoLine && rank_[first] < rank_[leader]) return;
      if (lies_on(line, leader)) first = leader;
    });
    leader_[line] = first == kNoLine ? line : first;
    assert(leader_[leader_[line]] == leader_[line] && rank_[leader_[line]] <= rank_[line]);
    if (first != kNoLine) return;
    leaders_.push_back(line);
    table.add(own, line);
  }

  bool lies_on(std::uint32_t line, std::uint32_t leader) const {
    const Point2 from = lines_[leader].from, to = lines_[leader].to;
    const double length = length_[leader];
    if (!std::isfinite(length)) return false;
    const Point2 way = (to - from) / length;
    const double apart = std::min(apart_, 0.5 * most_turned_ * length_[line]);
    const auto is_near = [&](const Point2& p) {
      const Point2 from_it = p - from;
      const double along = way.x * from_it.x + way.y * from_it.y;
      const double beyond = std::clamp(std::max(-along, along - length) / length, 0.0, 1.0);
      return std::abs(way.x * from_it.y - way.y * from_it.x) <=
             apart * (1.0 + (kBeyond - 1.0) * beyond);
    };
    return is_near(lines_[line].from) && is_near(lines_[line].to);
  }

  std::span<const LineOfPicture> lines_;
  Point2 middle_{0.0};
  double reach_ = 0.0, apart_ = 0.0, most_turned_;
  std::vector<double> length_;
  std::vector<Support> supports_;
  std::vector<std::uint32_t> order_, rank_, leader_, leaders_;
};

}  // namespace

std::vector<std::uint32_t> leading_lines(std::span<const LineOfPicture> lines, double apart) {
  if (lines.empty()) return {};
  return LeadingLines(lines, apart).numbers();
}

}  // namespace displayfile
