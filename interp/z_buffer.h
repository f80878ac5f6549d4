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
    run_.end = first;
    for (int i = first; i < end; ++i) {
      const double z = depth_.at(row_depth, i);
      const double nearer = z - depth[i];
      if (nearer < -margin_) continue;
      if (!(nearer > margin_) && !nearer_or_equal(nearer, {row, i, end}, depth, owner)) {
        continue;
      }
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

  /// Pixels of a row from `column` to the end of the span.
  struct Rest {
    int row, column, end;
  };
  bool nearer_or_equal(double nearer, const Rest& rest, const double* depth, const Owner* owner);
  void compare_planes(Owner other);
  bool decide_run(const Rest& rest, const double* depth, const Owner* owner);

  PictureSize size_;
  std::optional<double> roundoff_;
  PixelDepth depth_;
  double margin_ = 0.0;  // depths farther apart are told apart by the rounded ones
  double largest_error_ = 0.0;
  Owner current_ = 0;
  std::vector<Polygon> polygons_;

  // The polygon that was last compared with the current one.
  Owner compared_ = 0;
  bool coplanar_ = false;
  Plane plane_, compared_plane_;

  /// Pixels of the current span for which the same was decided together.
  struct Run {
    int end;
    bool nearer_or_equal;
  };
  Run run_{0, false};
};

}  // namespace displayfile
