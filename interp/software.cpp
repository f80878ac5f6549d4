#include "interp/software.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <limits>
#include <optional>

#include "hidden/support_plane.h"
#include "interp/interpreter.h"
#include "interp/line_draw.h"
#include "interp/pixel_set.h"
#include "interp/scan_convert.h"
#include "interp/undecided_centres.h"
#include "interp/z_buffer.h"

namespace displayfile {

namespace {

constexpr std::uint32_t kBackground = 0xFFFFFFFF;
constexpr int kRowsFetched = 32;
constexpr double kFarthest = -std::numeric_limits<double>::infinity();

/// The rows of a picture that one thread draws.
struct Band {
  int row_begin, row_end;
};

/// The fills as entered, to judge some pixel centres by. Segments that were sorted together are
/// one layer.
class EnteredFills : public OutputDevice {
 public:
  EnteredFills(const DisplayFile& display_file, NearestAtCentres& nearest)
      : display_file_(display_file), nearest_(nearest) {
    nearest_.begin_layer(NearestAtCentres::Layer::nearest);
  }
  void begin_segment(int name) override {
    if (display_file_.sorted()) return;
    nearest_.begin_layer(display_file_.segment(name).sorted() ? NearestAtCentres::Layer::nearest
                                                              : NearestAtCentres::Layer::painted);
  }
  void fill(const DrawnPolygon& polygon) override {
    nearest_.enter(polygon.vertices, pixel_of(polygon.fill.colour), polygon.pick);
  }
  void edges(const DrawnPolygon&) override {}
  void line(const DrawnLine&) override {}

 private:
  const DisplayFile& display_file_;
  NearestAtCentres& nearest_;
};

/// Of the fills of a segment, the centres whose nearest polygon the order of drawing may not show.
enum class Undecided {
  none,           ///< it was not sorted exactly: what is drawn last is meant to be seen
  at_boundaries,  ///< of fills
  all,            ///< it was moved after it was sorted, and all its points rounded anew
};

Undecided undecided_of(const DisplayFile& display_file, int segment_name) {
  if (const auto& together = display_file.sorted()) {
    return together->precision.exact ? Undecided::at_boundaries : Undecided::none;
  }
  const Segment& segment = display_file.segment(segment_name);
  if (!segment.sorted() || !segment.sorted()->precision.exact) return Undecided::none;
  return segment.sorted_as_drawn() ? Undecided::at_boundaries : Undecided::all;
}

/// How far the segment's boundaries may be off besides (SortedInstructions::boundary_error).
double sort_boundary_error(const DisplayFile& display_file, int segment_name) {
  if (display_file.sorted()) return display_file.sorted()->boundary_error;
  const Segment& segment = display_file.segment(segment_name);
  return segment.sorted() ? segment.sorted()->boundary_error : 0.0;
}

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

/// Fills and lines into a band of the picture's rows.
class SoftwareDevice : public OutputDevice {
 public:
  SoftwareDevice(const DisplayFile& display_file, Picture& picture, SoftwareCells& cells,
                 const RasterRequest& request, const Band& band)
      : display_file_(display_file),
        picture_(picture),
        cells_(cells),
        width_(picture.width),
        height_(picture.height),
        z_buffer_on_(request.z_buffer),
        ids_(request.ids),
        region_{{picture.width, picture.height}, band.row_begin, band.row_end},
        z_buffer_(region_.size, request.roundoff),
        sorted_(request.sorted && !request.z_buffer),
        undecided_(width_, band.row_begin, band.row_end),
        covered_(undecided_),
        lines_on_top_(undecided_) {}

  void begin_segment(int name) override {
    if (!sorted_) return;
    undecided_fills_ = undecided_of(display_file_, name);
    boundary_error_ = Point2(width_, height_) * sort_boundary_error(display_file_, name);
    if (undecided_fills_ == Undecided::all) {
      // Its pieces may leave gaps as wide as the coordinates before the move were rounded.
      display_file_.segment(name).walk_entered_drawn(Coverage{undecided_, converter_, region_});
    }
  }

  void fill(const DrawnPolygon& polygon) override {
    if (sorted_) return fill_sorted(polygon);
    const ScanConverter::Rows rows = converter_.begin(polygon.vertices, region_);
    if (rows.first == rows.end) return;
    const SupportVertices support = support_vertices(polygon.vertices);
    if (support.edge_on) return;
    const std::uint32_t colour = pixel_of(polygon.fill.colour);
    if (z_buffer_on_) {
      fill_nearest(polygon, support, rows, colour);
    } else {
      fill_over(polygon, support, colour);
    }
  }

  void edges(const DrawnPolygon& polygon) override {
    const SupportVertices support = support_vertices(polygon.vertices);
    std::optional<PixelDepth> depth;
    if (z_buffer_on_ && !support.edge_on) depth.emplace(polygon.vertices, support, width_, height_);
    const DepthRange range = depth_range(polygon.vertices);
    const std::uint32_t colour = pixel_of(polygon.line.colour);
    DashPhase phase;
    Point3 from = pixel(polygon.vertices.back());
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
      const Point3 to = pixel(polygon.vertices[i]);
      if (polygon.sides[i] == op::line) {
        draw_line(from, to, polygon.line, width_, height_, phase, [&](int x, int y, double z) {
          if (depth) {
            // The polygon's plane, but half a pixel beyond a polygon seen nearly edge-on
            // that plane is anywhere: no nearer or farther than the polygon itself.
            const double at_centre = depth->at(depth->row(y), x);
            z = std::clamp(at_centre, range.farthest, range.nearest);
          }
          plot(x, y, z, colour);
        });
      } else {
        phase = {};
      }
      from = to;
    }
  }

  void line(const DrawnLine& line) override {
    if (pixel(line.from) != dash_end_) dash_phase_ = {};
    const std::uint32_t colour = pixel_of(line.style.colour);
    draw_line(pixel(line.from), pixel(line.to), line.style, width_, height_, dash_phase_,
              [&](int x, int y, double z) { plot(x, y, z, colour); });
    dash_end_ = pixel(line.to);
  }

  /// After all instructions of a sorted display file: what is seen where painting does not tell.
  /// Returns the number of centres so decided. A line painted over a fill stays.
  std::size_t decide_centres() {
    if (!undecided_.empty()) {
      for_each_nearest(undecided_, [&](int row, int column, const NearestAtCentres::Seen* seen) {
        const std::size_t at = index(column, row);
        if (ids_) picture_.ids[at] = seen ? seen->pick : -1;
        if (lines_on_top_.contains(row, column)) return;
        picture_.pixels[at] = seen ? seen->colour : kBackground;
      });
    }
    if (!picture_.depth.empty()) show_depth_of_whole_polygons();
    return undecided_.size();
  }

  /// After all fills: colours, identifiers and depths of the polygons that the pixels show.
  void show_nearest() {
    if (cells_.roundoff.empty()) {
      show(cells_.exact);
    } else {
      show(cells_.roundoff);
    }
  }

 private:
  /// The cells are cleared for the next picture while they are at hand.
  template <class Depth>
  void show(std::vector<ZBuffer::Cell<Depth>>& cells) {
    for (int row = region_.row_begin; row < region_.row_end; ++row) {
      const std::size_t start = index(0, row), end = start + static_cast<std::size_t>(width_);
      if (ids_) {
        for (std::size_t i = start; i < end; ++i) {
          picture_.ids[i] = cells[i].is_background() ? -1 : picks_[cells[i].owner];
        }
      }
      if (!picture_.depth.empty()) show_depth(row, cells);
      for (std::size_t i = start; i < end; ++i) {
        if (cells[i].is_background()) {
          picture_.pixels[i] = kBackground;
        } else {
          picture_.pixels[i] = colours_[cells[i].owner];
          cells[i] = {};
        }
      }
    }
  }

  template <class Depth>
  void show_depth(int row, const std::vector<ZBuffer::Cell<Depth>>& cells) {
    PixelDepth depth;
    std::optional<ZBuffer::Owner> owner;
    for (int column = 0; column < width_; ++column) {
      const auto& cell = cells[index(column, row)];
      double& z = picture_.depth[index(column, row)];
      if (cell.is_background()) {
        z = kFarthest;
        continue;
      }
      if (owner != cell.owner) {
        owner = cell.owner;
        depth = z_buffer_.depth_of(*owner);
      }
      z = depth.at(depth.row(row), column);
    }
  }

  Point3 pixel(const Point3& device) const {
    return {device.x * width_, device.y * height_, device.z};
  }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(height_ - 1 - y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  struct DepthRange {
    double nearest, farthest;
  };
  /// Of the vertices, and a little more: rounding may put the polygon's own fill there.
  static DepthRange depth_range(std::span<const Point3> vertices) {
    double nearest = vertices[0].z, farthest = nearest;
    for (const Point3& v : vertices) {
      nearest = std::max(nearest, v.z);
      farthest = std::min(farthest, v.z);
    }
    const double slack = 1e-6 * (nearest - farthest) + 1e-12;
    return {nearest + slack, farthest - slack};
  }

  void fill_nearest(const DrawnPolygon& polygon, const SupportVertices& support,
                    const ScanConverter::Rows& rows, std::uint32_t colour) {
    fetch_cells(polygon.vertices, rows);
    z_buffer_.begin_polygon(polygon.vertices, support);
    colours_.push_back(colour);
    if (ids_) picks_.push_back(polygon.pick);
    converter_.scan([&](int row, int first, int end) {
      if (cells_.roundoff.empty()) {
        z_buffer_.draw_span(row, first, end, cells_.exact.data() + index(0, row));
      } else {
        z_buffer_.draw_span(row, first, end, cells_.roundoff.data() + index(0, row));
      }
    });
  }

  /// A small polygon's rows lie a picture's width apart in memory: asked for together before the
  /// first is needed, they do not have to be waited for one after another.
  void fetch_cells(std::span<const Point3> vertices, const ScanConverter::Rows& rows) const {
    double left = vertices[0].x;
    for (const Point3& v : vertices) left = std::min(left, v.x);
    const int column = static_cast<int>(std::clamp(left * width_, 0.0, width_ - 1.0));
    const int end = std::min(rows.end, rows.first + kRowsFetched);
    for (int row = rows.first; row < end; ++row) {
      if (!cells_.exact.empty()) __builtin_prefetch(&cells_.exact[index(column, row)], 1);
    }
  }

  /// Back to front. Close to its boundary, and so where it is too narrow to have a plane or to
  /// cover a centre, it does not matter what is painted.
  void fill_sorted(const DrawnPolygon& polygon) {
    const bool at_boundaries = undecided_fills_ == Undecided::at_boundaries;
    Point2 error(0.0);
    if (at_boundaries) {
      error = boundary_error(polygon.vertices, region_.size) + boundary_error_;
      note_rows_of_vertices(polygon.vertices, error, region_.size, undecided_);
    }
    const ScanConverter::Rows rows = converter_.begin(polygon.vertices, region_);
    if (rows.first == rows.end) return;
    if (at_boundaries) {
      converter_.watch(error);
    } else if (support_vertices(polygon.vertices).edge_on) {
      return;
    }
    const std::uint32_t colour = pixel_of(polygon.fill.colour);
    converter_.scan(
        [&](int row, int first, int end) {
          paint(row, first, end, colour, polygon.pick);
          lines_on_top_.remove(row, first, end);
          if (undecided_fills_ == Undecided::all) undecided_.add(row, first, end);
          if (!picture_.depth.empty()) covered_.add(row, first, end);
        },
        [&](int row, int first, int end) {
          if (at_boundaries) undecided_.add(row, first, end);
        });
  }

  /// A cut polygon's own plane is anywhere where rounding has moved its vertices: the depth of
  /// what is seen is that of the polygon as entered.
  void show_depth_of_whole_polygons() {
    undecided_.for_each([&](int row, int column) { covered_.add(row, column, column + 1); });
    for_each_nearest(covered_, [&](int row, int column, const NearestAtCentres::Seen* seen) {
      if (!seen) return;
      const PixelDepth depth(seen->plane, width_, height_);
      picture_.depth[index(column, row)] = depth.at(depth.row(row), column);
    });
  }

  template <class Show>
  void for_each_nearest(const PixelSet& centres, Show&& show) const {
    NearestAtCentres nearest(centres, region_.size);
    EnteredFills entered(display_file_, nearest);
    interpret(display_file_, entered, Pass::fills, Order::entered);
    nearest.show(show);
  }

  void paint(int row, int first, int end, std::uint32_t colour, std::int32_t pick) {
    const std::size_t start = index(0, row);
    std::uint32_t* pixels = picture_.pixels.data() + start;
    std::fill(pixels + first, pixels + end, colour);
    if (!ids_) return;
    std::int32_t* ids = picture_.ids.data() + start;
    std::fill(ids + first, ids + end, pick);
  }

  void fill_over(const DrawnPolygon& polygon, const SupportVertices& support,
                 std::uint32_t colour) {
    std::optional<PixelDepth> depth;
    if (!picture_.depth.empty()) depth.emplace(polygon.vertices, support, width_, height_);
    converter_.scan([&](int row, int first, int end) {
      paint(row, first, end, colour, polygon.pick);
      if (!depth) return;
      const std::size_t start = index(0, row);
      const double row_depth = depth->row(row);
      for (int i = first; i < end; ++i) {
        picture_.depth[start + static_cast<std::size_t>(i)] = depth->at(row_depth, i);
      }
    });
  }

  void plot(int x, int y, double z, std::uint32_t colour) {
    if (y < region_.row_begin || y >= region_.row_end) return;
    const std::size_t at = index(x, y);
    if (z_buffer_on_) {
      if (z < picture_.depth[at]) return;
      picture_.depth[at] = z;
    }
    if (sorted_) lines_on_top_.add(y, x, x + 1);
    picture_.pixels[at] = colour;
  }

  const DisplayFile& display_file_;
  Picture& picture_;
  SoftwareCells& cells_;
  int width_, height_;
  bool z_buffer_on_, ids_;
  ScanConverter::Region region_;
  ZBuffer z_buffer_;
  std::vector<std::uint32_t> colours_;  // of the polygons that the z-buffer has begun
  std::vector<std::int32_t> picks_;
  ScanConverter converter_;
  DashPhase dash_phase_;
  Point3 dash_end_{kFarthest};
  bool sorted_;
  Undecided undecided_fills_ = Undecided::none;  // of the segment
  Point2 boundary_error_{0.0};                   // of the segment's sort, in pixels
  PixelSet undecided_;                           // centres that the order does not decide
  PixelSet covered_;                             // whose depth is asked for
  PixelSet lines_on_top_;  // pixels that a line was painted on after all fills
};

bool has_lines(const DisplayFile& display_file) {
  struct Lines {
    bool found = false;
    void fill(const FillStyle&) {}
    void line_style(const LineStyle& style) { found |= style.kind != LineStyle::Kind::none; }
    void pick(int) {}
    void move(const Point3&) {}
    void line(const Point3&) {}
    void polygon(std::span<const Point3>, std::span<const std::int32_t>) {}
  } lines;
  for (const Segment& segment : display_file.segments()) {
    if (segment.visible && !lines.found) segment.walk_entered(lines);
  }
  return lines.found;
}

}  // namespace

std::uint32_t pixel_of(const Colour& colour) {
  const auto byte = [](double c) { return static_cast<std::uint32_t>(c * 255.0 + 0.5); };
  return 0xFF000000u | byte(colour.b) << 16 | byte(colour.g) << 8 | byte(colour.r);
}

namespace {

/// At least one band a thread. Every band costs a walk over all polygons; where they are few for
/// the picture's size, more bands share the work evenly.
int bands_for(const RasterRequest& request, std::size_t polygons) {
  if (request.threads <= 1) return 1;
  constexpr std::size_t kPixelsForEachPolygon = 64;
  constexpr int kRowsOfABand = 64;
  const auto pixels =
      static_cast<std::size_t>(request.width) * static_cast<std::size_t>(request.height);
  const std::size_t worth_it = pixels / (kPixelsForEachPolygon * (polygons + 1));
  const int most = std::max(request.threads, request.height / kRowsOfABand);
  const int bands = worth_it < static_cast<std::size_t>(most) ? static_cast<int>(worth_it) : most;
  return std::clamp(std::max(bands, request.threads), 1, request.height);
}

}  // namespace

void SoftwareCells::make_clear(std::size_t exact_cells, std::size_t roundoff_cells) {
  if (!clear || exact.size() != exact_cells) exact.assign(exact_cells, {});
  if (!clear || roundoff.size() != roundoff_cells) roundoff.assign(roundoff_cells, {});
}

/// Each thread interprets the display file for a band of rows of its own.
void SoftwareRenderer::interpret_in_bands(const DisplayFile& display_file,
                                          const RasterRequest& request, Pass pass) {
  const int bands = bands_for(request, display_file.polygons());
  std::atomic<std::size_t> undecided = 0;
  const auto interpret_band = [&](int band) {
    const auto row = [&](long long b) { return static_cast<int>(b * request.height / bands); };
    SoftwareDevice device(display_file, picture_, cells_, request, {row(band), row(band + 1)});
    interpret(display_file, device, pass, request.z_buffer ? Order::entered : Order::drawn);
    if (pass == Pass::fills) device.show_nearest();
    if (pass == Pass::everything && request.sorted) undecided += device.decide_centres();
  };
  const int threads = std::min(request.threads, tbb::this_task_arena::max_concurrency());
  if (bands == 1) {
    interpret_band(0);
  } else {
    tbb::task_arena(std::max(1, threads)).execute([&] {
      tbb::parallel_for(0, bands, interpret_band);
    });
  }
  picture_.undecided_centres = undecided;
}

const Picture& SoftwareRenderer::draw(const DisplayFile& display_file,
                                      const RasterRequest& request) {
  require_picture_size(request.width, request.height);
  const auto size =
      static_cast<std::size_t>(request.width) * static_cast<std::size_t>(request.height);
  picture_.width = request.width;
  picture_.height = request.height;
  const bool lines = request.z_buffer && has_lines(display_file);
  if (request.z_buffer) {  // every pixel is written in the end
    picture_.pixels.resize(size);
    picture_.ids.resize(request.ids ? size : 0);
    picture_.depth.resize(request.depth || lines ? size : 0);
  } else {
    picture_.pixels.assign(size, kBackground);
    picture_.ids.assign(request.ids ? size : 0, -1);
    picture_.depth.assign(request.depth ? size : 0, kFarthest);
  }
  cells_.make_clear(request.z_buffer && !request.roundoff ? size : 0,
                    request.z_buffer && request.roundoff ? size : 0);

  if (!request.z_buffer) {
    interpret_in_bands(display_file, request, Pass::everything);
    return picture_;
  }
  cells_.clear = false;
  interpret_in_bands(display_file, request, Pass::fills);
  cells_.clear = true;
  if (!lines) return picture_;
  std::vector<double> of_fills;
  if (request.depth) of_fills = picture_.depth;
  interpret_in_bands(display_file, request, Pass::lines);
  if (request.depth) picture_.depth = std::move(of_fills);
  return picture_;
}

Picture draw_with_software(const DisplayFile& display_file, const RasterRequest& request) {
  SoftwareRenderer renderer;
  renderer.draw(display_file, request);
  Picture picture = renderer.take_picture();
  if (!request.depth) picture.depth = {};
  return picture;
}

}  // namespace displayfile
