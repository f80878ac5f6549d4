#include "programs/sheet/unique_lines.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>
#include <utility>

namespace displayfile {

namespace {

constexpr double kSameAngle = 1e-9;  // radians
constexpr double kSamePlace = 1e-6;  // mm

struct PlacedLine {
  Point2 from, to;  // in the direction of the angle
  double angle, offset, begin = 0.0, end = 0.0;
  bool hidden;
};

PlacedLine placed(const PartDrawing::Line& line) {
  PlacedLine out{line.from, line.to, 0.0, 0.0, 0.0, 0.0, line.hidden};
  const Point2 d = line.to - line.from;
  if (d.x < 0.0 || (d.x == 0.0 && d.y < 0.0)) std::swap(out.from, out.to);
  out.angle = std::atan2(out.to.y - out.from.y, out.to.x - out.from.x);
  // A nearly upright line may point down.
  if (out.angle < -std::numbers::pi / 2.0 + kSameAngle) {
    std::swap(out.from, out.to);
    out.angle += std::numbers::pi;
  }
  return out;
}

/// Appends the union of the visible pieces of one line, then the hidden ones less that.
void unite(std::span<PlacedLine> group, std::vector<PartDrawing::Line>& out) {
  std::ranges::sort(group, {}, &PlacedLine::begin);
  std::vector<PlacedLine> seen;
  for (const bool hidden : {false, true}) {
    std::vector<PlacedLine> united;
    for (const PlacedLine& line : group) {
      if (line.hidden != hidden) continue;
      if (!united.empty() && line.begin <= united.back().end + kSamePlace) {
        if (line.end > united.back().end) {
          united.back().end = line.end;
          united.back().to = line.to;
        }
      } else {
        united.push_back(line);
      }
    }
    for (PlacedLine line : united) {
      if (hidden) {
        bool covered = false;
        for (const PlacedLine& over : seen) {
          if (over.end <= line.begin + kSamePlace || over.begin >= line.end - kSamePlace) continue;
          if (over.begin > line.begin + kSamePlace) out.push_back({line.from, over.from, true});
          line.from = over.to;
          line.begin = over.end;
          covered = line.begin >= line.end - kSamePlace;
          if (covered) break;
        }
        if (covered) continue;
      }
      if (line.end - line.begin > kSamePlace) out.push_back({line.from, line.to, hidden});
    }
    if (!hidden) seen = std::move(united);
  }
}

/// Calls visit(part) for each run of sorted elements whose keys follow each other closely.
template <class Key, class Visit>
void for_each_run(std::span<PlacedLine> lines, Key key, double close, const Visit& visit) {
  std::ranges::sort(lines, {}, key);
  for (std::size_t begin = 0; begin < lines.size();) {
    std::size_t end = begin + 1;
    while (end < lines.size() && lines[end].*key - lines[end - 1].*key <= close) ++end;
    visit(lines.subspan(begin, end - begin));
    begin = end;
  }
}

}  // namespace

std::vector<PartDrawing::Line> unique_lines(const std::vector<PartDrawing::Line>& lines) {
  std::vector<PlacedLine> all;
  for (const PartDrawing::Line& line : lines) {
    if (glm::distance(line.from, line.to) > kSamePlace) all.push_back(placed(line));
  }
  std::vector<PartDrawing::Line> out;
  for_each_run(std::span(all), &PlacedLine::angle, kSameAngle, [&](std::span<PlacedLine> parallel) {
    const double angle = parallel[0].angle;
    const Point2 along(std::cos(angle), std::sin(angle));
    for (PlacedLine& line : parallel) {
      const Point2 middle = 0.5 * (line.from + line.to);
      line.offset = along.x * middle.y - along.y * middle.x;
      line.begin = glm::dot(along, line.from);
      line.end = glm::dot(along, line.to);
    }
    for_each_run(parallel, &PlacedLine::offset, kSamePlace,
                 [&](std::span<PlacedLine> group) { unite(group, out); });
  });
  return out;
}

}  // namespace displayfile
