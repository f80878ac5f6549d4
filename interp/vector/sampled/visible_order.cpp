#include "interp/vector/sampled/visible_order.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <vector>

#include "interp/picture.h"
#include "interp/vector/sampled/collected_drawing.h"
#include "interp/vector/sampled/drawing_order.h"
#include "interp/vector/sampled/seen_band.h"
#include "interp/vector/sampled/visible_lines.h"

namespace displayfile {

namespace {

/// Of the z-buffer at one time.
constexpr int kPixelsPerBand = 1 << 22;

/// A polygon that reaches no centre is compared with the pixels it touches if these are few.
constexpr int kFewPixels = SeenBand::kMargin - 2;

/// A polygon beyond what is seen by less than this is kept: it may be part of the same surface.
constexpr double kSameSurface = 1e-6;

/// What the z-buffer tells of the polygons.
struct Visibility {
  std::vector<std::uint8_t> drawn;  ///< seen somewhere, or reaching no centre and not hidden
  std::vector<Overlap> overlaps;
};

/// The picture's rows, band by band from the bottom.
class Bands {
 public:
  explicit Bands(const CollectedDrawing& drawing) : drawing_(drawing), band_(drawing) {
    rows_.reserve(drawing.polygons.size());
    for (const auto& p : drawing.polygons) {
      rows_.push_back(p.filled ? ItemsByRow::Rows{p.first_row, p.last_row}
                               : ItemsByRow::Rows{1, 0});
    }
  }

  /// Calls use(band, polygons that reach it). A picture of one band keeps it for the next time.
  template <class Use>
  void for_each(Use&& use) {
    ItemsByRow polygons(rows_);
    const int step = std::max(SeenBand::kMargin, kPixelsPerBand / drawing_.width);
    for (int row = 0; row < drawing_.height; row += step) {
      const int end = std::min(drawing_.height, row + step);
      const auto reaching = polygons.reaching(row - SeenBand::kMargin, end + SeenBand::kMargin);
      if (band_.first_row() != row || band_.end_row() != end) band_.find(row, end, reaching);
      use(band_, reaching);
    }
  }

 private:
  const CollectedDrawing& drawing_;
  std::vector<ItemsByRow::Rows> rows_;
  SeenBand band_;
};

/// Who is seen, and which polygons hide which of these.
class OverlapFinder {
 public:
  OverlapFinder(const CollectedDrawing& drawing, Visibility& visibility)
      : drawing_(drawing), visibility_(visibility) {}

  void find_seen(SeenBand& band, std::span<const std::uint32_t> polygons) {
    for (int row = band.first_row(); row < band.end_row(); ++row) {
      for (int i = 0; i < drawing_.width; ++i) {
        if (const std::uint32_t seen = band.seen(i, row); seen != SeenBand::kBackground) {
          visibility_.drawn[seen] = 1;
        }
      }
    }
    for (const std::uint32_t polygon : polygons) {
      if (visibility_.drawn[polygon] != 0) continue;
      bool reaches_a_centre = false;
      band.for_each_run(polygon, [&](int, int, int) { reaches_a_centre = true; });
      if (!reaches_a_centre) compare_between_centres(band, polygon);
    }
  }

  /// To be called when all that is drawn was found: there may be many polygons of which nothing
  /// is seen, and what hides them does not matter.
  void find_overlaps(SeenBand& band, std::span<const std::uint32_t> polygons) {
    for (const std::uint32_t polygon : polygons) {
      if (visibility_.drawn[polygon] != 0) compare_at_centres(band, polygon);
    }
  }

 private:
  void compare_at_centres(SeenBand& band, std::uint32_t polygon) {
    hiders_.clear();
    band.for_each_run(polygon, [&](int row, int first, int end) {
      for (int i = first; i < end; ++i) {
        const std::uint32_t seen = band.seen(i, row);
        if (seen != polygon && (hiders_.empty() || hiders_.back() != seen)) {
          hiders_.push_back(seen);
        }
      }
    });
    std::ranges::sort(hiders_);
    hiders_.erase(std::unique(hiders_.begin(), hiders_.end()), hiders_.end());
    for (const std::uint32_t seen : hiders_) visibility_.overlaps.push_back({polygon, seen});
  }

  /// A polygon that lies between the centres is left out only if it is small and what is seen
  /// all around is nearer; otherwise it is ordered by what is seen at its middle.
  void compare_between_centres(const SeenBand& band, std::uint32_t index) {
    const CollectedDrawing::Polygon& polygon = drawing_.polygons[index];
    Point3 low = drawing_.to_pixels(drawing_.vertices[polygon.first]), high = low, middle(0.0);
    for (const Point3& v : drawing_.vertices_of(polygon)) {
      const Point3 p = drawing_.to_pixels(v);
      low = {std::min(low.x, p.x), std::min(low.y, p.y), 0.0};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), 0.0};
      middle += p;
    }
    middle /= static_cast<double>(polygon.size);
    const int column = pixel(middle.x, drawing_.width), row = pixel(middle.y, drawing_.height);
    if (row < band.first_row() || row >= band.end_row()) return;  // another band's
    if (high.x - low.x < kFewPixels && high.y - low.y < kFewPixels &&
        is_hidden(band, polygon, low, high)) {
      return;
    }
    visibility_.drawn[index] = 1;
    const std::uint32_t seen = band.seen(column, row);
    if (seen == SeenBand::kBackground) return;
    const CollectedDrawing::Polygon& other = drawing_.polygons[seen];
    if (!drawing_.covers(other, middle.x, middle.y) ||
        !drawing_.covers(polygon, middle.x, middle.y)) {
      return;
    }
    const double z = polygon.depth.at_point(middle.x, middle.y);
    const double other_z = other.depth.at_point(middle.x, middle.y);
    const bool nearer = z > other_z || (z == other_z && index > seen);
    visibility_.overlaps.push_back(nearer ? Overlap{seen, index} : Overlap{index, seen});
  }

  bool is_hidden(const SeenBand& band, const CollectedDrawing::Polygon& polygon, const Point3& low,
                 const Point3& high) const {
    const int first_column = pixel(low.x - 1.0, drawing_.width);
    const int last_column = pixel(high.x + 1.0, drawing_.width);
    const int first_row = std::max(pixel(low.y - 1.0, drawing_.height), band.first_row_kept());
    const int last_row = std::min(pixel(high.y + 1.0, drawing_.height), band.end_row_kept() - 1);
    for (int j = first_row; j <= last_row; ++j) {
      for (int i = first_column; i <= last_column; ++i) {
        if (!(band.depth(i, j) > polygon.nearest + kSameSurface)) return false;
      }
    }
    return true;
  }

  static int pixel(double v, int limit) {
    return static_cast<int>(std::clamp(std::floor(v), 0.0, limit - 1.0));
  }

  const CollectedDrawing& drawing_;
  Visibility& visibility_;
  std::vector<std::uint32_t> hiders_;
};

/// Where each polygon that has to be mended is seen: runs of pixels, those that are equal in
/// consecutive rows joined.
class SeenPixels {
 public:
  explicit SeenPixels(std::span<const DrawStep> steps) {
    for (const DrawStep& step : steps) {
      if (step.mend) blocks_[step.polygon];
    }
  }

  bool empty() const { return blocks_.empty(); }

  void look(SeenBand& band, std::span<const std::uint32_t> polygons) {
    for (const std::uint32_t polygon : polygons) {
      const auto found = blocks_.find(polygon);
      if (found == blocks_.end()) continue;
      band.for_each_run(polygon, [&](int row, int first, int end) {
        for (int i = first; i < end;) {
          while (i < end && band.seen(i, row) != polygon) ++i;
          const int start = i;
          while (i < end && band.seen(i, row) == polygon) ++i;
          if (start < i) add(found->second, start, i, row);
        }
      });
    }
  }

  std::span<const PixelBox> of(std::uint32_t polygon) const { return blocks_.at(polygon); }

 private:
  static void add(std::vector<PixelBox>& blocks, int first, int end, int row) {
    if (!blocks.empty() && blocks.back().first_column == first && blocks.back().end_column == end &&
        blocks.back().end_row == row) {
      blocks.back().end_row = row + 1;
    } else {
      blocks.push_back({first, end, row, row + 1});
    }
  }

  std::unordered_map<std::uint32_t, std::vector<PixelBox>> blocks_;
};

/// Begins and ends segments as what is drawn asks for.
class SegmentSwitch {
 public:
  SegmentSwitch(const CollectedDrawing& drawing, OutputDevice& device)
      : drawing_(drawing), device_(device) {}
  void enter(std::uint32_t segment) {
    if (segment == current_) return;
    leave();
    device_.begin_segment(drawing_.segments[segment]);
    current_ = segment;
  }
  void leave() {
    if (current_ != CollectedDrawing::kNone) device_.end_segment();
    current_ = CollectedDrawing::kNone;
  }

 private:
  const CollectedDrawing& drawing_;
  OutputDevice& device_;
  std::uint32_t current_ = CollectedDrawing::kNone;
};

Visibility find_visibility(const CollectedDrawing& drawing, Bands& bands, VisibleLines& lines) {
  Visibility visibility;
  visibility.drawn.assign(drawing.polygons.size(), 0);
  OverlapFinder overlaps(drawing, visibility);
  ItemsByRow line_rows(lines.rows());
  bands.for_each([&](SeenBand& band, std::span<const std::uint32_t> polygons) {
    overlaps.find_seen(band, polygons);
    lines.look(band, line_rows.reaching(band.first_row(), band.end_row()));
  });
  lines.finish();
  bands.for_each([&](SeenBand& band, std::span<const std::uint32_t> polygons) {
    overlaps.find_overlaps(band, polygons);
  });
  return visibility;
}

void draw_fills(const CollectedDrawing& drawing, Bands& bands, Visibility visibility,
                VectorDevice& device, SegmentSwitch& segments) {
  std::vector<double> farthest;
  farthest.reserve(drawing.polygons.size());
  for (const auto& p : drawing.polygons) farthest.push_back(p.farthest);
  const std::vector<DrawStep> steps =
      drawing_order(std::move(visibility.overlaps), farthest, visibility.drawn);
  SeenPixels seen(steps);
  if (!seen.empty()) {
    bands.for_each([&](SeenBand& band, std::span<const std::uint32_t> polygons) {
      seen.look(band, polygons);
    });
  }
  for (const DrawStep& step : steps) {
    const CollectedDrawing::Polygon& polygon = drawing.polygons[step.polygon];
    segments.enter(polygon.segment);
    if (step.mend) {
      device.fill_within(drawing.drawn(polygon), seen.of(step.polygon));
    } else {
      device.fill(drawing.drawn(polygon));
    }
  }
}

/// Draws parts of lines; dashes are cut here, so that they lie where they would if all of the line
/// were seen.
class LinePartsDrawer {
 public:
  LinePartsDrawer(const CollectedDrawing& drawing, OutputDevice& device)
      : drawing_(drawing), device_(device) {}

  void draw(const CollectedDrawing::Line& line, const VisibleLines::Part& part) {
    const LineStyle& style = drawing_.line_styles[line.style];
    constexpr double kShortestPeriod = 0.1;  // pixels; below it a dashed line looks solid
    if (style.kind != LineStyle::Kind::dashed || style.dash + style.gap < kShortestPeriod) {
      return draw_piece(line, part.from, part.to, style);
    }
    const Point3 a = drawing_.to_pixels(line.from), b = drawing_.to_pixels(line.to);
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const double period = style.dash + style.gap;
    const double start = line.dash_start + part.from * length;
    const double end = line.dash_start + part.to * length;
    for (double dash = std::floor(start / period) * period; dash < end; dash += period) {
      const double from = std::max(start, dash), to = std::min(end, dash + style.dash);
      if (from < to) {
        draw_piece(line, (from - line.dash_start) / length, (to - line.dash_start) / length, style);
      }
    }
  }

 private:
  void draw_piece(const CollectedDrawing::Line& line, double from, double to, LineStyle style) {
    style.kind = LineStyle::Kind::solid;
    const auto point = [&](double t) {  // exactly an end at an end: lines that meet stay joined
      return t <= 0.0 ? line.from : t >= 1.0 ? line.to : line.from + t * (line.to - line.from);
    };
    device_.line({point(from), point(to), style});
  }

  const CollectedDrawing& drawing_;
  OutputDevice& device_;
};

void draw_lines(const CollectedDrawing& drawing, VisibleLines& visible, VectorDevice& device,
                SegmentSwitch& segments) {
  LinePartsDrawer parts(drawing, device);
  const auto wholly_visible = [&](std::uint32_t line) {
    const auto p = visible.parts(line);
    return p.size() == 1 && p[0].from == 0.0 && p[0].to == 1.0;
  };
  for (std::uint32_t first = 0; first < drawing.lines.size();) {
    const CollectedDrawing::Line& line = drawing.lines[first];
    std::uint32_t end = first + 1;
    if (line.polygon != CollectedDrawing::kNone) {
      while (end < drawing.lines.size() && drawing.lines[end].polygon == line.polygon) ++end;
      bool whole = true;
      for (std::uint32_t i = first; i < end && whole; ++i) whole = wholly_visible(i);
      if (whole) {
        segments.enter(line.segment);
        device.edges(drawing.drawn(drawing.polygons[line.polygon]));
        first = end;
        continue;
      }
    }
    for (; first < end; ++first) {
      for (const VisibleLines::Part& part : visible.parts(first)) {
        segments.enter(line.segment);
        parts.draw(drawing.lines[first], part);
      }
    }
  }
}

}  // namespace

void draw_in_visible_order(const DisplayFile& display_file, int width, int height,
                           VectorDevice& device) {
  require_picture_size(width, height);
  const CollectedDrawing drawing = collect(display_file, width, height);
  Bands bands(drawing);
  VisibleLines lines(drawing);
  Visibility visibility = find_visibility(drawing, bands, lines);
  SegmentSwitch segments(drawing, device);
  draw_fills(drawing, bands, std::move(visibility), device, segments);
  draw_lines(drawing, lines, device, segments);
  segments.leave();
}

}  // namespace displayfile
