#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "displayfile/segments/display_file.h"
#include "interp/device/interpreter.h"

namespace displayfile {

/// A corner of a triangle, ready for OpenGL. x and y are normalised OpenGL coordinates, -1 to 1
/// over the picture, with y downward: the picture's top row is OpenGL's row 0. z is the
/// display file's.
struct TriangleVertex {
  float x, y;
  double z;
  std::uint32_t colour;  ///< as in Picture::pixels
  std::int32_t id;       ///< pick identifier; -1 for a line
};

/// A run of triangles. Those of an even_odd batch are the fan of one polygon, which covers what
/// an odd number of them covers.
struct TriangleBatch {
  enum class Rule { each, even_odd };
  Rule rule;
  std::size_t first, count;  ///< vertices, three a triangle
};

/// A display file as triangles, for a device that knows only these. They are that device's output
/// format, as paths are SVG's, and no representation of the scene: single precision, the order and
/// pass of one picture, and lines widened for its size are in them, and nothing but OpenGL reads
/// them. Their order is that of
/// the instructions, and a batch is cut only by a polygon that is not convex.
///
/// Each vertex of a shaded polygon has its own colour, all of any other have the same. Fills lie in
/// their support planes (hidden/exact/support_plane.h): the other vertices of a polygon are moved
/// along z on to it. A line is a parallelogram, cut upright if it is flat and level if it is steep,
/// of the shape that draw_line (interp/scan/line_draw.h) fills, so that width 1 gives one pixel a
/// column or row, and wider ones have no caps (interp/scan/wide_line_draw.h); a polygon's edge lies
/// in the polygon's plane. All is clipped to the picture in doubles, so that OpenGL need not clip.
struct TriangleList {
  std::vector<TriangleVertex> vertices;
  std::vector<TriangleBatch> batches;
  bool shaded = false;  ///< some triangle's colours differ: linear between its vertices
  /// The range of the vertices' depths; z_min > z_max if there are none.
  double z_min = std::numeric_limits<double>::infinity();
  double z_max = -std::numeric_limits<double>::infinity();
};

/// The size is in pixels; the width of lines and the length of dashes depend on it.
/// Throws Error for a coordinate that is not finite or exceeds kCoordinateLimit after the image
/// transformation.
TriangleList triangle_list(const DisplayFile& display_file, Pass pass, Order order, int width,
                           int height, double line_scale = 1.0);

}  // namespace displayfile
