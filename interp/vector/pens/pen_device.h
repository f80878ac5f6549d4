#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "displayfile/segments/viewed_scene.h"
#include "interp/device/output_device.h"
#include "interp/device/picture.h"
#include "interp/vector/pens/hatched_fills.h"
#include "interp/vector/pens/hatching.h"
#include "interp/vector/pens/stroke.h"

namespace displayfile {

/// The strokes of one pen.
struct PenStrokes {
  Pen pen;
  std::vector<Stroke> strokes;
};

/// Converts the interpreter's output to strokes on a sheet: lines and edges in order, many of them
/// twice, by pens in the order of first use; and fills as hatching, if requested, by a pen that
/// comes last. Clipped to the picture.
class PenDevice : public OutputDevice {
 public:
  /// `picture`: its size in pixels, and its place on the sheet. `background` is the paper's colour.
  struct Picture {
    int width, height;
    PaperFit fit;
  };
  PenDevice(const Picture& picture, const Pens& pens, const Colour& background);

  Point2 pixels() const override {
    return crumbs_ ? Point2(0.0) : Point2(picture_.width, picture_.height);
  }

  void begin_disjoint_fills() override { fills_are_disjoint_ = true; }
  void end_disjoint_fills() override { fills_are_disjoint_ = false; }
  void fill(const DrawnPolygon& polygon) override;
  void edges(const DrawnPolygon& polygon) override;
  void line(const DrawnLine& line) override;
  /// Converts the visible texts of the visible segments, if their letters are paths.
  void draw_texts(const DisplayFile& display_file);
  /// Converts a text of annotation: in the usual Hershey font if the lettering fills areas. Throws
  /// Error if that is not installed.
  void draw_annotation_text(const DeviceText& text);
  /// Hides earlier drawing within a convex polygon, in device coordinates.
  void blank(std::span<const Point3> polygon);

  /// All strokes, with dashed lines cut into dashes. Must be called once.
  std::vector<PenStrokes> strokes();

 private:
  struct Collected {
    Pen pen;
    double dash, gap;     // thousandths of a millimetre; 0 and 0: solid
    std::size_t blanked;  // the number of blanks that were drawn before it, and do not hide it
    std::vector<Stroke> strokes;
  };
  void draw_text(const DeviceText& text, const Lettering& lettering);
  std::vector<Stroke> not_blanked(std::vector<Stroke> strokes, std::size_t first_blank) const;
  /// The slope of a polygon's plane, as in HatchedFill.
  Point2 slope_on_sheet(std::span<const Point3> vertices) const;
  Point2 on_sheet(const Point3& device) const;
  std::vector<Stroke>& strokes_of(const LineStyle& style);
  void add(const Point2& a, const Point2& b, std::vector<Stroke>& strokes) const;

  Picture picture_;
  bool crumbs_;
  Lettering lettering_;
  Rectangle frame_;
  Pen hatching_pen_{};
  Darkness darkness_;
  std::optional<HatchedFills> hatched_;
  bool fills_are_disjoint_ = false;
  std::vector<Collected> collected_;
  /// Indices by pen, dash, gap and number of blanks.
  std::map<std::tuple<Pen, double, double, std::size_t>, std::size_t> places_;
  std::size_t last_ = 0;                     // requested last
  std::vector<std::vector<Point2>> blanks_;  // convex, in the unit of strokes
  std::vector<Point2> points_;
  std::vector<double> dark_;
};

}  // namespace displayfile
