#include "hidden/lines/perimeter_polyline.h"

#include <algorithm>

#include "hidden/exact/line_parameter.h"
#include "hidden/exact/orientation.h"

namespace displayfile {

namespace {

constexpr std::uint32_t kFewSupports = 8;

}  // namespace

PerimeterPolyline::PerimeterPolyline(Bound bound, const GridSurface& surface,
                                     const Verticals& verticals)
    : surface_(surface), verticals_(verticals), sign_(bound == Bound::upper ? 1.0 : -1.0) {
  Point2 low = verticals.in_columns(0), high = low;
  for (std::uint32_t k = 0; k < surface.points(); ++k) {
    const Point2& at = verticals.in_columns(k);
    low = {std::min(low.x, at.x), std::min(low.y, at.y)};
    high = {std::max(high.x, at.x), std::max(high.y, at.y)};
  }
  // A column is as wide as a side, on the average.
  double widths = 0.0;
  std::uint32_t sides = 0;
  const auto add = [&](std::uint32_t a, std::uint32_t b) {
    widths += std::abs(verticals.in_columns(a).x - verticals.in_columns(b).x);
    ++sides;
  };
  for (std::uint32_t j = 0; j <= surface.rows(); ++j) {
    for (std::uint32_t i = 0; i <= surface.columns(); ++i) {
      if (i > 0) add(surface.number(i - 1, j), surface.number(i, j));
      if (j > 0) add(surface.number(i, j - 1), surface.number(i, j));
    }
  }
  const double most = 4.0 * (surface.columns() + surface.rows()) + 16.0;
  const double count = std::clamp((high.x - low.x) * sides / widths, 1.0, most);
  left_ = low.x;
  width_ = (high.x - low.x) / std::floor(count);
  margin_ = 1e-9 * (std::abs(low.y) + std::abs(high.y) + high.x - low.x);
  columns_.resize(static_cast<std::size_t>(count));
  drop_at_.assign(columns_.size(), kFewSupports);
}

std::uint32_t PerimeterPolyline::column_of(double x) const {
  const double column = (x - left_) / width_;
  return static_cast<std::uint32_t>(
      std::clamp(column, 0.0, static_cast<double>(columns_.size() - 1)));
}

PerimeterPolyline::Line PerimeterPolyline::line_between(const Verticals& verticals, std::uint32_t a,
                                                        std::uint32_t b) {
  Point2 from = verticals.in_columns(a), to = verticals.in_columns(b);
  if (from.x > to.x) {
    std::swap(a, b);
    std::swap(from, to);
  }
  const double width = to.x - from.x;
  return {a, b, from, to, width > 0.0 ? (to.y - from.y) / width : 0.0};
}

/// Upside down for the lower perimeter, which so is an upper one.
PerimeterPolyline::Line PerimeterPolyline::upright(const Line& line) const {
  return {line.p,
          line.q,
          {line.from.x, sign_ * line.from.y},
          {line.to.x, sign_ * line.to.y},
          sign_ * line.slope};
}

PerimeterPolyline::Support PerimeterPolyline::in_column(std::uint32_t column,
                                                        const Line& line) const {
  const double low = std::max(line.from.x, left_ + column * width_);
  const double high = std::max(low, std::min(line.to.x, left_ + (column + 1) * width_));
  const double at_low = line.height_at(low), at_high = line.height_at(high);
  return {line, low, high, std::min(at_low, at_high), std::max(at_low, at_high)};
}

void PerimeterPolyline::find_within(const Line& along, bool runs_left,
                                    std::vector<PartOfLine>& parts) const {
  parts.clear();
  const Line line = upright(along);
  const std::uint32_t end = column_of(line.to.x + margin_);
  for (std::uint32_t k = column_of(line.from.x - margin_); k <= end; ++k) {
    const double lowest = in_column(k, line).lowest - margin_;
    for (const Support& support : columns_[k]) {
      if (support.highest < lowest) continue;
      find_within_one(line, runs_left, support.side, parts);
      if (!parts.empty() && parts.back().from == 0.0 && parts.back().to == 1.0) {
        parts = {{0.0, 1.0}};
        return;
      }
    }
  }
  unite(parts);
}

/// What of the line is beyond the side, where both have columns. The line's parameters are those
/// from its first point, which is the right one if it runs left.
void PerimeterPolyline::find_within_one(const Line& line, bool runs_left, const Line& side,
                                        std::vector<PartOfLine>& parts) const {
  if (std::max(line.from.x, side.from.x) > std::min(line.to.x, side.to.x)) return;
  const Point2 l(surface_.point(line.p)), r(surface_.point(line.q));
  const Point2 p(surface_.point(side.p)), q(surface_.point(side.q));
  // -1: the line is within the perimeter there.
  const int beyond = sign_ > 0.0 ? 1 : -1;
  const bool from_line = side.from.x <= line.from.x, to_line = side.to.x >= line.to.x;
  const int at_from = line.p == side.p ? 0
                      : from_line      ? beyond * orientation(p, q, l)
                                       : -beyond * orientation(l, r, p);
  const int at_to = line.q == side.q ? 0
                    : to_line        ? beyond * orientation(p, q, r)
                                     : -beyond * orientation(l, r, q);
  if (at_from >= 0 && at_to >= 0) return;
  const Point2 &a = runs_left ? r : l, &b = runs_left ? l : r;
  const auto part_of = [&](bool is_end_of_line, bool is_left, int of_end, const Point2& end) {
    if (is_end_of_line) return is_left == runs_left ? 1.0 : 0.0;
    return of_end == 0 ? point_parameter(a, b, end) : verticals_.part_at(a, b, end);
  };
  const double crossing = at_from > 0 || at_to > 0 ? crossing_parameter(a, b, p, q) : 0.0;
  const double from = at_from > 0 ? crossing : part_of(from_line, true, at_from, p);
  const double to = at_to > 0 ? crossing : part_of(to_line, false, at_to, q);
  if (from != to) parts.push_back({std::min(from, to), std::max(from, to)});
}

void PerimeterPolyline::extend(const Line& side) {
  const Line line = upright(side);
  const std::uint32_t end = column_of(line.to.x);
  for (std::uint32_t k = column_of(line.from.x); k <= end; ++k) {
    std::vector<Support>& supports = columns_[k];
    const Support support = in_column(k, line);
    bool is_needed = true;
    for (std::size_t s = 0; s < supports.size();) {
      if (is_within(support, supports[s])) {
        is_needed = false;
        break;
      }
      if (is_within(supports[s], support)) {
        supports[s] = supports.back();
        supports.pop_back();
      } else {
        ++s;
      }
    }
    if (!is_needed) continue;
    supports.push_back(support);
    if (supports.size() < drop_at_[k]) continue;
    drop_what_is_within(supports);
    drop_at_[k] = std::max(kFewSupports, 2 * static_cast<std::uint32_t>(supports.size()));
  }
}

/// True if all of one part lies below the other by more than any error.
bool PerimeterPolyline::is_within(const Support& one, const Support& other) const {
  return one.lowest < other.highest && other.low_x <= one.low_x && one.high_x <= other.high_x &&
         other.side.height_at(one.low_x) > one.side.height_at(one.low_x) + margin_ &&
         other.side.height_at(one.high_x) > one.side.height_at(one.high_x) + margin_;
}

/// Drops those that lie below others together. Two that are equally high do not drop each other.
void PerimeterPolyline::drop_what_is_within(std::vector<Support>& supports) {
  for (std::size_t k = 0; k < supports.size();) {
    const Support& one = supports[k];
    within_.clear();
    for (const Support& other : supports) {
      const double from = std::max(one.low_x, other.low_x);
      const double to = std::min(one.high_x, other.high_x);
      if (from > to) continue;
      const auto above = [&](double x) {
        return other.side.height_at(x) - one.side.height_at(x) - margin_;
      };
      const double at_from = above(from), at_to = above(to);
      if (at_from <= 0.0 && at_to <= 0.0) continue;
      const double crossing = from + (to - from) * (at_from / (at_from - at_to));
      within_.push_back({at_from > 0.0 ? from : crossing, at_to > 0.0 ? to : crossing});
    }
    unite(within_);
    const bool all =
        within_.size() == 1 && within_[0].from <= one.low_x && within_[0].to >= one.high_x;
    if (all) {
      supports[k] = supports.back();
      supports.pop_back();
    } else {
      ++k;
    }
  }
}

}  // namespace displayfile
