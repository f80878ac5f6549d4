#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "clip/geometry/corners.h"
#include "hidden/lines/line_table.h"
#include "hidden/lines/side_table.h"

namespace displayfile {

/// The items visible immediately left and right of a line, along all of it, among the polygons
/// added so far: on each side stretches from place to place, each with one polygon or none. A
/// polygon covers the inside of its boundary (even-odd), at the depth of its plane. Where two have
/// the same depth on the line, the one nearer beside it is visible, and of coplanar ones the one
/// entered later (hidden/map/visible_map.md).
///
/// Carrier is SideCarrier or MeetingCarrier: the line itself. Reuses its memory, so that nothing is
/// allocated per polygon.
template <class Carrier>
class SeenAlongLine {
 public:
  using Place = typename Carrier::Place;
  static constexpr std::uint32_t kNothing = std::numeric_limits<std::uint32_t>::max();
  enum Side : std::uint8_t { kLeft, kRight };

  /// A polygon, by its index among those added; kNothing: none.
  struct Stretch {
    Place from, to;
    std::uint32_t face;
  };
  struct Face {
    std::uint32_t item;
    Plane plane;
  };

  SeenAlongLine(const LineTable& scene, const SideTable& sides, Carrier line)
      : scene_(scene), sides_(sides), line_(std::move(line)) {}

  Carrier& line() { return line_; }

  /// Starts with nothing visible along the carrier's line. The visibility of the first `contested`
  /// polygons added is contested by the others, which do not contest each other.
  void begin(std::uint32_t contested = kNothing) {
    contested_ = contested;
    is_settled_ = {false, false};
    faces_.clear();
    ends_.clear();
    for (auto& stretches : seen_) {
      stretches.clear();
      stretches.push_back({line_.start(), line_.end(), kNothing});
    }
  }
  /// The polygon is visible along all of one side; settled: independent of later additions.
  void begin_with(Side side, std::uint32_t item, bool is_settled) {
    assert(seen_[side].size() == 1);
    faces_.push_back({item, scene_.plane(item)});
    seen_[side].front().face = static_cast<std::uint32_t>(faces_.size() - 1);
    is_settled_[side] = is_settled;
  }

  const std::vector<Stretch>& seen(Side side) const { return seen_[side]; }
  /// The item of a stretch; kNothing: none.
  std::uint32_t item(const Stretch& stretch) const {
    assert(stretch.face == kNothing || stretch.face < faces_.size());
    return stretch.face == kNothing ? kNothing : faces_[stretch.face].item;
  }

  /// Adds a polygon that hides. True if it changes anything. on_line(place) is called where its
  /// boundary touches the line, and along_line(before, corner) for each side that lies on it.
  template <class OnLine, class AlongLine>
  bool add(std::uint32_t item, const OnLine& on_line, const AlongLine& along_line) {
    assert(scene_.hides(item));
    const std::uint32_t sides = scene_.sides(item);
    side_.resize(sides);
    bool left = false, right = false, on = false;
    for (std::uint32_t k = 0; k < sides; ++k) {
      const int side = line_.side(scene_.corner(item, k));
      side_[k] = static_cast<std::int8_t>(side);
      left |= side > 0;
      right |= side < 0;
      on |= side == 0;
    }
    if (on) tell_of_corners(item, on_line, along_line);
    bool changed = false;
    bool known = false;
    for (const Side side : {kLeft, kRight}) {
      if (is_settled_[side] || !(side == kLeft ? left : right)) continue;
      find_crossings(item, side);
      for (std::size_t k = 0; k + 1 < crossings_.size(); k += 2) {
        if (line_.compare(crossings_[k], crossings_[k + 1]) == 0) {
          on_line(crossings_[k]);
          continue;
        }
        if (!known) {
          known = true;
          faces_.push_back({item, scene_.plane(item)});
        }
        changed |= insert(side, crossings_[k], crossings_[k + 1]);
      }
    }
    return changed;
  }

  /// True if the polygon whose cover ends at a place has the depth of the stretch's there.
  bool touches(const Stretch& stretch, std::uint32_t face, const Place& at) {
    if (stretch.face == face) return true;  // its own boundary crosses itself there
    if (stretch.face >= contested_) return false;
    const Order order = order_of(face, stretch.face);
    if (order.at_start == 0 && order.at_end == 0) return true;
    if (order.at_start * order.at_end >= 0) return false;
    return line_.compare(meeting_of(face, stretch.face), at) == 0;
  }
  /// Ends of polygons' covers, except the line's own ends.
  struct End {
    Place at;
    std::uint32_t face;
  };
  const std::vector<End>& ends() const { return ends_; }

 private:
  struct Order {
    int at_start, at_end;
  };

  template <class OnLine, class AlongLine>
  void tell_of_corners(std::uint32_t item, const OnLine& on_line, const AlongLine& along_line) {
    const auto sides = static_cast<std::uint32_t>(side_.size());
    for (std::uint32_t k = 0; k < sides; ++k) {
      if (side_[k] != 0) continue;
      on_line(line_.at_point(vertex(item, k)));
      const std::uint32_t before = previous_corner(k, sides);
      if (side_[before] == 0) along_line(before, k);
    }
  }

  /// The crossings of the boundary with a line infinitely close on that side, sorted. Inside is
  /// between the first and the second, and so on (even-odd).
  void find_crossings(std::uint32_t item, Side side) {
    crossings_.clear();
    const auto is_beyond = [&](std::uint32_t k) {
      return side == kLeft ? side_[k] > 0 : side_[k] < 0;
    };
    const auto sides = static_cast<std::uint32_t>(side_.size());
    std::uint32_t k = sides - 1;
    for (std::uint32_t next = 0; next < sides; k = next++) {
      if (is_beyond(k) == is_beyond(next)) continue;
      const std::uint32_t p = vertex(item, k), q = vertex(item, next);
      crossings_.push_back(side_[k] == 0      ? line_.at_point(p)
                           : side_[next] == 0 ? line_.at_point(q)
                                              : line_.crossing(p, q));
    }
    assert(crossings_.size() % 2 == 0);  // the boundary is closed
    const auto is_before = [&](const Place& p, const Place& q) { return line_.compare(p, q) < 0; };
    if (crossings_.size() > 2) {
      std::ranges::sort(crossings_, is_before);
    } else if (crossings_.size() == 2 && is_before(crossings_[1], crossings_[0])) {
      std::swap(crossings_[0], crossings_[1]);
    }
    beside_ = kNothing;
    for (std::uint32_t corner = 0; corner < sides && beside_ == kNothing; ++corner) {
      if (is_beyond(corner)) beside_ = corner;
    }
  }

  /// The point of a corner, the first of equal ones.
  std::uint32_t vertex(std::uint32_t item, std::uint32_t corner) const {
    return sides_.vertex(scene_.corner_point(item, corner));
  }

  /// The number of common points of two triangles that lie in both their planes, and two of them.
  std::size_t shared_points(std::uint32_t one, std::uint32_t two,
                            std::array<std::uint32_t, 2>& shared) const {
    std::size_t count = 0;
    if (scene_.sides(one) != 3 || scene_.sides(two) != 3) return count;
    for (std::uint32_t i = 0; i < 3; ++i) {
      for (std::uint32_t j = 0; j < 3; ++j) {
        if (vertex(one, i) != vertex(two, j)) continue;
        if (scene_.is_off_plane(one, i) || scene_.is_off_plane(two, j)) continue;
        if (count < 2) shared[count] = vertex(one, i);
        ++count;
      }
    }
    return count;
  }

  Order order_of(std::uint32_t face, std::uint32_t other) const {
    const Plane &one = faces_[face].plane, &two = faces_[other].plane;
    return {line_.order_at_start(one, two), line_.order_at_end(one, two)};
  }
  /// Neighbours meet where the side that they share crosses the line.
  Place meeting_of(std::uint32_t face, std::uint32_t other) {
    const std::uint32_t one = faces_[face].item, two = faces_[other].item;
    std::array<std::uint32_t, 2> shared{};
    if (shared_points(one, two, shared) == 2) return line_.crossing(shared[0], shared[1]);
    return line_.meeting(faces_[face].item, faces_[face].plane, faces_[other].item,
                         faces_[other].plane);
  }

  /// True if the polygon added last is nearer than another beside the line, when both have the same
  /// depth all along it.
  bool is_nearer_beside(std::uint32_t other) const {
    assert(other + 1 < faces_.size() && beside_ != kNothing);
    const Face &one = faces_.back(), &two = faces_[other];
    const int order = line_.order_beside(one.plane, two.plane, scene_.corner(one.item, beside_));
    return order != 0 ? order > 0 : one.item > two.item;
  }

  /// Makes the polygon added last visible from place to place, where it is nearer.
  bool insert(Side side, const Place& from, const Place& to) {
    const auto face = static_cast<std::uint32_t>(faces_.size() - 1);
    std::vector<Stretch>& seen = seen_[side];
    bool changed = false;
    next_.clear();
    for (const Stretch& old : seen) {
      if (line_.compare(old.to, from) <= 0 || line_.compare(to, old.from) <= 0) {
        next_.push_back(old);
        continue;
      }
      Place first = line_.compare(old.from, from) < 0 ? from : old.from;
      Place last = line_.compare(to, old.to) < 0 ? to : old.to;
      if (!nearer_part(face, old.face, first, last)) {
        next_.push_back(old);
        continue;
      }
      changed = true;
      if (line_.compare(old.from, first) < 0) push({old.from, first, old.face});
      push({first, last, face});
      if (line_.compare(last, old.to) < 0) push({last, old.to, old.face});
    }
    const auto note_end = [&](const Place& at) {
      if (line_.compare(line_.start(), at) < 0 && line_.compare(at, line_.end()) < 0) {
        ends_.push_back({at, face});
      }
    };
    note_end(from);
    note_end(to);
    if (changed) std::swap(seen, next_);
    return changed;
  }

  /// Reduces a part to where the face is nearer than the other; false if that is empty.
  bool nearer_part(std::uint32_t face, std::uint32_t other, Place& from, Place& to) {
    if (other == kNothing) return true;
    if (other >= contested_) return false;
    const Order order = order_of(face, other);
    if (order.at_start == 0 && order.at_end == 0) return is_nearer_beside(other);
    if (order.at_start >= 0 && order.at_end >= 0) return true;
    if (order.at_start <= 0 && order.at_end <= 0) return false;
    const Place meeting = meeting_of(face, other);
    if (order.at_start > 0) {
      if (line_.compare(meeting, to) < 0) to = meeting;
    } else if (line_.compare(from, meeting) < 0) {
      from = meeting;
    }
    return line_.compare(from, to) < 0;
  }

  void push(const Stretch& stretch) {
    if (!next_.empty() && next_.back().face == stretch.face) {
      next_.back().to = stretch.to;
    } else {
      next_.push_back(stretch);
    }
  }

  const LineTable& scene_;
  const SideTable& sides_;
  Carrier line_;
  std::uint32_t contested_ = kNothing;
  std::array<bool, 2> is_settled_{};
  std::vector<Face> faces_;
  std::array<std::vector<Stretch>, 2> seen_;
  std::vector<Stretch> next_;
  std::vector<End> ends_;
  std::vector<std::int8_t> side_;  // side of the line of each corner of the added polygon
  std::vector<Place> crossings_;
  std::uint32_t beside_ = kNothing;  // a corner of it on the current side
};

}  // namespace displayfile
