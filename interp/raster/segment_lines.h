#pragma once

#include "clip/base/budgeted_work.h"
#include "clip/base/work_budget.h"
#include "interp/device/output_device.h"
#include "interp/raster/line_painter.h"
#include "interp/raster/lines_over_fills.h"

namespace displayfile {

/// The lines of a display file painted in order: lines found beforehand are drawn where they are
/// visible, over everything with which they were found; others in order. The painters forward their
/// calls to it, with the plot of LinePainter.
class SegmentLines {
 public:
  SegmentLines(const ScanConverter::Region& region, const LinesOverFills& found, double line_scale)
      : painter_(region, line_scale), found_(found) {}

  void begin_segment(int name) {
    group_ = found_.all() != nullptr ? found_.all() : found_.of_segment(name);
  }
  template <class Plot>
  void edges(const DrawnPolygon& polygon, Plot&& plot) {
    if (group_ != nullptr) return;
    painted_.add(polygon.vertices.size());
    painter_.edges(polygon, plot);
  }
  template <class Plot>
  void line(const DrawnLine& line, Plot&& plot) {
    if (group_ != nullptr) return;
    painted_.add(1);
    painter_.line(line, plot);
  }
  template <class Plot>
  void end_segment(Plot&& plot) {
    if (group_ != nullptr && group_ != found_.all()) draw(*group_, plot);
    group_ = nullptr;
  }
  /// Must be called after all segments.
  template <class Plot>
  void end(Plot&& plot) {
    if (found_.all() != nullptr) draw(*found_.all(), plot);
  }

 private:
  template <class Plot>
  void draw(const LinesOverFills::Group& group, Plot&& plot) {
    group.draw(painter_, plot);
  }

  LinePainter painter_;
  RowsPainted painted_;  // a line counts as a row
  const LinesOverFills& found_;
  const LinesOverFills::Group* group_ = nullptr;  // of the segment that has begun
};

}  // namespace displayfile
