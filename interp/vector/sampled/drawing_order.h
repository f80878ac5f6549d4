#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

namespace displayfile {

/// Somewhere polygon `seen` is seen and polygon `hidden` is behind it.
struct Overlap {
  std::uint32_t hidden, seen;
  auto operator<=>(const Overlap&) const = default;
};

/// One step of drawing: the polygon whole, or once more where it is seen, to mend what was drawn
/// over it.
struct DrawStep {
  std::uint32_t polygon;
  bool mend;
};

/// An order in which each polygon is drawn after those that it hides. Where that is free, the
/// one that reaches farthest back comes first, and of equals the one entered first.
///
/// Polygons that hide each other in a cycle have no such order. All members of a cycle (a strongly
/// connected component) are drawn whole, as well ordered as can be, and then each that another was
/// drawn over is drawn again where it is seen.
///
/// farthest holds a depth for each polygon, larger is nearer; `drawn` is not 0 for those to be
/// drawn. Overlaps with others are ignored. Kahn, "Topological sorting of large networks", CACM 5
/// (1962); Tarjan, "Depth-first search and linear graph algorithms", SIAM J. Comput. 1 (1972).
std::vector<DrawStep> drawing_order(std::vector<Overlap> overlaps, std::span<const double> farthest,
                                    std::span<const std::uint8_t> drawn);

}  // namespace displayfile
