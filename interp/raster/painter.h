#pragma once

#include "interp/output_device.h"
#include "interp/raster/line_painter.h"
#include "interp/raster/raster_band.h"

namespace displayfile {

/// The heedless painter: fills and lines go over what is there, in the order they come.
class Painter : public OutputDevice {
 public:
  explicit Painter(const RasterBand& band) : band_(band), lines_(band.region) {}

  void fill(const DrawnPolygon& polygon) override;
  void edges(const DrawnPolygon& polygon) override {
    lines_.edges(polygon, [&](int x, int y, double, std::uint32_t colour) { plot(x, y, colour); });
  }
  void line(const DrawnLine& line) override {
    lines_.line(line, [&](int x, int y, double, std::uint32_t colour) { plot(x, y, colour); });
  }

 private:
  void plot(int x, int y, std::uint32_t colour) {
    band_.picture.pixels[band_.index(y, x)] = colour;
  }

  RasterBand band_;
  LinePainter lines_;
  ScanConverter converter_;
};

}  // namespace displayfile
