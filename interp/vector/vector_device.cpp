#include "interp/vector/vector_device.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "clip/geometry/clip_to_rectangle.h"
#include "clip/geometry/corners.h"
#include "hidden/exact/support_plane.h"
#include "interp/device/picture.h"
#include "interp/text/seen_texts.h"

namespace displayfile {

namespace {

/// Content farther outside of the picture than this many pixels (plus half a line's width) is
/// clipped first: renderers keep coordinates in fixed point, some with 16 bits for whole pixels.
constexpr double kReach = 10'000.0;

/// In pixels: the length up to which a line may be a result of rounding, or is invisible.
constexpr double kNoLength = 1e-6;

/// Longer paths are slow to draw; a solid line may be drawn in parts without loss.
constexpr std::size_t kLongestPath = 1000;

/// True if the lines drawn along the polygon's edges cover its seams.
bool edges_cover_seams(const DrawnPolygon& polygon) {
  return polygon.line.kind == LineStyle::Kind::solid && polygon.line.width >= kSeamWidth &&
         polygon.line.of_kinds.empty() &&
         std::ranges::all_of(polygon.sides, [](std::int32_t side) { return side == op::line; });
}

bool is_short(const Point2& a, const Point2& b) {
  return std::max(std::abs(b.x - a.x), std::abs(b.y - a.y)) < kNoLength;
}

/// True if all points of a run are equal.
bool is_dot(std::span<const Point2> run) {
  return std::ranges::all_of(run, [&](const Point2& p) { return p == run.front(); });
}

bool finite(const Point2& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

}  // namespace

void VectorDevice::Path::clear() {
  points.clear();
  runs.clear();
}

void VectorDevice::Path::add(const Path& other, std::size_t i) {
  start(other.runs[i].closed);
  const auto run = other.run(i);
  points.insert(points.end(), run.begin(), run.end());
}

std::span<const Point2> VectorDevice::Path::run(std::size_t i) const {
  const std::size_t end = i + 1 < runs.size() ? runs[i + 1].first : points.size();
  return std::span(points).subspan(runs[i].first, end - runs[i].first);
}

VectorDevice::VectorDevice(int width, int height, const Background& background,
                           const VectorOptions& options)
    : width_(width),
      height_(height),
      background_(background),
      options_(options),
      disjoint_(options) {
  require_picture_size(width, height);
  require_vector_options(options);
}

namespace {

/// The names of layers by segment: titles, or the segments' names. Equal ones are told apart, from
/// all others too.
std::unordered_map<int, std::string> layer_names(const DisplayFile& display_file) {
  const auto wanted = [](const Segment& segment) {
    return segment.title().empty() ? fmt::format("segment {}", segment.name()) : segment.title();
  };
  std::unordered_map<std::string, int> times;
  for (const Segment& segment : display_file.segments()) ++times[wanted(segment)];
  std::unordered_map<int, std::string> names;
  for (const Segment& segment : display_file.segments()) {
    std::string name = wanted(segment);
    bool is_taken = times[name] > 1;
    while (is_taken) {
      name += fmt::format(" (segment {})", segment.name());
      is_taken = times.contains(name);
    }
    names.emplace(segment.name(), std::move(name));
  }
  return names;
}

}  // namespace

void VectorDevice::take_titles(const DisplayFile& display_file) {
  for (const Segment& segment : display_file.segments()) {
    if (!segment.title().empty()) titles_[segment.name()] = segment.title();
  }
  if (options_.layers) layers_ = layer_names(display_file);
}

std::string_view VectorDevice::title_of(int segment) const {
  const auto titled = titles_.find(segment);
  return titled == titles_.end() ? std::string_view() : titled->second;
}

std::string_view VectorDevice::layer_of(int segment) const {
  const auto layered = layers_.find(segment);
  return layered == layers_.end() ? std::string_view() : layered->second;
}

Point2 VectorDevice::to_page(const Point3& device) const {
  return {device.x * width_, height_ - device.y * height_};
}

bool VectorDevice::near_the_page(const Point2& p, double reach) const {
  return p.x >= -reach && p.x <= width_ + reach && p.y >= -reach && p.y <= height_ + reach;
}

void VectorDevice::begin_segment(int name) {
  if (fills_are_disjoint_) {
    segment_of_disjoint_ = name;
    return;
  }
  finish_lines();
  open_group(name);
}

void VectorDevice::end_segment() {
  if (fills_are_disjoint_) return;
  finish_lines();
  close_group();
}

void VectorDevice::begin_disjoint_fills() {
  finish_lines();
  fills_are_disjoint_ = true;
  segment_of_disjoint_ = 0;
}

void VectorDevice::end_disjoint_fills() {
  fills_are_disjoint_ = false;
  const Figure figure = disjoint_.take_figure();
  if (!figure.regions.empty()) paint_figure(figure);
}

void VectorDevice::fill(const DrawnPolygon& polygon) {
  if (fills_are_disjoint_) {
    if (!find_loop(polygon.vertices)) return;
    return disjoint_.add(path_.points, paint_of(polygon), segment_of_disjoint_, polygon.pick);
  }
  finish_lines();
  if (support_vertices(polygon.vertices).edge_on || !find_loop(polygon.vertices)) return;
  paint_fill(path_, paint_of(polygon), !edges_cover_seams(polygon));
}

/// The polygon's loop must have been found.
FillPaint VectorDevice::paint_of(const DrawnPolygon& polygon) {
  if (fills_with_background_) return {pixel_of(background_.colour)};
  page_.clear();
  for (const Point3& v : polygon.vertices) page_.push_back(to_page(v));
  return paints_.paint_of(polygon, page_, path_.points,
                          fills_are_disjoint_ ? options_.precision : 1.0);
}

/// Converts the polygon to path_, one closed run; false if no part of it is near the page.
bool VectorDevice::find_loop(std::span<const Point3> vertices) {
  path_.clear();
  path_.start(true);
  path_.points.push_back(to_page(vertices.back()));
  for (const Point3& v : vertices.first(vertices.size() - 1)) path_.points.push_back(to_page(v));
  if (!std::ranges::all_of(path_.points, finite)) return false;
  if (!std::ranges::all_of(path_.points,
                           [&](const Point2& p) { return near_the_page(p, kReach); })) {
    // The edges that clipping adds are outside of the picture.
    clip_to_rectangle(path_.points, clipped_,
                      {-kReach, width_ + kReach, -kReach, height_ + kReach});
  }
  return path_.points.size() >= 3;
}

bool VectorDevice::clip_to_neighbourhood(Point2& a, Point2& b, double reach) const {
  if (!finite(a) || !finite(b)) return false;
  if (near_the_page(a, reach) && near_the_page(b, reach)) return true;
  const Rectangle around{-reach, width_ + reach, -reach, height_ + reach};
  const auto part = part_in_rectangle(a, b, around);
  if (!part) return false;
  const auto at = [&, start = a, along = b - a](double t) {
    const Point2 p = start + t * along;  // clamped: far out, rounding is larger than the picture
    return Point2(std::clamp(p.x, around.x_min, around.x_max),
                  std::clamp(p.y, around.y_min, around.y_max));
  };
  if (part->from > 0.0) a = at(part->from);
  if (part->to < 1.0) b = at(part->to);
  return true;
}

void VectorDevice::edges(const DrawnPolygon& polygon) {
  finish_lines();
  const auto& kinds = polygon.kinds;
  if (!std::ranges::any_of(kinds, has_kind)) return paint_edges(polygon, kDrawn);
  for (auto k = kinds.begin(); k != kinds.end(); ++k) {
    if (*k != 0 && std::find(kinds.begin(), k, *k) == k) paint_edges(polygon, *k);
  }
}

/// Paints the drawn edges of these kinds.
void VectorDevice::paint_edges(const DrawnPolygon& polygon, LineKinds kinds) {
  const double reach = kReach + polygon.line.width / 2;
  const auto& v = polygon.vertices;
  const std::size_t n = v.size();
  // A side that is not drawn, or too far out, ends a run; without such a side the path is closed.
  const auto drawn = [&](std::size_t i) {
    const LineKinds of_side = polygon.kinds.empty() ? kDrawn : polygon.kinds[i];
    return polygon.sides[i] == op::line && of_side == kinds;
  };
  const auto is_cut = [&](std::size_t i) { return !polygon.cuts.empty() && polygon.cuts[i] != 0; };
  std::size_t start = 0;
  while (start < n && drawn(start) && near_the_page(to_page(v[start]), reach)) ++start;
  path_.clear();
  if (start == n) {
    path_.start(true);
    path_.points.push_back(to_page(v.back()));
    for (const Point3& p : v.first(n - 1)) path_.points.push_back(to_page(p));
    return paint_with_caps(path_, polygon.line, kinds);
  }
  bool joined = false;  // the next side continues the run
  for (std::size_t k = 1; k <= n; ++k) {
    const std::size_t i = (start + k) % n;
    Point2 a = to_page(v[previous_corner(i, n)]), b = to_page(v[i]);
    const Point2 whole_a = a, whole_b = b;
    if (!drawn(i) || !clip_to_neighbourhood(a, b, reach)) {
      joined = false;
      continue;
    }
    if (!joined || a != whole_a) {
      path_.start(false);
      path_.runs.back().cuts.at_start = is_cut(previous_corner(i, n));
      path_.points.push_back(a);
    }
    path_.points.push_back(b);
    path_.runs.back().cuts.at_end = is_cut(i);
    joined = b == whole_b;
  }
  if (!path_.empty()) paint_with_caps(path_, polygon.line, kinds);
}

void VectorDevice::line(const DrawnLine& line) {
  const double reach = kReach + line.style.width / 2;
  Point2 a = to_page(line.from), b = to_page(line.to);
  const Point2 whole_a = a, whole_b = b;
  if (!clip_to_neighbourhood(a, b, reach)) return finish_path();
  const bool full =
      lines_.points.size() >= kLongestPath && line.style.kind == LineStyle::Kind::solid;
  const bool goes_on = !lines_.empty() && !full && lines_end_ == line.from &&
                       lines_style_ == line.style && lines_kinds_ == line.kinds && a == whole_a;
  // A line entered with no length is a dot. Short ends at a corner, results of rounding, are not
  // drawn, and an outline is closed without them.
  const bool is_dot = Point2(line.from) == Point2(line.to);
  if (!is_dot && is_short(goes_on ? lines_.points.back() : a, b)) {
    if (goes_on) end_line(line);
    return;
  }
  if (!goes_on) {
    finish_path();
    lines_style_ = line.style;
    lines_kinds_ = line.kinds;
    lines_.start(false);
    lines_.runs.back().cuts.at_start = line.cuts.at_start;
    lines_.points.push_back(a);
  }
  if (goes_on && goes_straight_on(b)) {
    lines_.points.back() = b;
  } else {
    lines_.points.push_back(b);
    bend_ = 0.0;
  }
  end_line(line);
  if (b != whole_b) finish_path();
}

namespace {

/// The distance of the middle point from the straight run between the two others, in pixels;
/// infinite if it is not between them.
double off_run(const Point2& from, const Point2& middle, const Point2& to) {
  const Point2 way = to - from, part = middle - from;
  const double along = glm::dot(part, way), squared = glm::dot(way, way);
  if (!(along >= 0.0 && along <= squared)) return std::numeric_limits<double>::infinity();
  return std::abs(way.x * part.y - way.y * part.x) / std::sqrt(squared);
}

/// In pixels: a total bend below this does not show in files.
constexpr double kStraight = 5e-4;

}  // namespace

/// True if the path runs straight through its last point to this one: then that point is redundant.
bool VectorDevice::goes_straight_on(const Point2& to) {
  const std::size_t n = lines_.points.size();
  if (n < 2) return false;
  const double bend = bend_ + off_run(lines_.points[n - 2], lines_.points[n - 1], to);
  if (!(bend <= kStraight)) return false;
  bend_ = bend;
  return true;
}

/// The current path of lines now ends at the end of this line.
void VectorDevice::end_line(const DrawnLine& line) {
  lines_end_ = line.to;
  lines_.runs.back().cuts.at_end = line.cuts.at_end;
}

void VectorDevice::draw_texts(const DisplayFile& display_file) {
  int segment = 0;  // names are 1 or more
  for (const DeviceText& text : seen_texts(display_file, false)) {
    const Point2 anchor = to_page(text.anchor);
    if (!finite(anchor) || !near_the_page(anchor, kReach)) continue;
    if (text.segment != segment) {
      if (segment != 0) end_segment();
      begin_segment(segment = text.segment);
    }
    paint_letters(text, anchor);
  }
  if (segment != 0) end_segment();
}

void VectorDevice::draw_annotation(const DisplayFile& display_file, double millimetre) {
  if (!display_file.has_annotations()) return;
  if (options_.paper) millimetre = 1.0 / fit_on_paper(*options_.paper, width_, height_).pixel;
  int segment = 0;  // names are 1 or more
  for (const AnnotationMark& mark : annotation_marks(display_file, {width_, height_, millimetre})) {
    if (mark.segment != segment) {
      if (segment != 0) end_segment();
      begin_segment(segment = mark.segment);
    }
    paint_mark(mark);
  }
  if (segment != 0) end_segment();
}

void VectorDevice::paint_mark(const AnnotationMark& mark) {
  using enum AnnotationMark::Kind;
  if (mark.kind == text) {
    return paint_letters(mark.text, to_page(mark.text.anchor));
  }
  path_.clear();
  path_.start(mark.kind != AnnotationMark::Kind::line || mark.closed);
  for (const Point2& p : mark.points) path_.points.emplace_back(p.x, height_ - p.y);
  if (mark.kind == AnnotationMark::Kind::line) {
    const LineStyle style{LineStyle::Kind::solid, mark.colour, mark.width};
    return paint_lines(path_, style, kDrawn, LineCap::butt);
  }
  if (mark.kind == blank && background_.kind == Background::Kind::none) return;
  paint_fill(path_, {pixel_of(mark.kind == blank ? background_.colour : mark.colour)}, false);
}

/// Paints letters as paths, or in a font.
void VectorDevice::paint_letters(const DeviceText& text, const Point2& anchor) {
  const double size = text.style.size * height_;
  const auto letters = letter_paths(options_.lettering, text, anchor, size);
  if (!letters) return paint_text(text, anchor, size);
  for (const LetterPaths::Letter& letter : letters->letters) {
    path_.clear();
    for (const auto& points : letter) {
      path_.start(letters->are_outlines);
      path_.points.insert(path_.points.end(), points.begin(), points.end());
    }
    if (path_.empty()) continue;
    if (letters->are_outlines) {
      paint_fill(path_, {pixel_of(letters->stroke.colour)}, false);
    } else {
      paint_lines(path_, letters->stroke, kDrawn, LineCap::round);
    }
  }
}

void VectorDevice::finish_lines() {
  finish_path();
  finish_discs();
}

void VectorDevice::finish_path() {
  if (lines_.empty()) return;
  if (lines_.points.size() > 3 && lines_.points.front() == lines_.points.back()) {
    lines_.points.pop_back();  // the last line closes the run: its corner is joined too
    lines_.runs.front().closed = true;
    std::vector<Point2>& points = lines_.points;
    const bool is_solid = lines_style_.kind == LineStyle::Kind::solid;  // a dash begins there
    if (is_solid && off_run(points.back(), points[0], points[1]) <= kStraight) {
      points.erase(points.begin());
    }
  }
  paint_with_caps(lines_, lines_style_, lines_kinds_);
  lines_.clear();
}

/// Paints runs with the caps of their ends. A cut end has none: a run with one cut end has butt
/// caps, and at its other end a disc, half of which is the cap.
void VectorDevice::paint_with_caps(const Path& path, const LineStyle& style, LineKinds kinds) {
  if (style != discs_style_) finish_discs();
  discs_style_ = style;
  if (path.runs.size() == 1 && is_dot(path.run(0))) {
    return paint_lines(path, style, kinds, LineCap::square);
  }
  if (style.kind == LineStyle::Kind::dashed) return paint_lines(path, style, kinds, LineCap::butt);
  uncut_.clear();
  cut_.clear();
  for (std::size_t i = 0; i < path.runs.size(); ++i) {
    const LineCuts cuts = path.runs[i].closed ? LineCuts() : path.runs[i].cuts;
    (cuts.any() ? cut_ : uncut_).add(path, i);
    if (cuts.at_start != cuts.at_end) add_disc(path.run(i), cuts, kinds);
  }
  if (!uncut_.empty()) paint_lines(uncut_, style, kinds, LineCap::round);
  if (!cut_.empty()) paint_lines(cut_, style, kinds, LineCap::butt);
}

/// Adds a disc at the end that is not cut, unless it would reach over the cut end.
void VectorDevice::add_disc(std::span<const Point2> run, const LineCuts& cuts, LineKinds kinds) {
  if (glm::distance(run.front(), run.back()) < discs_style_.width / 2) return;
  Path& discs = discs_[kinds];
  discs.start(false);
  discs.points.insert(discs.points.end(), 2, cuts.at_start ? run.back() : run.front());
}

void VectorDevice::finish_discs() {
  for (const auto& [kinds, discs] : discs_) {
    paint_lines(discs, discs_style_, kinds, LineCap::round);
  }
  discs_.clear();
}

}  // namespace displayfile
