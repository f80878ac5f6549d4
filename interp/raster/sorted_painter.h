#pragma once

#include <cstddef>

#include "displayfile/display_file.h"
#include "interp/output_device.h"
#include "interp/raster/line_painter.h"
#include "interp/raster/raster_band.h"
#include "interp/raster/undecided_centres.h"
#include "interp/scan/pixel_set.h"

namespace displayfile {

/// Paints a display file that is in exact back-to-front order. Where cuts were rounded, and on
/// polygons' boundaries, the order of painting does not tell what is nearest: those pixel centres
/// are noted, and decided in the end (interp/raster/undecided_centres.md).
class SortedPainter : public OutputDevice {
 public:
  SortedPainter(const DisplayFile& display_file, const RasterBand& band);

  void begin_segment(int name) override;
  void fill(const DrawnPolygon& polygon) override;
  void edges(const DrawnPolygon& polygon) override {
    lines_.edges(polygon, [&](int x, int y, double, std::uint32_t colour) { plot(x, y, colour); });
  }
  void line(const DrawnLine& line) override {
    lines_.line(line, [&](int x, int y, double, std::uint32_t colour) { plot(x, y, colour); });
  }

  /// After all instructions: what is seen where painting does not tell, and the depths if they are
  /// asked for. Returns the number of centres so decided. A line painted over a fill stays.
  std::size_t decide_centres();

 private:
  /// Which of the centres that a segment's fills cover may have a nearest polygon that the order of
  /// drawing does not show.
  enum class Undecided {
    none,           ///< it was not sorted exactly: what is drawn last is meant to be seen
    at_boundaries,  ///< of fills
    all,            ///< it was moved after it was sorted, and all its points rounded anew
  };
  Undecided undecided_of(int segment_name) const;
  double sort_boundary_error(int segment_name) const;
  void show_depth_of_whole_polygons();
  template <class Show>
  void for_each_nearest(const PixelSet& centres, Show&& show) const;
  void plot(int x, int y, std::uint32_t colour);

  const DisplayFile& display_file_;
  RasterBand band_;
  LinePainter lines_;
  ScanConverter converter_;
  Undecided undecided_fills_ = Undecided::none;  // of the segment
  Point2 boundary_error_{0.0};                   // of the segment's sort, in pixels
  PixelSet undecided_;                           // centres that the order does not decide
  PixelSet covered_;                             // whose depth is asked for
  PixelSet lines_on_top_;  // pixels that a line was painted on after all fills
};

}  // namespace displayfile
