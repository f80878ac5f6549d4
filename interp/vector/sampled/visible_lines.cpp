#include "interp/vector/sampled/visible_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace displayfile {

namespace {

using Fill = ViewedScene::Fill;

constexpr double kStepsPerPixel = 2.0;
/// How often half a pixel is halved: to 1/2048 pixel.
constexpr int kBisections = 10;

/// A fill hides a line if it is nearer by more than this, so that rounding, and the tolerance
/// within which faces count as flat, do not let a face hide its own edges; and by more than
/// this part of a pixel makes on its slope.
constexpr double kDepthTolerance = 2e-6;
constexpr double kPixelTolerance = 1e-3;

double slope(const PixelDepth& depth) { return std::abs(depth.dz_dx) + std::abs(depth.dz_dy); }

}  // namespace

VisibleLines::VisibleLines(const SampledScene& drawing) : drawing_(drawing) {}

/// Clips the line to the picture and half its width around it.
VisibleLines::Steps VisibleLines::steps_of(const SampledScene::Line& line) const {
  const Point3 a = drawing_.to_pixels(line.from), b = drawing_.to_pixels(line.to);
  for (const double v : {a.x, a.y, a.z, b.x, b.y, b.z}) {
    if (!std::isfinite(v)) return {};
  }
  const double reach = line.style.width / 2 + 1.0;
  const auto part = part_in_rectangle(
      a, b, {-reach, drawing_.size.width + reach, -reach, drawing_.size.height + reach});
  if (!part) return {};
  const double length = glm::length(Point2(b - a)) * (part->to - part->from);
  return {part->from, part->to,
          std::max(std::int64_t{1}, static_cast<std::int64_t>(std::ceil(length * kStepsPerPixel)))};
}

Point3 VisibleLines::point(const SampledScene::Line& line, double t) const {
  return drawing_.to_pixels(line.from + t * (line.to - line.from));
}

/// The row that judges a point; beyond the picture, its nearest row.
int VisibleLines::row_of(const SampledScene::Line& line, double t) const {
  return static_cast<int>(
      std::clamp(std::floor(point(line, t).y), 0.0, drawing_.size.height - 1.0));
}

std::vector<ActiveByRow::Rows> VisibleLines::rows() const {
  std::vector<ActiveByRow::Rows> rows;
  rows.reserve(drawing_.lines.size());
  for (std::uint32_t index = 0; index < drawing_.lines.size(); ++index) {
    const SampledScene::Line line = drawing_.line(index);
    const Steps steps = steps_of(line);
    if (steps.count < 0) {
      rows.push_back({1, 0});
      continue;
    }
    const auto [first, last] = std::minmax({row_of(line, steps.from), row_of(line, steps.to)});
    rows.push_back({first, last});
  }
  return rows;
}

bool VisibleLines::visible(const SeenBand& band, const SampledScene::Line& line, double t) const {
  const Point3 p = point(line, t);
  const auto centre = [](double v, int first, int end) {
    return static_cast<int>(std::clamp(std::floor(v), static_cast<double>(first), end - 1.0));
  };
  std::array<Fill, 4> tried{};
  std::size_t tries = 0;
  bool all_nearer = true;
  for (int k = 0; k < 4; ++k) {
    const int i = centre(p.x - 0.5 + (k & 1), 0, drawing_.size.width);
    const int j = centre(p.y - 0.5 + (k >> 1), band.first_row_kept(), band.end_row_kept());
    const Fill seen = band.seen(i, j);
    if (seen == ViewedScene::kBackground || seen == line.fill) {
      all_nearer = false;
      continue;
    }
    const SampledScene::Depths& fill = drawing_.depths[seen];
    all_nearer = all_nearer && band.depth(i, j) - slope(fill.plane) > p.z + kDepthTolerance;
    if (std::find(tried.begin(), tried.begin() + tries, seen) != tried.begin() + tries) continue;
    tried[tries++] = seen;
    const double z = std::clamp(fill.plane.at_point(p.x, p.y), fill.farthest, fill.nearest);
    if (z > p.z + kDepthTolerance + kPixelTolerance * slope(fill.plane) &&
        drawing_.covers(seen, p.x, p.y)) {
      return false;
    }
  }
  return !all_nearer;
}

double VisibleLines::find_change(const SeenBand& band, const SampledScene::Line& line,
                                 double before, double after, bool visible_before) const {
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (before + after);
    (visible(band, line, middle) == visible_before ? before : after) = middle;
  }
  return 0.5 * (before + after);
}

/// Rows only grow, or only fall, along a line, so the step is found by halving; one beyond the
/// last if there is none.
std::int64_t VisibleLines::first_step_in(const SeenBand& band, const SampledScene::Line& line,
                                         const Steps& steps) const {
  const bool rising = row_of(line, steps.from) <= row_of(line, steps.to);
  const auto before_band = [&](std::int64_t k) {
    const int row = row_of(line, steps.at(k));
    return rising ? row < band.first_row() : row >= band.end_row();
  };
  std::int64_t first = 0, end = steps.count + 1;
  while (first < end) {
    const std::int64_t middle = first + (end - first) / 2;
    if (before_band(middle)) {
      first = middle + 1;
    } else {
      end = middle;
    }
  }
  return first;
}

void VisibleLines::look(const SeenBand& band, std::span<const std::uint32_t> lines) {
  for (const std::uint32_t index : lines) {
    const SampledScene::Line line = drawing_.line(index);
    const Steps steps = steps_of(line);
    // Each step belongs to the band that holds the row of its beginning.
    const auto in_band = [&](std::int64_t k) {
      const int row = row_of(line, steps.at(k));
      return row >= band.first_row() && row < band.end_row();
    };
    std::int64_t k = first_step_in(band, line, steps);
    if (k > steps.count || !in_band(k)) continue;
    bool visible_here = visible(band, line, steps.at(k));
    if (k == 0 && visible_here) changes_.push_back({index, steps.from, true});
    for (; k < steps.count && in_band(k); ++k) {
      const bool visible_next = visible(band, line, steps.at(k + 1));
      if (visible_next == visible_here) continue;
      changes_.push_back({index,
                          find_change(band, line, steps.at(k), steps.at(k + 1), visible_here),
                          visible_next});
      visible_here = visible_next;
    }
    if (k == steps.count && visible_here && in_band(k)) {
      changes_.push_back({index, steps.to, false});
    }
  }
}

void VisibleLines::finish() {
  std::ranges::stable_sort(changes_, [](const Change& a, const Change& b) {
    return a.line != b.line ? a.line < b.line : a.at < b.at;
  });
  first_change_.assign(drawing_.lines.size() + 1, 0);
  for (const Change& change : changes_) ++first_change_[change.line + 1];
  for (std::size_t i = 1; i < first_change_.size(); ++i) first_change_[i] += first_change_[i - 1];
}

std::span<const LinePart> VisibleLines::parts(std::uint32_t line) {
  parts_.clear();
  for (std::size_t i = first_change_[line]; i < first_change_[line + 1]; ++i) {
    if (changes_[i].to_visible) {
      parts_.push_back({changes_[i].at, 1.0});
    } else if (!parts_.empty()) {
      parts_.back().to = changes_[i].at;
    }
  }
  return parts_;
}

}  // namespace displayfile
