#include "hidden/lines/chains.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <tuple>

#include "clip/geometry/secret_hash.h"

namespace displayfile {

namespace {

/// An end of a piece: twice the piece's number for its start, plus 1 for its end.
using End = std::uint32_t;

class Joints {
 public:
  static constexpr End kNone = std::numeric_limits<End>::max();

  explicit Joints(std::span<const ChainLink> pieces)
      : pieces_(pieces), mate_(2 * pieces.size(), kNone) {
    number_points();
    list_ends();
    for (std::size_t k = 0; k + 1 < first_.size(); ++k) {
      join(std::span(ends_).subspan(first_[k], first_[k + 1] - first_[k]));
    }
  }

  /// The end that continues at this one, or kNone.
  End mate(End end) const { return mate_[end]; }

 private:
  const Point3& point(End end) const {
    const ChainLink& piece = pieces_[end / 2];
    return end % 2 == 0 ? piece.from : piece.to;
  }
  std::uint64_t key(End end) const { return pieces_[end / 2].key; }

  /// Numbers the ends: those at the same point with the same key get one number. Uses a hash table
  /// with more than twice as many places as ends.
  void number_points() {
    const std::size_t mask = std::bit_ceil(2 * mate_.size() + 1) - 1;
    const SecretHash hash;
    std::vector<End> table(mask + 1, kNone);
    number_.resize(mate_.size());
    for (End end = 0; end < mate_.size(); ++end) {
      std::size_t at = hash(point(end), key(end)) & mask;
      while (table[at] != kNone &&
             !(key(table[at]) == key(end) && point(table[at]) == point(end))) {
        at = (at + 1) & mask;
      }
      if (table[at] == kNone) table[at] = end;
      number_[end] = table[at] == end ? points_++ : number_[table[at]];
    }
  }

  /// Groups the ends by point number; those of one point are in order.
  void list_ends() {
    first_.assign(points_ + 1, 0);
    for (const std::uint32_t number : number_) ++first_[number + 1];
    for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
    ends_.resize(number_.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (End end = 0; end < number_.size(); ++end) ends_[next[number_[end]]++] = end;
  }

  void mate(End a, End b) {
    assert(a != b && mate_[a] == kNone && mate_[b] == kNone);
    mate_[a] = b;
    mate_[b] = a;
  }

  void join(std::span<const End> ends) {
    constexpr std::size_t kFew = 16;
    if (ends.size() == 2) return mate(ends[0], ends[1]);
    if (ends.size() > kFew) return join_opposite(ends);
    if (ends.size() > 2) join_straightest(ends);
  }

  /// The unit direction from the end along its piece in the projection; 0 if the piece has no
  /// length there.
  Point2 direction(End end) const {
    const Point2 way = Point2(point(end ^ 1u)) - Point2(point(end));
    const double larger = std::max(std::abs(way.x), std::abs(way.y));
    if (larger == 0.0) return {0.0, 0.0};
    const Point2 scaled = way / larger;
    return scaled / std::sqrt(scaled.x * scaled.x + scaled.y * scaled.y);
  }

  /// Joins the straightest pair, then the straightest of the remaining ones, and so on.
  void join_straightest(std::span<const End> ends) {
    directions_.clear();
    for (const End end : ends) directions_.push_back(direction(end));
    pairs_.clear();
    for (std::size_t i = 0; i < ends.size(); ++i) {
      for (std::size_t j = i + 1; j < ends.size(); ++j) {
        const Point2 &a = directions_[i], &b = directions_[j];
        pairs_.push_back({a.x * b.x + a.y * b.y, ends[i], ends[j]});  // -1: straight on
      }
    }
    std::ranges::sort(pairs_, [](const Pair& a, const Pair& b) {
      return std::tie(a.back, a.one, a.other) < std::tie(b.back, b.one, b.other);
    });
    for (const auto& [back, one, other] : pairs_) {
      if (mate_[one] == kNone && mate_[other] == kNone) mate(one, other);
    }
  }

  /// Joins many ends: sorted by angle, each with the one half of them further on.
  void join_opposite(std::span<const End> ends) {
    angles_.clear();
    for (const End end : ends) {
      const Point2 d = direction(end);
      // Grows from 0 to 4 with the angle, without a library's rounding.
      const double part = d.x / (std::abs(d.x) + std::abs(d.y) + 0x1p-1000);
      angles_.emplace_back(d.y >= 0.0 ? 1.0 - part : 3.0 + part, end);
    }
    std::ranges::sort(angles_);
    const std::size_t half = ends.size() / 2;
    for (std::size_t k = 0; k < half; ++k) mate(angles_[k].second, angles_[k + half].second);
  }

  struct Pair {
    double back;
    End one, other;
  };

  std::span<const ChainLink> pieces_;
  std::vector<End> mate_;
  std::vector<std::uint32_t> number_;  // point number of each end
  std::uint32_t points_ = 0;
  std::vector<std::uint32_t> first_;  // per point, among the ends
  std::vector<End> ends_;
  std::vector<Point2> directions_;
  std::vector<Pair> pairs_;
  std::vector<std::pair<double, End>> angles_;
};

}  // namespace

Chains chains_of(std::span<const ChainLink> pieces) {
  const Joints joints(pieces);
  Chains chains;
  chains.places.reserve(pieces.size());
  std::vector<std::uint8_t> placed(pieces.size(), 0);
  for (End piece = 0; piece < pieces.size(); ++piece) {
    if (placed[piece] != 0) continue;
    // Goes back to the chain's first piece, or around a closed chain to the piece itself.
    End start = 2 * piece;
    for (End before = joints.mate(start); before != Joints::kNone; before = joints.mate(start)) {
      start = before ^ 1u;
      if (start / 2 == piece) break;
    }
    chains.first.push_back(static_cast<std::uint32_t>(chains.places.size()));
    for (End end = start; end != Joints::kNone && placed[end / 2] == 0;
         end = joints.mate(end ^ 1u)) {
      placed[end / 2] = 1;
      chains.places.push_back({end / 2, end % 2 == 1});
    }
  }
  assert(chains.places.size() == pieces.size());
  return chains;
}

}  // namespace displayfile
