#include "interp/vector/pens/tour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "interp/vector/pens/point_tree.h"

namespace displayfile {

namespace {

constexpr std::size_t kNear = 8;             // ends that are examined from an end
constexpr std::size_t kMostMoved = 3;        // paths, by an Or-opt exchange
constexpr std::size_t kMostTurned = 25'000;  // paths: limits the time
constexpr double kGain = 1e-6;               // less is rounding: exchanges must come to an end

}  // namespace

Tour::Tour(std::vector<SheetPoint> ends)
    : points_(std::move(ends)), places_(points_.size() / 2 + 1) {
  entered_at_.resize(places_);
  place_of_.resize(places_);
  for (Place p = 0; p < places_; ++p) put(p, 2 * p);
}

double Tour::distance(End a, End b) const {
  if (a >= points_.size() || b >= points_.size()) return 0.0;
  return std::sqrt(static_cast<double>(squared_distance(points_[a], points_[b])));
}

Tour::End Tour::enter(Place p, bool forward) const { return entered_at_[p] ^ (forward ? 0u : 1u); }

Tour::Place Tour::after(Place p, bool forward, std::size_t steps) const {
  const std::size_t to = forward ? p + steps : p + places_ - steps;
  return static_cast<Place>(to >= places_ ? to - places_ : to);
}

std::size_t Tour::steps_between(Place from, Place to, bool forward) const {
  const std::size_t steps = forward ? to + places_ - from : from + places_ - to;
  return steps >= places_ ? steps - places_ : steps;
}

void Tour::put(Place p, End entered) {
  entered_at_[p] = entered;
  place_of_[entered / 2] = p;
}

void Tour::look_at(End end) {
  if (end >= points_.size() || queued_[end] != 0) return;
  queued_[end] = 1;
  to_look_at_.push_back(end);
}

void Tour::find_near_ends() {
  const PointTree tree(points_);
  near_count_ = std::min(kNear, points_.size() - 2);
  near_.clear();
  near_.reserve(points_.size() * near_count_);
  std::vector<std::uint32_t> found;
  for (End end = 0; end < points_.size(); ++end) {
    tree.nearest(points_[end], near_count_ + 2, found);
    std::erase_if(found, [&](End other) { return other / 2 == end / 2; });
    near_.insert(near_.end(), found.begin(),
                 found.begin() + static_cast<std::ptrdiff_t>(near_count_));
  }
}

/// Reverses the part of the cyclic tour between two places, or else the rest of it, which is
/// equivalent.
void Tour::reverse(Place first, Place last) {
  std::size_t paths = steps_between(first, last, true) + 1;
  if (2 * paths > places_) {
    std::swap(first, last);
    first = after(first, true);
    last = after(last, false);
    paths = places_ - paths;
  }
  for (std::size_t k = 0; k < paths / 2; ++k) {
    const End a = entered_at_[first], b = entered_at_[last];
    put(first, b ^ 1u);
    put(last, a ^ 1u);
    first = after(first, true);
    last = after(last, false);
  }
  if (paths % 2 == 1) put(first, entered_at_[first] ^ 1u);
}

/// 2-opt: the tour goes from a to b and from c to d; afterwards from a to c and from b to d.
bool Tour::turn_round(End a, End b, End c, Place at_c, bool forward, double gain) {
  const Place at_a = place_of_[a / 2];
  const End d = enter(after(at_c, forward), forward);
  gain += distance(c, d) - distance(b, d);
  if (gain <= kGain) return false;
  const Place from = after(at_a, forward);
  const std::size_t paths = steps_between(from, at_c, forward) + 1;
  if (std::min(paths, places_ - paths) > kMostTurned) return false;
  forward ? reverse(from, at_c) : reverse(at_c, from);
  for (const End end : {a, b, c, d}) look_at(end);
  return true;
}

/// Or-opt: moves up to three paths, of which c is the first or the last end, between a and b, with
/// c next to a.
bool Tour::move_here(End a, End b, End c, Place at_c, bool forward, double gain) {
  const Place at_a = place_of_[a / 2], at_b = after(at_a, forward);
  // From c the moved paths continue in this direction: forward if the tour enters at c.
  const bool onward = enter(at_c, forward) == c ? forward : !forward;
  const End before = leave(after(at_c, !onward), onward);  // the end before c
  Place at_last = at_c;
  for (std::size_t moved = 1; moved <= kMostMoved; ++moved, at_last = after(at_last, onward)) {
    if (at_last == at_a || at_last == at_b) return false;
    const End last = leave(at_last, onward), next = enter(after(at_last, onward), onward);
    const double all = gain + distance(before, c) + distance(last, next) - distance(last, b) -
                       distance(before, next);
    if (all <= kGain) continue;
    // In the direction `forward`, the moved paths are ahead of b, or behind a.
    const Place low = onward == forward ? at_c : at_last, high = onward == forward ? at_last : at_c;
    const std::size_t ahead = steps_between(at_b, low, forward);
    const std::size_t behind = steps_between(high, at_a, forward);
    if (std::min(ahead, behind) > kMostTurned) continue;
    std::array<End, kMostMoved> taken{};
    for (std::size_t k = 0; k < moved; ++k) taken[k] = enter(after(at_c, onward, k), onward);
    Place at = 0;
    if (ahead <= behind) {  // the paths between are shifted
      for (std::size_t k = 0; k < ahead; ++k) {
        put(after(high, !forward, k), entered_at_[after(low, !forward, k + 1)]);
      }
      at = at_b;
    } else {
      for (std::size_t k = 0; k < behind; ++k) {
        put(after(low, forward, k), entered_at_[after(high, forward, k + 1)]);
      }
      at = after(at_a, !forward, moved - 1);
    }
    for (std::size_t k = 0; k < moved; ++k) {
      put(after(at, forward, k), taken[k] ^ (forward ? 0u : 1u));
      look_at(taken[k]);
      look_at(taken[k] ^ 1u);
    }
    for (const End end : {a, b, before, next}) look_at(end);
    return true;
  }
  return false;
}

bool Tour::improve_at(End a) {
  const Place at_a = place_of_[a / 2];
  const bool forward = leave(at_a, true) == a;
  const End b = enter(after(at_a, forward), forward);
  const double now = distance(a, b);
  for (std::size_t k = 0; k < near_count_; ++k) {
    const End c = near_[a * near_count_ + k];
    const double gain = now - distance(a, c);
    if (gain <= kGain) return false;
    const Place at_c = place_of_[c / 2];
    if (leave(at_c, forward) == c && turn_round(a, b, c, at_c, forward, gain)) return true;
    if (c != b && move_here(a, b, c, at_c, forward, gain)) return true;
  }
  return false;
}

void Tour::improve() {
  if (points_.size() < 4) return;
  find_near_ends();
  queued_.assign(points_.size(), 0);
  to_look_at_.clear();
  for (Place p = 0; p < places_; ++p) {
    look_at(enter(p, true));
    look_at(leave(p, true));
  }
  for (std::size_t next = 0; next < to_look_at_.size(); ++next) {
    const End end = to_look_at_[next];
    queued_[end] = 0;
    while (improve_at(end)) {
    }
    if (next == points_.size()) {  // drops the processed part of the queue
      to_look_at_.erase(to_look_at_.begin(),
                        to_look_at_.begin() + static_cast<std::ptrdiff_t>(next) + 1);
      next = static_cast<std::size_t>(-1);
    }
  }
}

std::vector<Tour::End> Tour::entered() const {
  std::vector<End> ends;
  const auto nowhere = static_cast<Path>(places_ - 1);
  const Place start = place_of_[nowhere];
  for (Place p = after(start, true); p != start; p = after(p, true)) ends.push_back(enter(p, true));
  return ends;
}

}  // namespace displayfile
