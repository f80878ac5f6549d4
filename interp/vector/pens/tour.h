#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "interp/vector/pens/stroke.h"

namespace displayfile {

/// A way through paths that have two ends each, to be made shorter by local exchanges. Ends are
/// numbered: path k has 2k, where it is entered as it is given, and 2k + 1, where it is left.
class Tour {
 public:
  using End = std::uint32_t;

  /// The points of all ends; the way at first is from path to path as they are given.
  explicit Tour(std::vector<SheetPoint> ends);

  /// Exchanges until none makes the way shorter. Looked at are, for each end, those that are near
  /// it: 2-opt, a part of the way the other way round, and Or-opt, up to three paths moved to
  /// another place, either way round.
  void improve();

  /// The ends where paths are entered, in order.
  std::vector<End> entered() const;

 private:
  // Places on the way are cyclic: after the last path stands one that is nowhere, at distance 0
  // from every end, so that the way may begin and end where it likes.
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
  std::size_t places_;           // the paths, and nowhere
  std::vector<End> entered_at_;  // by place
  std::vector<Place> place_of_;  // of each path
  std::vector<End> near_;        // kNear for each end
  std::size_t near_count_ = 0;   // for each end
  std::vector<End> to_look_at_;  // a queue
  std::vector<std::uint8_t> queued_;
};

}  // namespace displayfile
