#include "interp/vector/pens/hatching.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>

#include "clip/geometry/clip_to_rectangle.h"
#include "interp/vector/pens/sheet_point.h"

namespace displayfile {

namespace {

/// Parts of a line closer than this many millimetres are merged: no pen leaves such a gap.
constexpr double kClosesGaps = 0.002;

/// The darkness from which a line of the grid is drawn: the bits of its number in reverse order, as
/// a fraction. So at half of the darkness every other line is drawn, at a quarter every fourth; in
/// between the gaps are as even as they can be while drawn lines stay.
double threshold_of(std::int32_t line) {
  constexpr int kBits = 6;
  auto bits = static_cast<std::uint32_t>(line);
  std::uint32_t reversed = 0;
  for (int k = 0; k < kBits; ++k, bits >>= 1) reversed = 2 * reversed + (bits & 1u);
  return (reversed + 0.5) / (1 << kBits);
}

}  // namespace

double Darkness::luma(const Colour& colour) {
  return 0.2126 * colour.r + 0.7152 * colour.g + 0.0722 * colour.b;
}

Darkness::Darkness(const Colour& paper, const Colour& pen) : paper_(luma(paper)) {
  const double contrast = paper_ - luma(pen);
  scale_ = contrast != 0.0 ? 1.0 / contrast : 0.0;
}

HatchLines::HatchLines(double spacing, double degrees, const Rectangle& frame)
    : spacing_(spacing), frame_(frame) {
  // Quarter turns exactly: lines of level and upright figures lie as these do.
  const double turned = std::remainder(degrees, 180.0);
  const double radians = turned * std::numbers::pi / 180.0;
  cosine_ = std::abs(turned) == 90.0 ? 0.0 : std::cos(radians);
  sine_ = turned == 0.0 ? 0.0 : -std::sin(radians);  // y runs down
  bool first = true;
  for (const double x : {frame.x_min, frame.x_max}) {
    for (const double y : {frame.y_min, frame.y_max}) {
      const double v = y * cosine_ - x * sine_;
      low_ = first ? v : std::min(low_, v);
      high_ = first ? v : std::max(high_, v);
      first = false;
    }
  }
}

/// Processes each side from its lower end, so that two polygons that share it cross a line at the
/// same place, bit for bit.
void HatchLines::add_crossings(const Point2& a, const Point2& b, double dark_a, double dark_b) {
  const auto along = [&](const Point2& p) { return p.x * cosine_ + p.y * sine_; };
  const auto across_of = [&](const Point2& p) { return p.y * cosine_ - p.x * sine_; };
  double va = across_of(a), vb = across_of(b);
  double ua = along(a), ub = along(b);
  if (std::tie(vb, ub) < std::tie(va, ua)) {
    std::swap(va, vb);
    std::swap(ua, ub);
    std::swap(dark_a, dark_b);
  }
  const auto first_line_at = [&](double v) { return std::ceil(v / spacing_ - 0.5); };
  // One line more on either side, for rounding: the comparison with its place decides.
  const double from = first_line_at(std::max(va, low_)) - 1.0;
  const double to = first_line_at(std::min(vb, high_)) + 1.0;
  for (double k = from; k <= to; ++k) {
    const auto line = static_cast<std::int32_t>(k);
    const double v = across(line);
    if (!(va < v && v <= vb)) continue;
    const double share = (v - va) / (vb - va);
    crossings_.push_back({line, ua + share * (ub - ua), dark_a + share * (dark_b - dark_a)});
  }
}

void HatchLines::add(std::span<const Point2> polygon, std::span<const double> darkness) {
  crossings_.clear();
  for (std::size_t i = 0, before = polygon.size() - 1; i < polygon.size(); before = i++) {
    add_crossings(polygon[before], polygon[i], darkness[before], darkness[i]);
  }
  std::ranges::sort(crossings_, [](const Crossing& a, const Crossing& b) {
    return std::tie(a.line, a.at) < std::tie(b.line, b.at);
  });
  const std::uint32_t order = next_order_++;
  for (std::size_t i = 0; i + 1 < crossings_.size(); i += 2) {
    const Crossing &a = crossings_[i], &b = crossings_[i + 1];
    if (a.at < b.at) spans_.push_back({a.line, order, a.at, b.at, a.darkness, b.darkness});
  }
}

/// Adds the part of [from, to] in a span that is dark enough.
void HatchLines::ink(const Span& span, double from, double to) {
  const double change = (span.dark_to - span.dark_from) / (span.to - span.from);
  const double dark_from = span.dark_from + change * (from - span.from);
  const double dark_to = span.dark_from + change * (to - span.from);
  if (dark_from < threshold_ && dark_to < threshold_) return;
  const double turns = from + (threshold_ - dark_from) / (dark_to - dark_from) * (to - from);
  if (dark_from < threshold_) from = std::clamp(turns, from, to);
  if (dark_to < threshold_) to = std::clamp(turns, from, to);
  if (!inked_.empty() && from - inked_.back().to <= kClosesGaps) {
    inked_.back().to = std::max(inked_.back().to, to);
  } else {
    inked_.push_back({from, to});
  }
}

/// The fill added last covers those that it overlaps: sweeps along the line.
void HatchLines::find_nearest_of_overlapping(std::span<const Span> spans) {
  struct Event {
    double at;
    std::uint32_t span;
    bool opens;
  };
  std::vector<Event> events;
  for (std::uint32_t k = 0; k < spans.size(); ++k) {
    events.push_back({spans[k].from, k, true});
    events.push_back({spans[k].to, k, false});
  }
  std::ranges::sort(events, [](const Event& a, const Event& b) {
    return std::tie(a.at, a.span, a.opens) < std::tie(b.at, b.span, b.opens);
  });
  std::set<std::pair<std::uint32_t, std::uint32_t>> here;
  double since = 0.0;
  for (std::size_t k = 0; k < events.size();) {
    const double at = events[k].at;
    if (!here.empty() && since < at) ink(spans[here.rbegin()->second], since, at);
    for (; k < events.size() && events[k].at == at; ++k) {
      const auto& [_, span, opens] = events[k];
      const std::pair key(spans[span].order, span);
      opens ? void(here.insert(key)) : void(here.erase(key));
    }
    since = at;
  }
}

/// The spans of one line, from left to right.
void HatchLines::find_inked(std::span<const Span> spans) {
  inked_.clear();
  line_ = spans.front().line;
  threshold_ = threshold_of(line_);
  bool overlap = false;
  for (std::size_t i = 1; i < spans.size() && !overlap; ++i) {
    overlap = spans[i].from < spans[i - 1].to;
  }
  if (overlap) return find_nearest_of_overlapping(spans);
  for (const Span& span : spans) ink(span, span.from, span.to);
}

void HatchLines::add_strokes(double shortest, std::vector<Stroke>& strokes) const {
  const double v = across(line_);
  for (const Part& part : inked_) {
    const auto point = [&](double u) {
      return Point2(u * cosine_ - v * sine_, u * sine_ + v * cosine_);
    };
    const Point2 a = point(part.from), b = point(part.to);
    const auto inside = part_in_rectangle(a, b, frame_);
    if (!inside || (inside->to - inside->from) * (part.to - part.from) < shortest) continue;
    const SheetPoint from = sheet_point(a + inside->from * (b - a));
    const SheetPoint to = sheet_point(a + inside->to * (b - a));
    if (from != to) strokes.push_back({from, to});
  }
}

std::vector<Stroke> HatchLines::strokes(double shortest) {
  std::ranges::sort(spans_, [](const Span& a, const Span& b) {
    return std::tie(a.line, a.from, a.to, a.order) < std::tie(b.line, b.from, b.to, b.order);
  });
  std::vector<Stroke> strokes;
  for (std::size_t from = 0; from < spans_.size();) {
    std::size_t to = from + 1;
    while (to < spans_.size() && spans_[to].line == spans_[from].line) ++to;
    find_inked(std::span(spans_).subspan(from, to - from));
    add_strokes(shortest, strokes);
    from = to;
  }
  return strokes;
}

}  // namespace displayfile
