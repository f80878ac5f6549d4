#pragma once

#include <cstddef>

#include "clip/base/budgeted_work.h"
#include "clip/base/work_budget.h"
#include "displayfile/segments/display_file.h"
#include "interp/device/output_device.h"
#include "interp/raster/lines_over_fills.h"
#include "interp/raster/raster_band.h"
#include "interp/raster/segment_lines.h"
#include "interp/raster/undecided_centres.h"
#include "interp/scan/pixel_set.h"

namespace displayfile {

/// Paints a display file in exact back-to-front order. Where cuts were rounded, and on polygons'
/// boundaries, the painting order does not decide the nearest: these pixel centres are recorded,
/// and decided at the end (interp/raster/undecided_centres.md).
class SortedPainter : public OutputDevice {
  auto plot() {  // first: it is used before
    return [this](int x, int y, double /*z*/, std::uint32_t colour) {
      lines_on_top_.add(y, x, x + 1);
      band_.picture.pixels[band_.index(y, x)] = colour;
    };
  }

 public:
  SortedPainter(const DisplayFile& display_file, const RasterBand& band,
                const LinesOverFills& found, double line_scale);

  Point2 pixels() const override { return band_.pixels(); }
  void begin_segment(int name) override;
  void end_segment() override { lines_.end_segment(plot()); }
  void fill(const DrawnPolygon& polygon) override;
  void edges(const DrawnPolygon& polygon) override { lines_.edges(polygon, plot()); }
  void line(const DrawnLine& line) override { lines_.line(line, plot()); }

  /// After all instructions: draws the lines of what was sorted together, and decides undecided
  /// centres, with depths if requested. Returns the number of centres so decided. Lines painted
  /// over fills are kept.
  std::size_t decide_centres();

 private:
  /// The centres covered by a segment's fills where the drawing order may not show the nearest
  /// polygon.
  enum class Undecided {
    none,           ///< not sorted exactly: the last drawn is visible
    at_boundaries,  ///< of fills
    all,            ///< it was moved after it was sorted, and all its points rounded anew
  };
  Undecided undecided_of(int segment_name) const;
  class HiddenBoundaries;
  /// True if the segment's fills are those of its map.
  bool is_map(int segment_name) const;
  void note_boundary(const DrawnPolygon& polygon);
  double sort_boundary_error(int segment_name) const;
  void show_depth_of_whole_polygons();
  template <class Show>
  void for_each_nearest(const PixelSet& centres, Show&& show) const;

  const DisplayFile& display_file_;
  RasterBand band_;
  SegmentLines lines_;
  ScanConverter converter_;
  RowsPainted painted_;
  Undecided undecided_fills_ = Undecided::none;  // of the segment
  Point2 boundary_error_{0.0};                   // of the segment's sort, in pixels
  PixelSet undecided_;                           // centres that the order does not decide
  PixelSet covered_;                             // whose depth is requested
  PixelSet lines_on_top_;  // pixels that a line was painted on after all fills
};

}  // namespace displayfile
