#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "clip/point.h"
#include "hidden/lines/hidden_parts.h"

namespace displayfile {

/// A visible stroke of a picture. x and y are device coordinates, z grows toward the viewer.
struct DeepStroke {
  Point3 from, to;
  double width = 1.0;       ///< of the pen, in pixels
  std::uint32_t look = 0;   ///< equal for strokes that look the same
  std::uint32_t entry = 0;  ///< the order of entry, for strokes at one depth
};

/// The picture in which strokes overlap.
struct StrokePicture {
  Point2 pixels{512.0, 512.0};  ///< its size
  double apart = 1e-9;          ///< depths no farther apart than this are equal: the lines meet
};

/// Two strokes that overlap in the picture.
struct StrokeOverlap {
  std::uint32_t far, near;  ///< the strokes; at equal depth `near` is the one entered later
  bool is_tie = false;      ///< equally near
  bool crosses = false;     ///< their axes meet in one point; otherwise only their widths overlap,
                            ///< or one axis runs along the other
  /// The overlap's place, as fractions of each stroke's length, and the part of each that lies
  /// within half of both widths of the other's axis.
  double at_far = 0.0, at_near = 0.0;
  PartOfLine of_far{0.0, 0.0}, of_near{0.0, 0.0};
};

/// All crossings of strokes, and other overlaps of strokes that look different, each pair once, or
/// twice where two lines along each other change places (hidden/lines/strokes_by_depth.md). By
/// exact predicates on the given coordinates: whether axes cross, and which one is nearer there by
/// more than `apart`. Strokes without length in the picture overlap nothing. In order of their
/// numbers. Takes n log n steps, and the steps for pairs of parts whose boxes overlap.
std::vector<StrokeOverlap> stroke_overlaps(std::span<const DeepStroke> strokes,
                                           const StrokePicture& picture, int threads);

/// The part of the way from a to b within `reach` of the line from p to q: no farther than that
/// from its nearest point. In any unit; p and q may be equal. None: no part of it.
std::optional<PartOfLine> part_within(const Point2& a, const Point2& b, const Point2& p,
                                      const Point2& q, double reach);

}  // namespace displayfile
