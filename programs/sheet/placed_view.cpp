#include "programs/sheet/placed_view.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "programs/sheet/chained_lines.h"
#include "programs/sheet/unique_lines.h"

namespace displayfile {

namespace {

constexpr double kLeastLength = 1e-6;  // of a line, or across a cut face

/// False where a plane touches a curved face: there rounding may leave a loop with nothing in it.
bool has_area(const std::vector<Point2>& loop) {
  double twice_area = 0.0, around = 0.0;
  Point2 from = loop.back();
  for (const Point2& to : loop) {
    const Point2 a = from - loop.front(), b = to - loop.front();
    twice_area += a.x * b.y - b.x * a.y;
    around += glm::distance(from, to);
    from = to;
  }
  return std::abs(twice_area) > kLeastLength * around;
}

void add_hatching(const PartDrawing& view, const ViewPlace& place,
                  const std::vector<BodyHatching>& hatching, DrawingSheet& sheet) {
  std::map<std::uint32_t, std::vector<std::vector<Point2>>> loops_of_group;
  for (const PartDrawing::CutLoop& loop : view.cut) {
    auto placed = place.on_paper(view, loop.points);
    if (!has_area(placed)) continue;
    loops_of_group[hatching[loop.body].group].push_back(std::move(placed));
  }
  std::vector<std::vector<Point2>> before;
  for (const auto& polygon : view.before) before.push_back(place.on_paper(view, polygon));
  for (const auto& [group, loops] : loops_of_group) {
    for (const auto& [from, to] : hatching_lines(loops, before, hatching[group])) {
      if (glm::distance(from, to) <= kLeastLength) continue;
      sheet.lines.push_back({SheetLayer::hatch, {from, to}});
    }
  }
}

/// True if a point lies within loops, by their winding number.
bool is_within(const std::vector<std::vector<Point2>>& loops, const Point2& p) {
  int winding = 0;
  for (const auto& loop : loops) {
    Point2 from = loop.back();
    for (const Point2& to : loop) {
      const double turn = (to.x - from.x) * (p.y - from.y) - (p.x - from.x) * (to.y - from.y);
      if (from.y <= p.y && to.y > p.y && turn > 0.0) ++winding;
      if (from.y > p.y && to.y <= p.y && turn < 0.0) --winding;
      from = to;
    }
  }
  return winding != 0;
}

/// Adds the parts of a line outside loops.
void add_outside(const PartDrawing::Line& line, const std::vector<std::vector<Point2>>& loops,
                 std::vector<PartDrawing::Line>& lines) {
  const Point2 along = line.to - line.from;
  std::vector<double> cuts{0.0, 1.0};  // in parts of the line
  for (const auto& loop : loops) {
    Point2 from = loop.back();
    for (const Point2& to : loop) {
      const double a = along.x * (from.y - line.from.y) - along.y * (from.x - line.from.x);
      const double b = along.x * (to.y - line.from.y) - along.y * (to.x - line.from.x);
      if ((a < 0.0) != (b < 0.0)) {
        const Point2 crossing = from + a / (a - b) * (to - from);
        const double at = glm::dot(crossing - line.from, along) / glm::dot(along, along);
        if (at > 0.0 && at < 1.0) cuts.push_back(at);
      }
      from = to;
    }
  }
  std::ranges::sort(cuts);
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    if (is_within(loops, line.from + 0.5 * (cuts[k] + cuts[k + 1]) * along)) continue;
    const Point2 from = line.from + cuts[k] * along, to = line.from + cuts[k + 1] * along;
    if (glm::distance(from, to) > kLeastLength) lines.push_back({from, to, false});
  }
}

/// Centre lines extend beyond the outline by 3 mm, by less where they are short. A line is drawn as
/// two from its middle, so that crosses fall on dashes and not in gaps. Lines behind a section are
/// hidden by the cut faces.
void add_centre_lines(const PartDrawing& view, const ViewPlace& place, DrawingSheet& sheet) {
  constexpr double kLeastBeyond = 1.0, kBeyond = 3.0;
  std::vector<std::vector<Point2>> hiding;
  for (const PartDrawing::CutLoop& loop : view.cut) {
    hiding.push_back(place.on_paper(view, loop.points));
  }
  for (const auto& polygon : view.before) hiding.push_back(place.on_paper(view, polygon));
  std::vector<PartDrawing::Line> lines;
  for (const PartDrawing::CentreLine& line : view.centre_lines) {
    const Point2 from = place.on_paper(view, line.from), to = place.on_paper(view, line.to);
    const double length = glm::distance(from, to);
    if (length <= kLeastLength) continue;
    const Point2 beyond = std::clamp(0.5 * length, kLeastBeyond, kBeyond) / length * (to - from);
    const PartDrawing::Line whole{from - beyond, to + beyond, false};
    line.is_behind ? add_outside(whole, hiding, lines) : lines.push_back(whole);
  }
  for (const PartDrawing::Line& line : unique_lines(lines)) {
    const Point2 middle = 0.5 * (line.from + line.to);
    sheet.lines.push_back({SheetLayer::centre, {middle, line.from}});
    sheet.lines.push_back({SheetLayer::centre, {middle, line.to}});
  }
}

}  // namespace

std::vector<Point2> ViewPlace::on_paper(const PartDrawing& view,
                                        const std::vector<Point2>& points) const {
  std::vector<Point2> placed;
  placed.reserve(points.size());
  for (const Point2& p : points) placed.push_back(on_paper(view, p));
  return placed;
}

void add_view(const PartDrawing& view, const ViewPlace& place,
              const std::vector<BodyHatching>& hatching, DrawingSheet& sheet) {
  std::vector<PartDrawing::Line> lines;
  for (const PartDrawing::Line& line : view.lines) {
    const Point2 from = place.on_paper(view, line.from), to = place.on_paper(view, line.to);
    if (line.is_alone && glm::distance(from, to) < pen_of(SheetLayer::visible).width) continue;
    lines.push_back({from, to, line.hidden});
  }
  for (const PartDrawing::CutLoop& loop : view.cut) {
    const std::vector<Point2> placed = place.on_paper(view, loop.points);
    if (view.has_outlines || !has_area(placed)) continue;
    Point2 from = placed.back();
    for (const Point2& to : placed) lines.push_back({std::exchange(from, to), to, false});
  }
  for (auto& line : chained_lines(unique_lines(lines))) sheet.lines.push_back(std::move(line));
  add_hatching(view, place, hatching, sheet);
  add_centre_lines(view, place, sheet);
}

void remove_covered_centre_lines(DrawingSheet& sheet) {
  constexpr double kSamePlace = 0.01;  // mm
  const auto lies_along = [](const Point2& p, const DrawingSheet::Line& line) {
    const Point2 along = line.points[1] - line.points[0];
    const Point2 to_p = p - line.points[0];
    const double length = glm::length(along), place = glm::dot(to_p, along) / length;
    const double aside = (along.x * to_p.y - along.y * to_p.x) / length;
    return std::abs(aside) < kSamePlace && place > -kSamePlace && place < length + kSamePlace;
  };
  std::vector<DrawingSheet::Line> cutting;
  std::ranges::copy_if(sheet.lines, std::back_inserter(cutting),
                       [](const auto& line) { return line.layer == SheetLayer::cutting; });
  std::erase_if(sheet.lines, [&](const DrawingSheet::Line& line) {
    if (line.layer != SheetLayer::centre) return false;
    return std::ranges::any_of(cutting, [&](const DrawingSheet::Line& over) {
      return lies_along(line.points[0], over) && lies_along(line.points[1], over);
    });
  });
}

}  // namespace displayfile
