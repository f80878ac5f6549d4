#include "hidden/lines/perimeter_polyline.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "hidden/exact/line_parameter.h"
#include "hidden/exact/orientation.h"

namespace displayfile {

namespace {

// Numbers of supports at which a column drops hidden ones: low at first, so that a floor is known
// early.
constexpr std::uint32_t kFirstSupports = 4, kFewSupports = 8;

/// True if the error of its height at some column may exceed any margin.
bool is_steep(const PerimeterPolyline::Line& line) {
  constexpr double kSteep = 1e5;
  return std::abs(line.slope) > kSteep || line.from.x == line.to.x;
}

}  // namespace

PerimeterPolyline::PerimeterPolyline(Bound bound, const GridSurface& surface,
                                     const Verticals& verticals, const SurfaceColumns& columns,
                                     const SurfaceColumns::Range& range)
    : surface_(surface),
      verticals_(verticals),
      layout_(columns),
      range_(range),
      sign_(bound == Bound::upper ? 1.0 : -1.0),
      margin_(columns.margin()) {
  constexpr double kNoFloor = -std::numeric_limits<double>::infinity();
  columns_.assign(range.end - range.first, {{}, kFirstSupports, kNoFloor});
}

/// The line, mirrored for the lower perimeter, which is then an upper one.
PerimeterPolyline::Line PerimeterPolyline::upright(const Line& line) const {
  return {line.p,
          line.q,
          line.first,
          line.last,
          {line.from.x, sign_ * line.from.y},
          {line.to.x, sign_ * line.to.y},
          sign_ * line.slope};
}

PerimeterPolyline::Support PerimeterPolyline::in_column(std::uint32_t column,
                                                        const Line& line) const {
  const double low = std::max(line.from.x, layout_.left(column));
  const double high = std::max(low, std::min(line.to.x, layout_.left(column + 1)));
  const bool steep = is_steep(line);
  const double at_low = steep ? line.from.y : line.height_at(low);
  const double at_high = steep ? line.to.y : line.height_at(high);
  return {line, low, high, std::min(at_low, at_high), std::max(at_low, at_high)};
}

/// True if all of one part lies below the other by more than the error.
inline bool PerimeterPolyline::is_within(const Support& one, const Support& other) const {
  return one.lowest < other.highest && other.low_x <= one.low_x && one.high_x <= other.high_x &&
         other.side.height_at(one.low_x) > one.side.height_at(one.low_x) + margin_ &&
         other.side.height_at(one.high_x) > one.side.height_at(one.high_x) + margin_;
}

/// True if all of the line within the range is below the floors of its columns.
bool PerimeterPolyline::is_below_floors(const Line& line) const {
  const double highest =
      (sign_ > 0.0 ? std::max(line.from.y, line.to.y) : -std::min(line.from.y, line.to.y)) +
      margin_;
  const auto [first, last] = in_range(line);
  for (std::uint32_t k = first; k <= last; ++k) {
    if (highest >= column(k).floor) return false;
  }
  return true;
}

/// True if in each of the line's columns a side of the perimeter lies above it.
bool PerimeterPolyline::is_covered(const Line& line) const {
  for (std::uint32_t k = line.first; k <= line.last; ++k) {
    const Support part = in_column(k, line);
    const auto covers = [&](const Support& support) { return is_within(part, support); };
    if (!std::ranges::any_of(column(k).supports, covers)) return false;
  }
  return true;
}

bool PerimeterPolyline::find_within(const Line& along, bool runs_left,
                                    std::vector<PartOfLine>& parts) const {
  parts.clear();
  const auto is_all = [&] {
    parts.assign(1, {0.0, 1.0});
    return false;
  };
  const bool all_known = along.first >= range_.first && along.last < range_.end;
  if (all_known && is_below_floors(along)) return is_all();
  const Line line = upright(along);
  if (all_known && is_covered(line)) return is_all();
  const double lowest = std::min(line.from.y, line.to.y) - margin_;
  const auto [first, last] = in_range(line);
  bool in_line = false;
  for (std::uint32_t k = first; k <= last; ++k) {
    for (const Support& support : column(k).supports) {
      if (support.highest < lowest || is_clear_of(line, support.side)) continue;
      if (is_in_line(line, support.side)) {
        in_line = true;
        continue;
      }
      find_within_one(line, runs_left, support.side, parts);
      if (!parts.empty() && parts.back().from == 0.0 && parts.back().to == 1.0) return is_all();
    }
  }
  unite(parts);
  return in_line;
}

/// True if no part of the line is below the side, by more than the error except at shared ends.
bool PerimeterPolyline::is_clear_of(const Line& line, const Line& side) const {
  const double from = std::max(line.from.x, side.from.x);
  const double to = std::min(line.to.x, side.to.x);
  const bool touch = line.p == side.q || line.q == side.p;
  if (to < from || touch) return true;
  if (is_steep(line) || is_steep(side)) return false;
  return (line.p == side.p || line.height_at(from) > side.height_at(from) + margin_) &&
         (line.q == side.q || line.height_at(to) > side.height_at(to) + margin_);
}

/// True if both coincide in the picture along more than a point, up to rounding and reach.
bool PerimeterPolyline::is_in_line(const Line& line, const Line& side) const {
  const double from = std::max(line.from.x, side.from.x);
  const double to = std::min(line.to.x, side.to.x);
  if (to - from <= margin_) return false;
  if (!is_steep(line) && !is_steep(side)) {
    const auto apart = [&](double x) { return std::abs(line.height_at(x) - side.height_at(x)); };
    if (apart(from) > margin_ || apart(to) > margin_) return false;
  }
  const Point2 p(surface_.point(side.p)), way = Point2(surface_.point(side.q)) - p;
  const Point2 l(surface_.point(line.p)), along = Point2(surface_.point(line.q)) - l;
  const auto off = [](const Point2& point, const Point2& origin, const Point2& direction) {
    const Point2 a = point - origin;
    return std::abs(direction.x * a.y - direction.y * a.x) / glm::length(direction);
  };
  const double at_from = side.from.x <= line.from.x ? off(l, p, way) : off(p, l, along);
  const double at_to = side.to.x >= line.to.x ? off(l + along, p, way) : off(p + way, l, along);
  return at_from <= layout_.in_line() && at_to <= layout_.in_line();
}

/// Adds the part of the line that the side puts within the perimeter, where both have columns. The
/// line's parameters start at its first point, which is the right one if `runs_left`.
void PerimeterPolyline::find_within_one(const Line& line, bool runs_left, const Line& side,
                                        std::vector<PartOfLine>& parts) const {
  const Point2 l(surface_.point(line.p)), r(surface_.point(line.q));
  const Point2 p(surface_.point(side.p)), q(surface_.point(side.q));
  // -1 at an end: the line is within the perimeter there.
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
  if (is_below_floors(side)) return;
  const Line line = upright(side);
  const auto [first, last] = in_range(line);
  for (std::uint32_t k = first; k <= last; ++k) {
    Column& here = column(k);
    const Support support = in_column(k, line);
    if (support.highest + margin_ < here.floor) continue;
    std::vector<Support>& supports = here.supports;
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
    if (supports.size() < here.drop_at) continue;
    drop_what_is_within(supports);
    here.drop_at = std::max(kFewSupports, 2 * static_cast<std::uint32_t>(supports.size()));
    here.floor = floor_of(k);
  }
}

/// Drops supports that lie below the others combined. Two equally high ones do not drop each other.
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

/// The lowest of the column's supports, if they span the column; otherwise the known floor.
double PerimeterPolyline::floor_of(std::uint32_t number) {
  const auto& [supports, drop_at, known] = column(number);
  within_.clear();
  double lowest = std::numeric_limits<double>::infinity();
  for (const Support& support : supports) {
    within_.push_back({support.low_x, support.high_x});
    lowest = std::min(lowest, support.lowest);
  }
  unite(within_);
  const bool all = within_.size() == 1 && within_[0].from <= layout_.left(number) &&
                   within_[0].to >= layout_.left(number + 1);
  return all ? std::max(known, lowest - margin_) : known;
}

}  // namespace displayfile
