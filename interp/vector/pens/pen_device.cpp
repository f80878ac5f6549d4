#include "interp/vector/pens/pen_device.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <utility>

#include "clip/geometry/clip_to_rectangle.h"
#include "clip/geometry/corners.h"
#include "displayfile/entered/instructions.h"
#include "interp/device/picture.h"
#include "interp/text/letter_paths.h"
#include "interp/text/seen_texts.h"
#include "interp/vector/pens/blanked_strokes.h"
#include "interp/vector/pens/dashes.h"
#include "interp/vector/pens/sheet_point.h"
#include "interp/vector/pens/stroke_chains.h"
#include "interp/vector/pens/unique_strokes.h"

namespace displayfile {

namespace {

bool is_finite(const Point2& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

Colour pen_on(const Colour& paper, const std::optional<Hatching>& hatching) {
  if (hatching && hatching->colour) return *hatching->colour;
  return Darkness::luma(paper) < 0.5 ? Colour(1.0) : Colour(0.0);
}

/// The width of a pen's line in units, at least 1.
std::int32_t units_of_width(double millimetres) {
  const double units = std::clamp(millimetres, 0.0, kLargestSheet) * kUnitsOfMillimetre;
  return static_cast<std::int32_t>(std::lround(std::max(1.0, units)));
}

}  // namespace

PenDevice::PenDevice(const Picture& picture, const Pens& pens, const Colour& background)
    : picture_(picture),
      crumbs_(pens.crumbs),
      lettering_(pens.lettering),
      darkness_(background, pen_on(background, pens.hatching)) {
  const std::optional<Hatching>& hatching = pens.hatching;
  const PaperFit& fit = picture.fit;
  frame_ = {fit.left, fit.left + fit.pixel * picture.width, fit.top,
            fit.top + fit.pixel * picture.height};
  if (!hatching) return;
  hatching_pen_ = {pixel_of(pen_on(background, hatching)), units_of_width(hatching->width)};
  hatched_.emplace(*hatching, frame_, crumbs_);
}

Point2 PenDevice::on_sheet(const Point3& device) const {
  const PaperFit& fit = picture_.fit;
  return {fit.left + device.x * picture_.width * fit.pixel,
          fit.top + (1.0 - device.y) * picture_.height * fit.pixel};
}

std::vector<Stroke>& PenDevice::strokes_of(const LineStyle& style) {
  const double of_pixel = picture_.fit.pixel;
  const Pen pen{pixel_of(style.colour), units_of_width(style.width * of_pixel)};
  const bool dashed = style.kind == LineStyle::Kind::dashed;
  const double dash = dashed ? style.dash * of_pixel * kUnitsOfMillimetre : 0.0;
  const double gap = dashed ? style.gap * of_pixel * kUnitsOfMillimetre : 0.0;
  const std::size_t blanked = blanks_.size();
  const auto is_it = [&](const Collected& c) {
    return c.pen == pen && c.dash == dash && c.gap == gap && c.blanked == blanked;
  };
  if (last_ < collected_.size() && is_it(collected_[last_])) return collected_[last_].strokes;
  const auto [place, is_new] = places_.try_emplace({pen, dash, gap, blanked}, collected_.size());
  if (is_new) collected_.push_back({pen, dash, gap, blanked, {}});
  last_ = place->second;
  return collected_[last_].strokes;
}

/// Adds a stroke between two points of the sheet.
void PenDevice::add(const Point2& a, const Point2& b, std::vector<Stroke>& strokes) const {
  if (!is_finite(a) || !is_finite(b)) return;
  const auto inside = part_in_rectangle(a, b, frame_);
  if (!inside) return;
  const auto at = [&](double t) {
    const Point2 p = t == 0.0 ? a : t == 1.0 ? b : a + t * (b - a);  // clamped: for rounding
    return sheet_point(
        {std::clamp(p.x, frame_.x_min, frame_.x_max), std::clamp(p.y, frame_.y_min, frame_.y_max)});
  };
  const Stroke stroke{at(inside->from), at(inside->to)};
  if (!stroke.is_dot() || a == b) strokes.push_back(stroke);
}

void PenDevice::line(const DrawnLine& line) {
  add(on_sheet(line.from), on_sheet(line.to), strokes_of(line.style));
}

void PenDevice::draw_texts(const DisplayFile& display_file) {
  if (!lettering_.is_of_paths()) return;
  for (const DeviceText& text : seen_texts(display_file, false)) draw_text(text, lettering_);
}

void PenDevice::draw_annotation_text(const DeviceText& text) {
  draw_text(text, lettering_of_pens(lettering_));
}

void PenDevice::draw_text(const DeviceText& text, const Lettering& lettering) {
  const double millimetres = picture_.height * picture_.fit.pixel;
  const auto letters =
      letter_paths(lettering, text, on_sheet(text.anchor), text.style.size * millimetres);
  std::vector<Stroke>& strokes = strokes_of(letters->stroke);
  for (const LetterPaths::Letter& letter : letters->letters) {
    for (const auto& points : letter) {
      for (std::size_t i = 1; i < points.size(); ++i) add(points[i - 1], points[i], strokes);
      if (letters->are_outlines) add(points.back(), points.front(), strokes);
    }
  }
}

void PenDevice::blank(std::span<const Point3> polygon) {
  std::vector<Point2>& area = blanks_.emplace_back();
  for (const Point3& p : polygon) area.push_back(kUnitsOfMillimetre * on_sheet(p));
}

/// Removes duplicates first: ends that are cut twice are rounded twice, and could then be too far
/// apart for unique_strokes.
std::vector<Stroke> PenDevice::not_blanked(std::vector<Stroke> strokes,
                                           std::size_t first_blank) const {
  if (first_blank == blanks_.size()) return strokes;
  strokes = unique_strokes(std::move(strokes));
  for (std::size_t k = first_blank; k < blanks_.size(); ++k) {
    strokes = strokes_outside(strokes, blanks_[k]);
  }
  return strokes;
}

void PenDevice::edges(const DrawnPolygon& polygon) {
  std::vector<Stroke>& strokes = strokes_of(polygon.line);
  const auto& v = polygon.vertices;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const Point3 &from = v[previous_corner(i, v.size())], &to = v[i];
    if (polygon.sides[i] != op::line || Point2(from) == Point2(to)) continue;
    if (!polygon.kinds.empty() && polygon.kinds[i] == 0) continue;
    add(on_sheet(from), on_sheet(to), strokes);
  }
}

/// By Newell's method; no visible polygon is edge-on.
Point2 PenDevice::slope_on_sheet(std::span<const Point3> vertices) const {
  Point3 normal(0.0), before = vertices.back() - vertices.front();
  for (const Point3& vertex : vertices) {
    const Point3 p = vertex - vertices.front();
    normal += glm::cross(before, p);
    before = p;
  }
  const double wide = picture_.width * picture_.fit.pixel,
               high = picture_.height * picture_.fit.pixel;
  return {-normal.x / (normal.z * wide), normal.y / (normal.z * high)};
}

void PenDevice::fill(const DrawnPolygon& polygon) {
  if (!hatched_) return;
  points_.clear();
  dark_.clear();
  for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
    points_.push_back(on_sheet(polygon.vertices[i]));
    if (!is_finite(points_.back())) return;
    const double intensity = polygon.intensities.empty() ? 1.0 : polygon.intensities[i];
    dark_.push_back(darkness_.of(polygon.fill.colour * intensity));
  }
  hatched_->add(points_, dark_, fills_are_disjoint_, slope_on_sheet(polygon.vertices));
}

std::vector<PenStrokes> PenDevice::strokes() {
  std::vector<PenStrokes> all;
  std::map<Pen, std::size_t> places;
  const auto strokes_of_pen = [&](const Pen& pen) -> std::vector<Stroke>& {
    const auto [place, is_new] = places.try_emplace(pen, all.size());
    if (is_new) all.push_back({pen, {}});
    return all[place->second].strokes;
  };
  for (Collected& c : collected_) {
    if (c.gap > 0.0) {
      c.strokes = dashes(stroke_chains(unique_strokes(std::move(c.strokes))), c.dash, c.gap);
    }
    c.strokes = not_blanked(std::move(c.strokes), c.blanked);
    if (c.strokes.empty()) continue;
    std::vector<Stroke>& of_pen = strokes_of_pen(c.pen);
    of_pen.insert(of_pen.end(), c.strokes.begin(), c.strokes.end());
  }
  if (!hatched_) return all;
  if (const std::vector<Stroke> lines = not_blanked(hatched_->strokes(), 0); !lines.empty()) {
    std::vector<Stroke>& of_pen = strokes_of_pen(hatching_pen_);
    of_pen.insert(of_pen.end(), lines.begin(), lines.end());
  }
  return all;
}

}  // namespace displayfile
