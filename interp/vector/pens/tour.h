#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "interp/vector/pens/stroke.h"

namespace displayfile {

/// A tour through paths with two ends each, to be shortened by local exchanges. Ends are numbered:
/// path k has 2k, its entry in the given direction, and 2k + 1, its exit.
class Tour {
 public:
  using End = std::uint32_t;

  /// Takes the points of all ends; the initial tour visits the paths in the given order.
  explicit Tour(std::vector<SheetPoint> ends);

  /// Exchanges until none shortens the tour. Examined are, for each end, those near it: 2-opt,
  /// reversal of a part of the tour, and Or-opt, a move of up to three paths to another place, in
  /// either direction.
  void improve();

  /// The ends where paths are entered, in order.
  std::vector<End> entered() const;

 private:
  // Places on the tour are cyclic: after the last path stands a dummy at distance 0 from every end,
  // so that the tour may begin and end anywhere.
  using Place = std::uint32_t;
  using Path = std::uint32_t;

  double distance(End a, End b) const;
  End enter(Place p, bool forward) const;
  End leave(Place p, bool forward) const { return enter(p, forward) ^ 1u; }
  Place after(Place p, bool forward, std::size_t steps = 1) const;
  std::size_t steps_between(Place from, Place to, bool forward) const;

  bool improve_at(End a);
  bool turn_round(End a, End b, End c, Place at_c, bool forward, double gain);
  bool move_here(End a, End b, End c, Place at_c, bool forward, double gain);
  void reverse(Place first, Place last);
  void put(Place p, End entered);
  void look_at(End end);
  void find_near_ends();

  std::vector<SheetPoint> points_;
  std::size_t places_;           // the paths, and the dummy
  std::vector<End> entered_at_;  // by place
  std::vector<Place> place_of_;  // of each path
  std::vector<End> near_;        // kNear for each end
  std::size_t near_count_ = 0;   // for each end
  std::vector<End> to_look_at_;  // a queue
  std::vector<std::uint8_t> queued_;
};

}  // namespace displayfile
