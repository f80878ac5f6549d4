#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <span>
#include <vector>

#include "displayfile/segments/side_kinds.h"

namespace displayfile {

/// Draws each stretch that is a line once where possible, preferably by sides of polygons that face
/// the viewer, since others may be removed.
class SideKinds::Tiling {
 public:
  Tiling(const SideKinds& sides, std::span<const LineKinds> of_stretches,
         std::span<const std::uint8_t> is_facing, TurnedAway turned_away,
         std::span<LineKinds> of_corners)
      : all_(sides),
        sides_(sides.parted_),
        kinds_(of_stretches),
        is_facing_(is_facing),
        turned_away_(turned_away),
        of_corners_(of_corners),
        is_drawn_(of_stretches.size(), 0),
        reached_by_(of_stretches.size() + 1, kNobody) {
    assert(std::ranges::is_sorted(sides_, {}, &PartedSide::first));
    assert(kinds_.size() == all_.stretches_.size());
    for (std::uint32_t k = 0; k < kinds_.size(); ++k) {
      has_facing_.push_back(std::ranges::any_of(
          sides.faces_of(k), [&](std::uint32_t face) { return is_facing[face] != 0; }));
    }
    const auto end = static_cast<std::uint32_t>(kinds_.size());
    for (std::uint32_t first = 0, last = 0; first < end; first = last) {
      last = end_of_run(first, end, [&](std::uint32_t k) { return kinds_[k] == kinds_[first]; });
      if (kinds_[first] != 0) tile_run(first, last);
    }
    for (const bool facing : {true, false}) {
      for (const PartedSide& side : sides_) {
        if (is_facing_[side.face] == (facing ? 1 : 0) && has_some_left(side)) draw(side);
      }
    }
  }

 private:
  static constexpr std::uint32_t kNobody = 0xffffffffu;
  /// Sides of polygons that face the viewer and are drawn as all kinds of a stretch.
  struct Wanted {
    bool facing = false, whole = false;
  };

  template <class GoesOn>
  std::uint32_t end_of_run(std::uint32_t first, std::uint32_t end, const GoesOn& goes_on) const {
    std::uint32_t last = first + 1;
    while (last < end && !all_.stretches_[last].begins_line && goes_on(last)) ++last;
    return last;
  }

  /// Draws stretches of the same kinds: those of polygons that face the viewer and others
  /// separately if possible, otherwise together.
  void tile_run(std::uint32_t first, std::uint32_t last) {
    bool are_all = true;
    for (const bool draws : {false, true}) {
      for (std::uint32_t from = first, to = first; from < last; from = to) {
        const bool facing = has_facing_[from];
        to = end_of_run(from, last, [&](std::uint32_t k) { return has_facing_[k] == facing; });
        are_all &= tile_alike(from, to, facing, draws);
      }
      if (!draws && !are_all && may_be_any(true) && tile(first, last, {}, true)) return;
    }
  }
  /// Uses sides that may be drawn as all kinds of the stretches, if there are any.
  bool tile_alike(std::uint32_t first, std::uint32_t last, bool has_facing, bool draws) {
    for (const bool whole : {true, false}) {
      for (const bool facing : {true, false}) {
        if (facing ? !has_facing : !may_be_any(has_facing)) continue;
        if (tile(first, last, {.facing = facing, .whole = whole}, draws)) return true;
      }
    }
    return false;
  }
  bool may_be_any(bool has_facing) const {
    return !has_facing || turned_away_ != TurnedAway::removed;
  }

  /// Draws stretches by successive sides from the first stretch to the last, if there are such:
  /// where a face was divided into others, their sides are.
  bool tile(std::uint32_t first, std::uint32_t last, const Wanted& wanted, bool draws) {
    const auto from = std::ranges::lower_bound(sides_, first, {}, &PartedSide::first);
    for (auto side = from; side != sides_.end() && side->first < last; ++side) {
      const bool begins = side->first == first || reached_by_[side->first] != kNobody;
      if (!begins || side->end > last || reached_by_[side->end] != kNobody) continue;
      const LineKinds drawn = kinds_[first] & side->drawn;
      if (drawn == 0 || (wanted.whole && drawn != kinds_[first])) continue;
      if (wanted.facing && is_facing_[side->face] == 0) continue;
      reached_by_[side->end] = static_cast<std::uint32_t>(side - sides_.begin());
    }
    const bool is_reached = reached_by_[last] != kNobody;
    for (std::uint32_t at = last; draws && is_reached && at != first;) {
      const PartedSide& side = sides_[reached_by_[at]];
      draw(side);
      if (turned_away_ == TurnedAway::stays && is_facing_[side.face] == 0) mark(side);
      at = side.first;
    }
    std::fill(reached_by_.begin() + first, reached_by_.begin() + last + 1, kNobody);
    return is_reached;
  }
  /// Marks the stretches of a side whose polygon faces the viewer.
  void mark(const PartedSide& side) {
    const auto begin = has_facing_.begin();
    if (std::find(begin + side.first, begin + side.end, true) == begin + side.end) return;
    LineKinds& of_side = of_corners_[side.corner];
    of_side = static_cast<LineKinds>(of_side | kByBackFace);
  }
  bool has_some_left(const PartedSide& side) const {
    for (std::uint32_t k = side.first; k < side.end; ++k) {
      if (is_drawn_[k] == 0 && (kinds_[k] & side.drawn) != 0) return true;
    }
    return false;
  }
  void draw(const PartedSide& side) {
    LineKinds& of_side = of_corners_[side.corner];
    for (std::uint32_t k = side.first; k < side.end; ++k) {
      of_side = static_cast<LineKinds>(of_side | (kinds_[k] & side.drawn));
      is_drawn_[k] = 1;
    }
  }

  const SideKinds& all_;
  std::span<const PartedSide> sides_;
  std::span<const LineKinds> kinds_;
  std::span<const std::uint8_t> is_facing_;
  TurnedAway turned_away_;
  std::span<LineKinds> of_corners_;
  std::vector<bool> has_facing_;  // of the stretches
  std::vector<std::uint8_t> is_drawn_;
  std::vector<std::uint32_t> reached_by_;  // of each stretch's start: a side that ends there
};

}  // namespace displayfile
