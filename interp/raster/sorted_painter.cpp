#include "interp/raster/sorted_painter.h"

#include <algorithm>
#include <memory>

#include "displayfile/segments/sorted_scene.h"
#include "displayfile/segments/viewed_scene.h"
#include "hidden/exact/support_plane.h"
#include "interp/device/interpreter.h"
#include "interp/scan/shown_depth.h"

namespace displayfile {

namespace {

/// The fills as entered, for deciding some pixel centres. Segments sorted together are one layer.
class EnteredFills : public OutputDevice {
 public:
  /// `scene` has the display file's polygons.
  EnteredFills(const DisplayFile& display_file, const ViewedScene& scene, NearestAtCentres& nearest)
      : display_file_(display_file), scene_(scene), nearest_(nearest) {
    nearest_.begin_layer(NearestAtCentres::Layer::nearest);
  }
  void begin_segment(int name) override {
    if (display_file_.sorted()) return;
    nearest_.begin_layer(display_file_.segment(name).sorted() ? NearestAtCentres::Layer::nearest
                                                              : NearestAtCentres::Layer::painted);
  }
  void fill(const DrawnPolygon& polygon) override {
    if (support_vertices(polygon.vertices).edge_on) return;  // not a fill of the scene
    ++fill_;
    nearest_.enter(polygon, fill_, scene_.plane_in_common(fill_));
  }
  void edges(const DrawnPolygon&) override {}
  void line(const DrawnLine&) override {}

 private:
  const DisplayFile& display_file_;
  const ViewedScene& scene_;
  ViewedScene::Fill fill_ = ViewedScene::kBackground;
  NearestAtCentres& nearest_;
};

/// Adds the centres that a segment's solid polygons cover.
struct Coverage {
  PixelSet& centres;
  ScanConverter& converter;
  const ScanConverter::Region& region;
  bool solid = true;

  void fill(const FillStyle& style) { solid = style.kind == FillStyle::Kind::solid; }
  void line_style(const LineStyle&) {}
  void pick(int) {}
  void move(const Point3&) {}
  void line(const Point3&) {}
  void polygon(std::span<const Point3> vertices, std::span<const std::int32_t>) {
    if (!solid) return;
    converter.scan_convert(vertices, region,
                           [&](int row, int first, int end) { centres.add(row, first, end); });
  }
};

}  // namespace

/// Records the centres close to boundaries of polygons that a map omitted. Where one touches the
/// polygon that hides it, without being visible on any side of that, it may be visible at a centre
/// by its later entry.
class SortedPainter::HiddenBoundaries : public OutputDevice {
 public:
  explicit HiddenBoundaries(SortedPainter& painter) : painter_(painter) {}
  void begin_segment(int name) override {
    is_of_map_ = painter_.is_map(name) && painter_.undecided_of(name) == Undecided::at_boundaries;
    painter_.boundary_error_ = Point2(painter_.band_.size().width, painter_.band_.size().height) *
                               painter_.sort_boundary_error(name);
  }
  void fill(const DrawnPolygon& polygon) override {
    if (is_of_map_) painter_.note_boundary(polygon);
  }
  void edges(const DrawnPolygon&) override {}
  void line(const DrawnLine&) override {}

 private:
  SortedPainter& painter_;
  bool is_of_map_ = false;
};

SortedPainter::SortedPainter(const DisplayFile& display_file, const RasterBand& band,
                             const LinesOverFills& found, double line_scale)
    : display_file_(display_file),
      band_(band),
      lines_(band.region, found, line_scale),
      undecided_(band.size().width, band.region.row_begin, band.region.row_end),
      covered_(undecided_),
      lines_on_top_(undecided_) {}

SortedPainter::Undecided SortedPainter::undecided_of(int segment_name) const {
  if (const auto& together = display_file_.sorted()) {
    return together->plan.precision.exact ? Undecided::at_boundaries : Undecided::none;
  }
  const Segment& segment = display_file_.segment(segment_name);
  if (!segment.sorted() || !segment.sorted()->plan.precision.exact) return Undecided::none;
  return segment.sorted_as_drawn() ? Undecided::at_boundaries : Undecided::all;
}

bool SortedPainter::is_map(int segment_name) const {
  const auto& sorted = display_file_.sorted() ? display_file_.sorted()
                                              : display_file_.segment(segment_name).sorted();
  return sorted != nullptr && sorted->plan.method == HiddenMethod::map;
}

void SortedPainter::note_boundary(const DrawnPolygon& polygon) {
  const Point2 error = boundary_error(polygon.vertices, band_.size()) + boundary_error_;
  note_rows_of_vertices(polygon.vertices, error, band_.size(), undecided_);
  const ScanConverter::Rows rows = converter_.begin(polygon.vertices, band_.region);
  if (rows.first == rows.end) return;
  converter_.watch(error);
  converter_.scan([](int, int, int) {},
                  [&](int row, int first, int end) { undecided_.add(row, first, end); });
}

/// The additional error of the segment's boundaries (SortedScene::boundary_error).
double SortedPainter::sort_boundary_error(int segment_name) const {
  if (display_file_.sorted()) return display_file_.sorted()->boundary_error;
  const Segment& segment = display_file_.segment(segment_name);
  return segment.sorted() ? segment.sorted()->boundary_error : 0.0;
}

void SortedPainter::begin_segment(int name) {
  lines_.begin_segment(name);
  undecided_fills_ = undecided_of(name);
  boundary_error_ = Point2(band_.size().width, band_.size().height) * sort_boundary_error(name);
  if (undecided_fills_ == Undecided::all) {
    // Its pieces may leave gaps as wide as the coordinates before the move were rounded.
    display_file_.segment(name).walk_entered_drawn(Coverage{undecided_, converter_, band_.region});
  }
}

/// Called back to front. Close to its boundary, and so where it is too narrow to have a plane or to
/// cover a centre, any paint will do: the centres are decided later.
void SortedPainter::fill(const DrawnPolygon& polygon) {
  const bool at_boundaries = undecided_fills_ == Undecided::at_boundaries;
  Point2 error(0.0);
  if (at_boundaries) {
    error = boundary_error(polygon.vertices, band_.size()) + boundary_error_;
    note_rows_of_vertices(polygon.vertices, error, band_.size(), undecided_);
  }
  const ScanConverter::Rows rows = converter_.begin(polygon.vertices, band_.region);
  if (rows.first == rows.end) return;
  painted_.add(static_cast<std::size_t>(rows.end - rows.first));
  if (at_boundaries) {
    converter_.watch(error);
  } else if (support_vertices(polygon.vertices).edge_on) {
    return;
  }
  const FillColour colour(polygon, band_.size(), band_.shadows);
  converter_.scan(
      [&](int row, int first, int end) {
        band_.paint(row, first, end, colour, polygon.pick);
        lines_on_top_.remove(row, first, end);
        if (undecided_fills_ == Undecided::all) undecided_.add(row, first, end);
        if (!band_.picture.depth.empty()) covered_.add(row, first, end);
      },
      [&](int row, int first, int end) {
        if (at_boundaries) undecided_.add(row, first, end);
      });
}

std::size_t SortedPainter::decide_centres() {
  lines_.end(plot());
  Picture& picture = band_.picture;
  const auto segments = display_file_.visible_segments();
  const bool has_map = std::ranges::any_of(
      segments, [&](const Segment* segment) { return is_map(segment->name()); });
  if (has_map) {
    HiddenBoundaries boundaries(*this);
    interpret(display_file_, boundaries, Pass::fills, Order::entered);
  }
  if (!undecided_.empty()) {
    for_each_nearest(undecided_, [&](int row, int column, const NearestAtCentres::Seen* seen) {
      const std::size_t at = band_.index(row, column);
      if (!picture.ids.empty()) picture.ids[at] = seen ? seen->pick : -1;
      if (lines_on_top_.contains(row, column)) return;
      const bool shows = seen != nullptr && band_.shows_fills;
      picture.pixels[at] = shows ? seen->colour.at(row, column) : band_.background;
    });
  }
  if (!picture.depth.empty()) show_depth_of_whole_polygons();
  return undecided_.size();
}

/// A cut polygon's own plane is unreliable where rounding has moved its vertices: the depth shown
/// is that of the polygon as entered.
void SortedPainter::show_depth_of_whole_polygons() {
  undecided_.for_each([&](int row, int column) { covered_.add(row, column, column + 1); });
  for_each_nearest(covered_, [&](int row, int column, const NearestAtCentres::Seen* seen) {
    if (!seen) return;
    band_.picture.depth[band_.index(row, column)] =
        ShownDepth(seen->plane, band_.size()).at(column, row);
  });
}

namespace {

/// The scene used by the sort, with the planes found for it, or else an equal one.
std::shared_ptr<const ViewedScene> scene_of(const DisplayFile& display_file) {
  const auto& sorted = display_file.sorted();
  if (sorted && sorted->parts.size() == 1 && sorted->parts.front()->scene->is_of(display_file)) {
    return sorted->parts.front()->scene;
  }
  return std::make_shared<const ViewedScene>(display_file);
}

}  // namespace

template <class Show>
void SortedPainter::for_each_nearest(const PixelSet& centres, Show&& show) const {
  const std::shared_ptr<const ViewedScene> scene = scene_of(display_file_);
  FillsAsEntered fills(*scene, band_.size());
  NearestAtCentres nearest(centres, band_.size(), fills, band_.shadows);
  EnteredFills entered(display_file_, *scene, nearest);
  interpret(display_file_, entered, Pass::fills, Order::entered);
  nearest.show(show);
}

}  // namespace displayfile
