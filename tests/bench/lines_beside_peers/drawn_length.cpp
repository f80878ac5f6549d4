#include "tests/bench/lines_beside_peers/drawn_length.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "hidden/lines/hidden_parts.h"

namespace displayfile::bench {

namespace {

struct Box {
  Point2 low, high;
};
Box box_of(const DrawnSegment& s) { return {glm::min(s.p, s.q), glm::max(s.p, s.q)}; }

/// Squares over all segments, each with those that reach it.
class Squares {
 public:
  Squares(const LineDrawing& drawing, double tolerance) : tolerance_(tolerance) {
    Box all{Point2(std::numeric_limits<double>::max()),
            Point2(std::numeric_limits<double>::lowest())};
    for (const DrawnSegment& s : drawing) {
      const Box box = box_of(s);
      all = {glm::min(all.low, box.low), glm::max(all.high, box.high)};
    }
    if (drawing.empty()) all = {Point2(0.0), Point2(1.0)};
    low_ = all.low;
    side_ = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(drawing.size()))), 1, kMost);
    const double size = std::max({all.high.x - all.low.x, all.high.y - all.low.y, tolerance});
    a_unit_ = side_ / size;
    squares_.resize(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_));
    for (std::uint32_t i = 0; i < drawing.size(); ++i) {
      for_each_square(box_of(drawing[i]), [&](auto& square) { square.push_back(i); });
    }
  }

  /// Calls visit once or more for each segment that may be within the tolerance of the box.
  template <class Visit>
  void near(const Box& box, const Visit& visit) {
    for_each_square(box, [&](const auto& square) { std::ranges::for_each(square, visit); });
  }

 private:
  static constexpr int kMost = 1024;

  int square_of(double x) const {
    return static_cast<int>(std::clamp(x * a_unit_, 0.0, static_cast<double>(side_ - 1)));
  }
  template <class Visit>
  void for_each_square(const Box& box, const Visit& visit) {
    const Point2 low = box.low - tolerance_ - low_, high = box.high + tolerance_ - low_;
    for (int y = square_of(low.y); y <= square_of(high.y); ++y) {
      for (int x = square_of(low.x); x <= square_of(high.x); ++x) {
        visit(squares_[static_cast<std::size_t>(y) * static_cast<std::size_t>(side_) +
                       static_cast<std::size_t>(x)]);
      }
    }
  }

  double tolerance_;
  Point2 low_{0.0};
  int side_ = 1;
  double a_unit_ = 1.0;
  std::vector<std::vector<std::uint32_t>> squares_;
};

/// Where a linear value lies from low to high, of the parameters from 0 to 1 in `part`.
bool clip(double at_0, double rise, double low, double high, PartOfLine& part) {
  if (rise == 0.0) return at_0 >= low && at_0 <= high;
  const double a = (low - at_0) / rise, b = (high - at_0) / rise;
  part = {std::max(part.from, std::min(a, b)), std::min(part.to, std::max(a, b))};
  return part.from <= part.to;
}

/// The part of a segment within the tolerance of another: the region near one is convex, so the
/// part spans the parts near its ends and the part beside it.
std::optional<PartOfLine> part_near(const DrawnSegment& s, const DrawnSegment& other,
                                    double tolerance) {
  const Point2 along = s.q - s.p;
  PartOfLine all{1.0, 0.0};
  const auto include = [&](PartOfLine part) {
    part = {std::max(part.from, 0.0), std::min(part.to, 1.0)};
    if (part.from > part.to) return;
    all = {std::min(all.from, part.from), std::max(all.to, part.to)};
  };
  const double squared = glm::dot(along, along);
  for (const Point2& end : {other.p, other.q}) {
    const Point2 from_end = s.p - end;
    const double half = glm::dot(along, from_end);
    const double under =
        half * half - squared * (glm::dot(from_end, from_end) - tolerance * tolerance);
    if (under < 0.0) continue;
    include({(-half - std::sqrt(under)) / squared, (-half + std::sqrt(under)) / squared});
  }
  const Point2 direction = other.q - other.p;
  const double length = glm::length(direction);
  if (length > 0.0) {
    const Point2 d = direction / length, n(-d.y, d.x);
    PartOfLine beside{0.0, 1.0};
    if (clip(glm::dot(s.p - other.p, n), glm::dot(along, n), -tolerance, tolerance, beside) &&
        clip(glm::dot(s.p - other.p, d), glm::dot(along, d), 0.0, length, beside)) {
      include(beside);
    }
  }
  if (all.from >= all.to) return std::nullopt;
  return all;
}

/// Calls visit(segment, part) for the parts of the drawing that are farther than the tolerance from
/// all of the other's segments for which `counts` is true.
template <class Counts, class Visit>
void for_each_part_beside(const LineDrawing& drawing, const LineDrawing& other, double tolerance,
                          const Counts& counts, const Visit& visit) {
  Squares squares(other, tolerance);
  std::vector<PartOfLine> near;
  for (std::uint32_t i = 0; i < drawing.size(); ++i) {
    if (drawing[i].p == drawing[i].q) continue;
    near.clear();
    squares.near(box_of(drawing[i]), [&](std::uint32_t k) {
      if (!counts(i, k)) return;
      if (const auto part = part_near(drawing[i], other[k], tolerance)) near.push_back(*part);
    });
    unite(near);
    double from = 0.0;
    for (const PartOfLine& part : near) {
      if (part.from > from) visit(drawing[i], PartOfLine{from, part.from});
      from = part.to;
    }
    if (from < 1.0) visit(drawing[i], PartOfLine{from, 1.0});
  }
}

}  // namespace

double total_length(const LineDrawing& drawing) {
  double length = 0.0;
  for (const DrawnSegment& s : drawing) length += glm::distance(s.p, s.q);
  return length;
}

LineDrawing drawn_once(const LineDrawing& drawing, double tolerance) {
  LineDrawing once;
  for_each_part_beside(
      drawing, drawing, tolerance, [](std::uint32_t i, std::uint32_t k) { return k < i; },
      [&](const DrawnSegment& s, const PartOfLine& part) {
        const auto at = [&](double t) { return s.p + t * (s.q - s.p); };
        once.push_back({at(part.from), at(part.to)});
      });
  return once;
}

double length_beside(const LineDrawing& drawing, const LineDrawing& other, double tolerance) {
  double length = 0.0;
  for_each_part_beside(
      drawing, other, tolerance, [](std::uint32_t, std::uint32_t) { return true; },
      [&](const DrawnSegment& s, const PartOfLine& part) {
        length += (part.to - part.from) * glm::distance(s.p, s.q);
      });
  return length;
}

}  // namespace displayfile::bench
