#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace displayfile::bench {

/// How a curve's or a method's points are drawn.
struct Mark {
  std::string colour;
  int shape = 0;  ///< circle, square, diamond, triangle up, triangle down, cross, plus, bar
  bool filled = true;
};
/// At a place in an SVG.
std::string marker(const Mark& mark, double x, double y);
/// An SVG of its own, to stand in a line of text.
std::string marker_in_text(const Mark& mark);

struct PlotPoint {
  double x, y;
  std::optional<std::pair<double, double>> x_spread = std::nullopt;  ///< least and greatest
  std::string title = {};  ///< shown where the pointer rests
  std::string label = {};  ///< written beside it
};

struct Curve {
  Mark mark;
  bool joined = true;  ///< by a line
  std::vector<PlotPoint> points;
};

/// Both axes are logarithmic. A y that is not positive stands on a line of its own below, if the
/// axis has one.
struct Plot {
  std::string title, x_label, y_label;
  bool zero_line = false;
  /// A staircase under the points, drawn behind them: none of them is below and left of it.
  std::vector<PlotPoint> front = {};
  std::optional<std::pair<double, double>> x_range = std::nullopt, y_range = std::nullopt;
  double width = 470.0, height = 330.0;  ///< pixels
  double zero_band = 46.0;               ///< its height
  /// Written into the upper right corner, a line each, with a mark if it has one.
  std::vector<std::pair<std::optional<Mark>, std::string>> notes = {};
};
/// Points that are labelled stand one below the other in the band of zeros, so that their labels do
/// not meet; others beside each other by their shapes.
std::string svg(const Plot& plot, std::span<const Curve> curves);
/// The same as a file of its own.
std::string svg_file(const Plot& plot, std::span<const Curve> curves);

/// Percentages in rows and columns: zero light green, and from light to dark red by logarithm.
struct HeatMap {
  std::vector<std::string> rows, columns;
  std::vector<double> percent;      ///< row after row; negative: nothing measured
  std::vector<std::string> titles;  ///< of each cell
};
std::string svg(const HeatMap& map);

/// Text that is safe in HTML and SVG.
std::string escaped(const std::string& text);

}  // namespace displayfile::bench
