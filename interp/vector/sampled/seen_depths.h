#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "hidden/exact/pixel_centre.h"
#include "interp/scan/pixel_depth.h"
#include "interp/visibility/close_planes.h"

namespace displayfile {

/// The depth comparisons of a z-buffer over polygons that belong to no scene, for the rows of one
/// band: exact, where rounded depths do not tell by exact arithmetic at the pixel's centre
/// (interp/visibility/close_depths.md). Of equally near polygons the later one is seen.
class SeenDepths {
 public:
  /// The polygon that a pixel shows, as an index into those begun.
  using Owner = std::uint32_t;

  /// What is stored for a pixel.
  struct Cell {
    double z = -std::numeric_limits<double>::infinity();
    Owner owner = 0;
    bool is_background() const { return z == -std::numeric_limits<double>::infinity(); }
  };

  explicit SeenDepths(const PictureSize& size) : size_(size), close_(size) {}

  /// Starts the next polygon (device coordinates) and its support plane, which is not edge-on.
  void begin_polygon(std::span<const Point3> vertices, const Plane& plane);

  /// Draws covered pixels first <= i < end of a row's cells: where the polygon begun last is
  /// seen, its depth and owner are stored.
  void draw_span(int row, int first, int end, Cell* cells);

 private:
  struct Polygon {
    Plane plane;
    double error;  ///< bounds that of its depths
  };
  /// Pixels of a row from `column` to the end of the span.
  struct Rest {
    int row, column, end;
  };
  bool nearer_or_equal(double nearer, const Rest& rest, const Cell* cells);

  PictureSize size_;
  PixelDepth depth_;
  double margin_ = 0.0;  // depths farther apart are told apart by the rounded ones
  double largest_error_ = 0.0;
  Owner current_ = 0;
  std::vector<Polygon> polygons_;
  ClosePlanes close_;
  DecidedRun run_{0, 0, false};  // of the current span
};

}  // namespace displayfile
