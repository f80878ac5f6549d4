#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "hidden/pixel_centre.h"
#include "interp/pixel_depth.h"

namespace displayfile {

/// The depth comparisons of a z-buffer (Catmull), for the rows that one thread draws.
///
/// Exact: where two depths are too close for rounded ones to tell, the planes are compared by
/// exact arithmetic at the pixel's centre (interp/z_buffer.md). Roundoff: doubles are compared
/// as the textbook's SIGNOF does; closer than the given ROUNDOFF counts as equal. Of equally
/// near polygons the later one is seen in both.
class ZBuffer {
 public:
  /// The polygon that a pixel shows, as an index into those begun.
  using Owner = std::uint32_t;

  /// No roundoff: exact.
  ZBuffer(const PictureSize& size, std::optional<double> roundoff)
      : size_(size), roundoff_(roundoff) {}

  /// Starts the next polygon (device coordinates), which is not edge-on.
  void begin_polygon(std::span<const Point3> vertices, const SupportVertices& support);

  /// Draws covered pixels first <= i < end of a row: where the polygon begun last is seen, its
  /// depth and owner are stored and write(i) is called. The arrays are the picture's row;
  /// depth starts as minus infinity, owner as anything, and is not touched in roundoff.
  template <class Write>
  void draw_span(int row, int first, int end, double* depth, Owner* owner, Write&& write) {
    const double row_depth = depth_.row(row);
    for (int i = first; i < end; ++i) {
      const double z = depth_.at(row_depth, i);
      const double nearer = z - depth[i];
      if (nearer < -margin_) continue;
      if (!(nearer > margin_) && !nearer_or_equal(nearer, depth[i], owner, i, row)) continue;
      depth[i] = z;
      if (!roundoff_) owner[i] = current_;
      write(i);
    }
  }

 private:
  struct Polygon {
    Point3 p, q, r;  ///< of the support plane
    double error;    ///< bounds that of its depths
  };

  bool nearer_or_equal(double nearer, double old_depth, const Owner* owner, int column, int row);

  PictureSize size_;
  std::optional<double> roundoff_;
  PixelDepth depth_;
  double margin_ = 0.0;  // depths farther apart are told apart by the rounded ones
  double largest_error_ = 0.0;
  Owner current_ = 0;
  std::vector<Polygon> polygons_;

  // The polygon that was last compared with the current one, and whether they are coplanar.
  Owner compared_ = 0;
  bool coplanar_ = false;
};

}  // namespace displayfile
