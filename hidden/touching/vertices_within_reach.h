#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/point.h"

namespace displayfile {

// Vertices that are meant to coincide, and sides on which others end: files round each corner
// separately, and parts cut from several bodies have corners on the sides of their neighbours
// (hidden/touching/vertices_within_reach.md). Any coordinate system; distances are computed in
// doubles.

/// For each point its representative: in order, the first earlier representative within reach, or
/// otherwise itself. With a reach of 0 the first equal point. first[first[i]] = first[i] <= i.
std::vector<std::uint32_t> first_within(std::span<const Point3> points, double reach);

/// A side between two points, given by their indices.
struct SideOfPoints {
  std::uint32_t from, to;
};

/// Sides with the ends of others along them.
class PartedSides {
 public:
  /// Finds ends of the sides that are within reach of another side, between its ends. Indices are
  /// those of representatives, as of first_within.
  PartedSides(std::span<const Point3> points, std::span<const SideOfPoints> sides, double reach);

  /// The vertices along a side, in order from its start to its end, excluding both.
  std::span<const std::uint32_t> along(std::size_t side) const {
    if (first_.empty()) return {};
    assert(side + 1 < first_.size());
    return std::span(along_).subspan(first_[side], first_[side + 1] - first_[side]);
  }
  bool any() const { return !along_.empty(); }

 private:
  std::vector<std::uint32_t> along_, first_;  // of each side; one more at the end
};

}  // namespace displayfile
