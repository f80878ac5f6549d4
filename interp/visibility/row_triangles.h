#pragma once

#include <cstdint>

#include "hidden/exact/pixel_centre.h"

namespace displayfile {

/// Some triangles' corners, in device coordinates: corner k of triangle i is (x[k][i], y[k][i],
/// z[k][i]).
struct TriangleBlock {
  static constexpr int kMost = 8;
  alignas(64) double x[3][kMost], y[3][kMost], z[3][kMost];
};

/// The data of RowFills (interp/visibility/row_fills.h) for each triangle. In bit fields, bit i is
/// triangle i's.
struct RowTriangles {
  static constexpr int kMost = TriangleBlock::kMost;
  alignas(64) std::int32_t row_begin[kMost], row_end[kMost];
  alignas(64) std::int32_t column[kMost], column_end[kMost];
  alignas(64) float z[kMost], dz_dx[kMost], dz_dy[kMost], edge_error[kMost];
  /// The side that ends at corner k; the triangle's direction is from a corner to the next.
  alignas(64) float x[3][kMost], slope[3][kMost];
  std::uint32_t needs_more;   ///< must be prepared one by one: its other data here are not valid
  std::uint32_t covers_none;  ///< lies between two rows or columns of centres
  std::uint32_t is_certain, turned_away;
  std::uint32_t has_sides;    ///< that are accurate enough
  std::uint32_t crosses[3];   ///< a row of centres: side k
  std::uint32_t on_right[3];  ///< side k
};

/// Bound, in pixels, on the displacement of a boundary by viewing (interp/visibility/z_buffer.md):
/// triangles that close to a row of centres need more, and sides and columns are less certain by
/// it.
struct RowSlack {
  double column = 0.0, row = 0.0;
};

/// Prepares the first n triangles of the block for a picture of that size, as
/// RowFills::make_triangle does one by one, in vectors of doubles: the widest of the processor.
/// `depth_error` bounds the error of certain ones.
void make_row_triangles(const TriangleBlock& block, int n, const PictureSize& size,
                        double depth_error, RowTriangles& made, const RowSlack& slack = {});

}  // namespace displayfile
