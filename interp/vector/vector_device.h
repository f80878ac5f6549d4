#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "displayfile/looks/style.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/viewed_scene.h"
#include "interp/annotation/annotation_marks.h"
#include "interp/device/output_device.h"
#include "interp/text/letter_paths.h"
#include "interp/vector/disjoint_fills.h"
#include "interp/vector/polygon_paints.h"

namespace displayfile {

/// The width, in pixels, of the line in its own colour that a fill gets where no edge is drawn.
///
/// Without it, the background shows through between faces that share an edge: an antialiasing
/// renderer composites two partly covered pixels, and (1 - t)(1 - (1 - t)) of the background is
/// left where one face covers t of a pixel, a quarter at worst. A line of width w along the edge
/// covers s of the pixel too, and t(1 - t)(1 - s)^2 is left: 1/16 at worst for w = 0.5, 1/35 for
/// 0.75, 1/64 for 1. But every outline grows by w / 2. At 0.75 the seams are no longer visible and
/// outlines grow by little more than a third of a pixel. Like the widths of lines it is in pixels
/// of the picture's size: both are enlarged if a small picture is shown enlarged, so it should be
/// drawn in the size in which it is shown.
inline constexpr double kSeamWidth = 0.75;

/// The caps of drawn lines.
enum class LineCap {
  butt,    ///< at its last point
  round,   ///< with half a disc as wide as the line
  square,  ///< half a width beyond its last point: of a dot, which is a square
};

/// Shared parts of the devices that draw lines and areas: pixel coordinates with y down, from the
/// picture's top left corner; nothing far outside of the picture; successive lines of the same
/// kinds joined into one path; seams closed. A shaded polygon is filled with a linear gradient.
/// Solid lines have round caps, except where they are cut.
class VectorDevice : public OutputDevice {
 public:
  /// Throws Error unless both sides are 1 to kLargestSide, or if an option is out of its range.
  VectorDevice(int width, int height, const Background& background = {},
               const VectorOptions& options = {});

  /// Fills all further polygons in the background's colour, for the colour rule.
  void fill_with_background() { fills_with_background_ = true; }

  Point2 pixels() const final { return options_.crumbs ? Point2(0.0) : Point2(width_, height_); }
  void begin_segment(int name) final;
  void end_segment() final;
  void fill(const DrawnPolygon& polygon) final;
  void edges(const DrawnPolygon& polygon) final;
  void line(const DrawnLine& line) final;
  void begin_disjoint_fills() final;
  void end_disjoint_fills() final;
  /// Stores the segments' titles, for naming groups and layers.
  void take_titles(const DisplayFile& display_file);
  /// Draws the visible texts of the visible segments, after all else (interp/text/seen_texts.h).
  void draw_texts(const DisplayFile& display_file);
  /// Draws the annotation of the visible segments (interp/annotation/README.md), after all else.
  /// `millimetre` is in pixels, for a picture without paper.
  void draw_annotation(const DisplayFile& display_file, double millimetre);

 protected:
  /// Points of lines; each run starts at its own first point and is closed or open.
  struct Path {
    struct Run {
      std::size_t first;
      bool closed;
      LineCuts cuts = {};
    };
    std::vector<Point2> points;
    std::vector<Run> runs;

    bool empty() const { return runs.empty(); }
    void clear();
    void start(bool closed) { runs.push_back({points.size(), closed}); }
    void add(const Path& other, std::size_t i);  ///< one of its runs
    std::span<const Point2> run(std::size_t i) const;
  };

  int width() const { return width_; }
  int height() const { return height_; }
  const Background& background() const { return background_; }
  const VectorOptions& options() const { return options_; }
  /// Empty if the segment has no title.
  std::string_view title_of(int segment) const;
  /// The name of a segment's layer: its title, or its number. Empty if there are no layers.
  std::string_view layer_of(int segment) const;
  /// Must be called by the derived class after all drawing.
  void finish_lines();

  virtual void open_group(int segment_name) = 0;
  virtual void close_group() = 0;
  /// Paints by the even-odd rule; with the line that closes the seams if `seam`.
  virtual void paint_fill(const Path& path, const FillPaint& paint, bool seam) = 0;
  /// Paints disjoint fills, with the seams set in options(); in the open group, or else in one for
  /// each segment.
  virtual void paint_figure(const Figure& figure) = 0;
  /// Paints lines that are all of the same kinds (clip/surfaces.h). A run of two equal points with
  /// round caps is a disc.
  virtual void paint_lines(const Path& path, const LineStyle& style, LineKinds kinds,
                           LineCap cap) = 0;
  /// `anchor` is on or close to the page; `size` of the letters in pixels.
  virtual void paint_text(const DeviceText& text, const Point2& anchor, double size) = 0;

 private:
  Point2 to_page(const Point3& device) const;
  bool near_the_page(const Point2& p, double reach) const;
  FillPaint paint_of(const DrawnPolygon& polygon);
  void paint_mark(const AnnotationMark& mark);
  void paint_letters(const DeviceText& text, const Point2& anchor);
  void paint_edges(const DrawnPolygon& polygon, LineKinds kinds);
  void paint_with_caps(const Path& path, const LineStyle& style, LineKinds kinds);
  void add_disc(std::span<const Point2> run, const LineCuts& cuts, LineKinds kinds);
  bool goes_straight_on(const Point2& to);
  void end_line(const DrawnLine& line);
  void finish_path();
  void finish_discs();
  bool clip_to_neighbourhood(Point2& a, Point2& b, double reach) const;
  bool find_loop(std::span<const Point3> vertices);

  int width_, height_;
  std::unordered_map<int, std::string> titles_, layers_;  // of segments
  Background background_;
  VectorOptions options_;
  bool fills_with_background_ = false;
  bool fills_are_disjoint_ = false;
  PolygonPaints paints_;
  DisjointFills disjoint_;
  int segment_of_disjoint_ = 0;
  Path path_;
  Path lines_;         // that continue each other, not painted yet
  double bend_ = 0.0;  // of the points left out since the last one of the path
  Point3 lines_end_{0.0};
  LineStyle lines_style_;
  LineKinds lines_kinds_ = kDrawn;
  Path uncut_, cut_;  // of what is painted now, by their caps
  /// Round caps of lines whose other end is cut, by kinds, still to be painted; all of one style.
  std::map<LineKinds, Path> discs_;
  LineStyle discs_style_;
  std::vector<Point2> clipped_, page_;
};

}  // namespace displayfile
