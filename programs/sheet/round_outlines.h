#pragma once

#include <optional>
#include <vector>

#include "clip/point.h"
#include "interp/vector/dxf/dxf_drawing.h"

namespace displayfile {

using OutlineArc = DxfDrawing::Arc;

/// A part of an outline: a polyline, or an arc in its place.
struct OutlinePiece {
  std::vector<Point2> points;  ///< of an arc too: its facets'
  bool closed = false;
  std::optional<OutlineArc> arc{};
};

/// How far vertices may be from a circle, in mm.
inline constexpr double kRoundTolerance = 0.001;

/// Divides an outline, in mm, into arcs and the polylines between them. An arc replaces four or
/// more sides of equal length that meet at equal angles of at most 15 degrees, as the facets of a
/// curved surface do, if all their ends are within the tolerance of one circle. A closed outline
/// that consists of these alone is a whole circle.
std::vector<OutlinePiece> round_pieces(const std::vector<Point2>& points, bool closed);

}  // namespace displayfile
