#include "interp/vector/sampled/visible_order.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <unordered_map>
#include <vector>

#include "interp/picture.h"
#include "interp/vector/sampled/drawing_order.h"
#include "interp/vector/sampled/sampled_scene.h"
#include "interp/vector/sampled/seen_band.h"
#include "interp/vector/sampled/visible_lines.h"

namespace displayfile {

namespace {

using Fill = ViewedScene::Fill;

/// How many pixels the z-buffer holds at one time.
constexpr int kPixelsPerBand = 1 << 22;

/// A fill that reaches no centre is compared with the pixels it touches if these are few.
constexpr int kFewPixels = SeenBand::kMargin - 2;

/// A fill beyond what is seen by less than this is kept: it may be part of the same surface.
constexpr double kSameSurface = 1e-6;

/// What the z-buffer tells of the fills.
struct Visibility {
  std::vector<std::uint8_t> drawn;  ///< seen somewhere, or reaching no centre and not hidden
  std::vector<Overlap> overlaps;
};

/// The picture's rows, band by band from the bottom.
class Bands {
 public:
  explicit Bands(const SampledScene& drawing) : drawing_(drawing), band_(drawing) {
    rows_.reserve(drawing.scene.end());
    rows_.push_back({1, 0});  // the background
    for (Fill fill = 1; fill < drawing.scene.end(); ++fill) {
      rows_.push_back(rows_reached(drawing.scene.vertices(fill), drawing.size.height));
    }
  }

  /// Calls use(band, fills that reach it). A picture of one band keeps it for the next time.
  template <class Use>
  void for_each(Use&& use) {
    ActiveByRow fills(rows_);
    const auto [width, height] = drawing_.size;
    const int step = std::max(SeenBand::kMargin, kPixelsPerBand / width);
    for (int row = 0; row < height; row += step) {
      const int end = std::min(height, row + step);
      if (band_.first_row() != row || band_.end_row() != end) band_.find(row, end);
      use(band_, fills.reaching(row - SeenBand::kMargin, end + SeenBand::kMargin));
    }
  }

 private:
  const SampledScene& drawing_;
  std::vector<ActiveByRow::Rows> rows_;
  SeenBand band_;
};

/// Who is seen, and which fills hide which of these.
class OverlapFinder {
 public:
  OverlapFinder(const SampledScene& drawing, Visibility& visibility)
      : drawing_(drawing), visibility_(visibility) {}

  void find_seen(SeenBand& band, std::span<const Fill> fills) {
    for (int row = band.first_row(); row < band.end_row(); ++row) {
      for (int i = 0; i < drawing_.size.width; ++i) visibility_.drawn[band.seen(i, row)] = 1;
    }
    visibility_.drawn[ViewedScene::kBackground] = 0;
    for (const Fill fill : fills) {
      if (visibility_.drawn[fill] != 0) continue;
      bool reaches_a_centre = false;
      band.for_each_run(fill, [&](int, int, int) { reaches_a_centre = true; });
      if (!reaches_a_centre) compare_between_centres(band, fill);
    }
  }

  /// To be called when all that is drawn was found: there may be many fills of which nothing
  /// is seen, and what hides them does not matter.
  void find_overlaps(SeenBand& band, std::span<const Fill> fills) {
    for (const Fill fill : fills) {
      if (visibility_.drawn[fill] != 0) compare_at_centres(band, fill);
    }
  }

 private:
  void compare_at_centres(SeenBand& band, Fill fill) {
    hiders_.clear();
    band.for_each_run(fill, [&](int row, int first, int end) {
      for (int i = first; i < end; ++i) {
        const Fill seen = band.seen(i, row);
        if (seen != fill && (hiders_.empty() || hiders_.back() != seen)) {
          hiders_.push_back(seen);
        }
      }
    });
    std::ranges::sort(hiders_);
    hiders_.erase(std::unique(hiders_.begin(), hiders_.end()), hiders_.end());
    for (const Fill seen : hiders_) visibility_.overlaps.push_back({fill, seen});
  }

  /// A fill that lies between the centres is left out only if it is small and what is seen
  /// all around is nearer; otherwise it is ordered by what is seen at its middle.
  void compare_between_centres(const SeenBand& band, Fill fill) {
    const auto vertices = drawing_.scene.vertices(fill);
    Point3 low = drawing_.to_pixels(vertices[0]), high = low, middle(0.0);
    for (const Point3& v : vertices) {
      const Point3 p = drawing_.to_pixels(v);
      low = {std::min(low.x, p.x), std::min(low.y, p.y), 0.0};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), 0.0};
      middle += p;
    }
    middle /= static_cast<double>(vertices.size());
    const int column = pixel(middle.x, drawing_.size.width);
    const int row = pixel(middle.y, drawing_.size.height);
    if (row < band.first_row() || row >= band.end_row()) return;  // another band's
    if (high.x - low.x < kFewPixels && high.y - low.y < kFewPixels &&
        is_hidden(band, fill, low, high)) {
      return;
    }
    visibility_.drawn[fill] = 1;
    const Fill seen = band.seen(column, row);
    if (seen == ViewedScene::kBackground) return;
    if (!drawing_.covers(seen, middle.x, middle.y) || !drawing_.covers(fill, middle.x, middle.y)) {
      return;
    }
    const double z = drawing_.depths[fill].plane.at_point(middle.x, middle.y);
    const double seen_z = drawing_.depths[seen].plane.at_point(middle.x, middle.y);
    const bool nearer = z > seen_z || (z == seen_z && fill > seen);
    visibility_.overlaps.push_back(nearer ? Overlap{seen, fill} : Overlap{fill, seen});
  }

  bool is_hidden(const SeenBand& band, Fill fill, const Point3& low, const Point3& high) const {
    const int first_column = pixel(low.x - 1.0, drawing_.size.width);
    const int last_column = pixel(high.x + 1.0, drawing_.size.width);
    const int first_row = std::max(pixel(low.y - 1.0, drawing_.size.height), band.first_row_kept());
    const int last_row =
        std::min(pixel(high.y + 1.0, drawing_.size.height), band.end_row_kept() - 1);
    for (int j = first_row; j <= last_row; ++j) {
      for (int i = first_column; i <= last_column; ++i) {
        if (!(band.depth(i, j) > drawing_.depths[fill].nearest + kSameSurface)) return false;
      }
    }
    return true;
  }

  static int pixel(double v, int limit) {
    return static_cast<int>(std::clamp(std::floor(v), 0.0, limit - 1.0));
  }

  const SampledScene& drawing_;
  Visibility& visibility_;
  std::vector<Fill> hiders_;
};

/// Where each fill that has to be mended is seen: runs of pixels, those that are equal in
/// consecutive rows joined.
class SeenPixels {
 public:
  explicit SeenPixels(std::span<const DrawStep> steps) {
    for (const DrawStep& step : steps) {
      if (step.mend) blocks_[step.polygon];
    }
  }

  bool empty() const { return blocks_.empty(); }

  void look(SeenBand& band, std::span<const Fill> fills) {
    for (const Fill fill : fills) {
      const auto found = blocks_.find(fill);
      if (found == blocks_.end()) continue;
      band.for_each_run(fill, [&](int row, int first, int end) {
        for (int i = first; i < end;) {
          while (i < end && band.seen(i, row) != fill) ++i;
          const int start = i;
          while (i < end && band.seen(i, row) == fill) ++i;
          if (start < i) add(found->second, start, i, row);
        }
      });
    }
  }

  std::span<const PixelBox> of(Fill fill) const { return blocks_.at(fill); }

 private:
  static void add(std::vector<PixelBox>& blocks, int first, int end, int row) {
    if (!blocks.empty() && blocks.back().first_column == first && blocks.back().end_column == end &&
        blocks.back().end_row == row) {
      blocks.back().end_row = row + 1;
    } else {
      blocks.push_back({first, end, row, row + 1});
    }
  }

  std::unordered_map<Fill, std::vector<PixelBox>> blocks_;
};

/// Begins and ends segments as what is drawn asks for.
class SegmentSwitch {
 public:
  SegmentSwitch(const ViewedScene& scene, OutputDevice& device) : scene_(scene), device_(device) {}
  void enter_that_of(ViewedScene::Item item) {
    const int segment = scene_.segment_name(item);
    if (open_ && segment == current_) return;
    leave();
    device_.begin_segment(segment);
    current_ = segment;
    open_ = true;
  }
  void leave() {
    if (open_) device_.end_segment();
    open_ = false;
  }

 private:
  const ViewedScene& scene_;
  OutputDevice& device_;
  bool open_ = false;
  int current_ = 0;
};

Visibility find_visibility(const SampledScene& drawing, Bands& bands, VisibleLines& lines) {
  Visibility visibility;
  visibility.drawn.assign(drawing.scene.end(), 0);
  OverlapFinder overlaps(drawing, visibility);
  ActiveByRow line_rows(lines.rows());
  bands.for_each([&](SeenBand& band, std::span<const Fill> fills) {
    overlaps.find_seen(band, fills);
    lines.look(band, line_rows.reaching(band.first_row(), band.end_row()));
  });
  lines.finish();
  bands.for_each(
      [&](SeenBand& band, std::span<const Fill> fills) { overlaps.find_overlaps(band, fills); });
  return visibility;
}

void draw_fills(const SampledScene& drawing, Bands& bands, Visibility visibility,
                VectorDevice& device, SegmentSwitch& segments) {
  std::vector<double> farthest;
  farthest.reserve(drawing.depths.size());
  for (const SampledScene::Depths& depths : drawing.depths) farthest.push_back(depths.farthest);
  const std::vector<DrawStep> steps =
      drawing_order(std::move(visibility.overlaps), farthest, visibility.drawn);
  SeenPixels seen(steps);
  if (!seen.empty()) {
    bands.for_each([&](SeenBand& band, std::span<const Fill> fills) { seen.look(band, fills); });
  }
  for (const DrawStep& step : steps) {
    const ViewedScene::Item item = drawing.scene.item_of(step.polygon);
    segments.enter_that_of(item);
    drawing.draw_polygon(item, [&](const DrawnPolygon& polygon) {
      if (step.mend) {
        device.fill_within(polygon, seen.of(step.polygon));
      } else {
        device.fill(polygon);
      }
    });
  }
}

/// Draws parts of lines; dashes are cut here, so that they lie where they would if all of the line
/// were seen.
class LinePartsDrawer {
 public:
  LinePartsDrawer(const SampledScene& drawing, OutputDevice& device)
      : drawing_(drawing), device_(device) {}

  void draw(std::uint32_t index, const LinePart& part) {
    const SampledScene::Line line = drawing_.line(index);
    const LineStyle& style = line.style;
    constexpr double kShortestPeriod = 0.1;  // pixels; below it a dashed line looks solid
    if (style.kind != LineStyle::Kind::dashed || style.dash + style.gap < kShortestPeriod) {
      return draw_piece(line, part.from, part.to, style);
    }
    const Point3 a = drawing_.to_pixels(line.from), b = drawing_.to_pixels(line.to);
    const double length = glm::length(Point2(b - a));
    const double period = style.dash + style.gap;
    const double before = drawing_.lines[index].dash_start;
    const double start = before + part.from * length, end = before + part.to * length;
    for (double dash = std::floor(start / period) * period; dash < end; dash += period) {
      const double from = std::max(start, dash), to = std::min(end, dash + style.dash);
      if (from < to) {
        // Exactly the part's ends: a dash goes on in the line that continues this one.
        draw_piece(line, from == start ? part.from : (from - before) / length,
                   to == end ? part.to : (to - before) / length, style);
      }
    }
  }

 private:
  void draw_piece(const SampledScene::Line& line, double from, double to, LineStyle style) {
    style.kind = LineStyle::Kind::solid;
    const auto point = [&](double t) {  // exactly an end at an end: lines that meet stay joined
      return t <= 0.0 ? line.from : t >= 1.0 ? line.to : line.from + t * (line.to - line.from);
    };
    device_.line({point(from), point(to), style, line.kinds});
  }

  const SampledScene& drawing_;
  OutputDevice& device_;
};

void draw_lines(const SampledScene& drawing, VisibleLines& visible, VectorDevice& device,
                SegmentSwitch& segments) {
  LinePartsDrawer parts(drawing, device);
  const auto wholly_visible = [&](std::uint32_t line) {
    const auto p = visible.parts(line);
    return p.size() == 1 && p[0].from == 0.0 && p[0].to == 1.0;
  };
  for (std::uint32_t first = 0; first < drawing.lines.size();) {
    const ViewedScene::Item item = drawing.lines[first].item;
    std::uint32_t end = first + 1;
    if (drawing.scene.kind(item) != Primitives::Kind::line) {
      while (end < drawing.lines.size() && drawing.lines[end].item == item) ++end;
      bool whole = true;
      for (std::uint32_t i = first; i < end && whole; ++i) whole = wholly_visible(i);
      if (whole) {
        segments.enter_that_of(item);
        drawing.draw_polygon(item, [&](const DrawnPolygon& polygon) { device.edges(polygon); });
        first = end;
        continue;
      }
    }
    for (; first < end; ++first) {
      for (const LinePart& part : visible.parts(first)) {
        segments.enter_that_of(item);
        parts.draw(first, part);
      }
    }
  }
}

}  // namespace

void draw_in_visible_order(const DisplayFile& display_file, int width, int height,
                           VectorDevice& device) {
  require_picture_size(width, height);
  const SampledScene drawing(display_file, {width, height});
  Bands bands(drawing);
  VisibleLines lines(drawing);
  Visibility visibility = find_visibility(drawing, bands, lines);
  SegmentSwitch segments(drawing.scene, device);
  draw_fills(drawing, bands, std::move(visibility), device, segments);
  draw_lines(drawing, lines, device, segments);
  segments.leave();
}

}  // namespace displayfile
