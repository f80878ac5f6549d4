#pragma once

#include "clip/base/budgeted_work.h"
#include "clip/base/work_budget.h"
#include "interp/device/output_device.h"
#include "interp/raster/lines_over_fills.h"
#include "interp/raster/raster_band.h"
#include "interp/raster/segment_lines.h"

namespace displayfile {

/// Draws in order: each fill over the earlier ones, and also lines that were not found beforehand.
class Painter : public OutputDevice {
  auto plot() {  // first: it is used before
    return [this](int x, int y, double /*z*/, std::uint32_t colour) {
      band_.picture.pixels[band_.index(y, x)] = colour;
    };
  }

 public:
  Painter(const RasterBand& band, const LinesOverFills& found, double line_scale)
      : band_(band), lines_(band.region, found, line_scale) {}

  Point2 pixels() const override { return band_.pixels(); }
  void begin_segment(int name) override { lines_.begin_segment(name); }
  void end_segment() override { lines_.end_segment(plot()); }
  void fill(const DrawnPolygon& polygon) override;
  void edges(const DrawnPolygon& polygon) override { lines_.edges(polygon, plot()); }
  void line(const DrawnLine& line) override { lines_.line(line, plot()); }
  /// Must be called after all instructions.
  void end() { lines_.end(plot()); }

 private:
  RasterBand band_;
  SegmentLines lines_;
  ScanConverter converter_;
  RowsPainted painted_;
};

}  // namespace displayfile
