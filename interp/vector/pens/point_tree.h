#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "interp/vector/pens/stroke.h"

namespace displayfile {

/// Nearest-point queries with removal: a k-d tree whose nodes count the points left below them.
class PointTree {
 public:
  static constexpr std::uint32_t kNone = 0xffffffffu;

  explicit PointTree(std::span<const SheetPoint> points);

  /// The number of the nearest point left, of equally near ones the first; kNone if none is left.
  std::uint32_t nearest(const SheetPoint& to) const;
  /// The numbers of the `count` nearest points left, the nearest first, into `found`. `count` is 1
  /// or more.
  void nearest(const SheetPoint& to, std::size_t count, std::vector<std::uint32_t>& found) const;
  void remove(std::uint32_t point);

 private:
  static constexpr std::size_t kLeaf = 8;  // points at most
  struct Node {
    SheetPoint low, high;
    std::uint32_t begin, end;  // in numbers_
    std::uint32_t left;        // children are left and left + 1; 0: a leaf
    std::uint32_t parent;
    std::uint32_t points_left;
  };
  struct Candidate {
    std::int64_t squared;
    std::uint32_t point;
    auto operator<=>(const Candidate&) const = default;
  };

  void build(std::uint32_t node);
  void search(std::uint32_t node, const SheetPoint& to, std::size_t count) const;
  static std::int64_t squared_distance_to(const Node& node, const SheetPoint& p);

  std::span<const SheetPoint> points_;
  std::vector<std::uint32_t> numbers_;
  std::vector<std::uint32_t> leaf_of_;  // of each point; kNone if it was removed
  std::vector<Node> nodes_;
  mutable std::vector<Candidate> best_;  // a heap, the farthest first
};

}  // namespace displayfile
