#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "hidden/exact/pixel_centre.h"
#include "interp/scan/pixel_depth.h"
#include "interp/visibility/close_planes.h"

namespace displayfile {

/// The depth comparisons of a z-buffer (Catmull), for the rows that one thread draws.
///
/// Exact: where two depths are too close for rounded ones to tell, the planes are compared by
/// exact arithmetic at the pixel's centre (interp/visibility/z_buffer.md); so a float is all that a
/// pixel need store. Roundoff: doubles are compared as the textbook's SIGNOF does; closer than the
/// given ROUNDOFF counts as equal. Of equally near polygons the later one is seen in both.
class ZBuffer {
 public:
  /// The polygon that a pixel shows, as an index into those begun.
  using Owner = std::uint32_t;

  /// What is stored for a pixel; float if exact, double for roundoff.
  template <class Depth>
  struct Cell {
    Depth z = -std::numeric_limits<Depth>::infinity();
    Owner owner = 0;
    bool is_background() const { return z == -std::numeric_limits<Depth>::infinity(); }
  };

  /// No roundoff: exact.
  ZBuffer(const PictureSize& size, std::optional<double> roundoff)
      : size_(size), roundoff_(roundoff), close_(size) {}

  /// Starts the next polygon (device coordinates) and its support plane, which is not edge-on.
  void begin_polygon(std::span<const Point3> vertices, const Plane& plane);

  /// Draws covered pixels first <= i < end of a row's cells: where the polygon begun last is
  /// seen, its depth and owner are stored.
  template <class Depth>
  void draw_span(int row, int first, int end, Cell<Depth>* cells) {
    const PixelDepth depth = depth_;  // the loop's own: its stores cannot change them
    const double row_depth = depth.row(row), margin = margin_;
    run_.end = first;
    for (int i = first; i < end; ++i) {
      const double z = depth.at(row_depth, i);
      const double nearer = z - cells[i].z;
      if (nearer < -margin) continue;
      if (!(nearer > margin) && !nearer_or_equal(nearer, {row, i, end}, cells)) continue;
      cells[i] = {stored<Depth>(z), current_};
    }
  }

 private:
  struct Polygon {
    Point3 p, q, r;  ///< of the support plane
    double error;    ///< bounds that of its depths, as stored
  };
  /// Pixels of a row from `column` to the end of the span.
  struct Rest {
    int row, column, end;
  };

  template <class Depth>
  static Depth stored(double z) {
    constexpr double kLargest = std::numeric_limits<Depth>::max();  // infinity is the background
    return static_cast<Depth>(std::clamp(z, -kLargest, kLargest));
  }
  template <class Depth>
  bool nearer_or_equal(double nearer, const Rest& rest, const Cell<Depth>* cells);

  PictureSize size_;
  std::optional<double> roundoff_;
  PixelDepth depth_;
  double margin_ = 0.0;  // depths farther apart are told apart by the rounded ones
  double largest_error_ = 0.0;
  Owner current_ = 0;
  std::vector<Polygon> polygons_;

  ClosePlanes close_;
  DecidedRun run_{0, 0, false};  // of the current span
};

/// What the rounded depths do not tell.
template <class Depth>
bool ZBuffer::nearer_or_equal(double nearer, const Rest& rest, const Cell<Depth>* cells) {
  if (roundoff_) return true;  // within ROUNDOFF: equal, and later
  if (rest.column < run_.end) return run_.later_is_seen(rest.column);
  const auto& cell = cells[rest.column];
  if (cell.is_background()) return true;
  const double margin = 2.0 * (polygons_[current_].error + polygons_[cell.owner].error);
  if (nearer > margin) return true;
  if (nearer < -margin) return false;
  if (!close_.is_compared_with(cell.owner)) {
    const Polygon& other = polygons_[cell.owner];
    close_.compare_with(cell.owner, Plane(other.p, other.q, other.r));
  }
  int end = rest.column + 1;
  while (end < rest.end && cells[end].owner == cell.owner && !cells[end].is_background()) ++end;
  run_ = close_.run(rest.row, rest.column, end);
  return run_.later_is_seen(rest.column);
}

}  // namespace displayfile
