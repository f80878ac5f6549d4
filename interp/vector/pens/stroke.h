#pragma once

#include <compare>
#include <cstdint>

/// Pen strokes, in the units of the output: whole thousandths of a millimetre.
namespace displayfile {

inline constexpr double kUnitsOfMillimetre = 1000.0;

/// A point of the sheet: from its upper left corner to the right and down, in thousandths of a
/// millimetre. A sheet has sides of at most 10^7 of them, so that a product of two differences, and
/// a sum of two such, is exact in 64 bits.
struct SheetPoint {
  std::int32_t x, y;
  auto operator<=>(const SheetPoint&) const = default;
};

/// A straight line that a pen draws; a dot if it ends where it starts.
struct Stroke {
  SheetPoint from, to;
  bool is_dot() const { return from == to; }
  auto operator<=>(const Stroke&) const = default;
};

/// A pen: its colour (pixel_of, interp/device/picture.h) and the width of its line.
struct Pen {
  std::uint32_t colour;
  std::int32_t width;  ///< thousandths of a millimetre, at least 1
  auto operator<=>(const Pen&) const = default;
};

/// The largest distance, in units, of a point from a stroke on which it still lies. Strokes that
/// were collinear before their ends were rounded are no farther apart: each end moves by at most
/// half of a unit's diagonal, 0.708, and so does the line with which it is compared.
inline constexpr double kOnStroke = 1.5;

/// Differences and products of points, exact.
constexpr std::int64_t cross(const SheetPoint& a, const SheetPoint& b, const SheetPoint& c,
                             const SheetPoint& d) {
  return std::int64_t{b.x - a.x} * (d.y - c.y) - std::int64_t{b.y - a.y} * (d.x - c.x);
}
constexpr std::int64_t dot(const SheetPoint& a, const SheetPoint& b, const SheetPoint& c,
                           const SheetPoint& d) {
  return std::int64_t{b.x - a.x} * (d.x - c.x) + std::int64_t{b.y - a.y} * (d.y - c.y);
}
constexpr std::int64_t squared_distance(const SheetPoint& a, const SheetPoint& b) {
  return dot(a, b, a, b);
}

}  // namespace displayfile
