#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "displayfile/graphics_system.h"

namespace displayfile {

/// Where a grid's points are: displayfile/graphics_system.h without heights.
struct GridRange {
  double x_min = -1.0, x_max = 1.0;
  int x_points = 50;
  double y_min = -1.0, y_max = 1.0;
  int y_points = 50;

  std::size_t points() const {
    return static_cast<std::size_t>(x_points) * static_cast<std::size_t>(y_points);
  }
  double x(int i) const { return grid().x(i); }
  double y(int j) const { return grid().y(j); }
  SurfaceGrid grid(std::span<const double> heights = {}) const {
    return {x_min, x_max, x_points, y_min, y_max, y_points, heights};
  }
};

/// A surface to be drawn.
struct SurfaceData {
  std::string name;  ///< the expression, or the file
  GridRange range;
  std::vector<double> heights;

  SurfaceGrid grid() const { return range.grid(heights); }
};

/// Reads `A:B`, A < B. Throws Error, naming the option, for anything else.
void read_range(const char* option, const std::string& text, double& low, double& high);
/// Reads `NXxNY`, 2 or more each way. Throws Error likewise.
void read_grid_size(const std::string& text, GridRange& range);

/// True if that is a file of heights, and no expression: it ends in .npy, .txt or .csv.
bool is_grid_file(const std::string& expression_or_file);

/// The surface of an expression, or of a file with such an extension: an array of heights, whose
/// first row is at y-min and which sets the size of the grid; in text, blanks or commas between the
/// numbers of a row, `nan` for a hole, `#` before a comment. Throws Error for anything else, for
/// infinite heights, rows of different lengths, and a grid larger than memory.
SurfaceData read_surface(const std::string& expression_or_file, const GridRange& range);

}  // namespace displayfile
