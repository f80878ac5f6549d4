#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "hidden/boxes/box_tree.h"
#include "interp/scan/pixel_box.h"

namespace displayfile {

/// A box of pixel centres, and the nearest depth of its contents.
struct DeepPixelBox {
  PixelBox pixels;
  float nearest;  ///< no part is nearer; z grows toward the viewer

  static constexpr DeepPixelBox nothing() {
    constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();
    return {{kMost, 0, kMost, 0}, -std::numeric_limits<float>::infinity()};
  }
  void include(const DeepPixelBox& o) {
    pixels = {std::min(pixels.first_column, o.pixels.first_column),
              std::max(pixels.end_column, o.pixels.end_column),
              std::min(pixels.first_row, o.pixels.first_row),
              std::max(pixels.end_row, o.pixels.end_row)};
    nearest = std::max(nearest, o.nearest);
  }

  /// Twice the middle column or row, or the nearest depth.
  static constexpr std::size_t kAxes = 3, kColumn = 0, kRow = 1, kDepth = 2;
  double position(std::size_t axis) const {
    constexpr float kMost = std::numeric_limits<float>::max();
    switch (axis) {
      case kColumn: return static_cast<double>(pixels.first_column) + pixels.end_column;
      case kRow: return static_cast<double>(pixels.first_row) + pixels.end_row;
      default: return std::clamp(nearest, -kMost, kMost);
    }
  }
};

/// Eight of these boxes.
struct PixelBoxes {
  using Box = DeepPixelBox;
  static constexpr std::size_t kBoxes = 8;

  std::array<std::int32_t, kBoxes> first_column, end_column, first_row, end_row;
  std::array<float, kBoxes> nearest;

  void set(std::size_t k, const DeepPixelBox& box) {
    first_column[k] = box.pixels.first_column;
    end_column[k] = box.pixels.end_column;
    first_row[k] = box.pixels.first_row;
    end_row[k] = box.pixels.end_row;
    nearest[k] = box.nearest;
  }
  /// Marks the boxes that share a centre with the rays' box.
  std::array<std::int32_t, kBoxes> meets(const PixelBox& rays) const {
    const auto below = [](std::int32_t a, std::int32_t b) { return a < b ? 1 : 0; };
    std::array<std::int32_t, kBoxes> met;
    for (std::size_t k = 0; k < kBoxes; ++k) {
      met[k] = below(first_column[k], rays.end_column) & below(rays.first_column, end_column[k]) &
               below(first_row[k], rays.end_row) & below(rays.first_row, end_row[k]);
    }
    return met;
  }
};

/// A tree of boxes of pixel centres, for packets of rays along z; it is split where packets have
/// the fewest visits (interp/visibility/ray_cast.md). Boxes are of integers and not empty, and
/// nothing is rounded.
using PixelTree = BoxTree<PixelBoxes>;
template <>
void PixelTree::build(std::size_t items, const std::function<DeepPixelBox(Item)>& box_of,
                      int threads);

/// Visits items that share a centre with the rays, as BoxTree::near_to_far.
template <class Hidden, class Visit>
void front_to_back(const PixelTree& tree, const PixelBox& rays, Hidden&& hidden, Visit&& visit) {
  const auto meets = [&](const PixelBoxes& boxes, std::array<float, PixelBoxes::kBoxes>& nearest) {
    nearest = boxes.nearest;
    return boxes.meets(rays);
  };
  tree.near_to_far<float>(meets, hidden, visit);
}

}  // namespace displayfile
