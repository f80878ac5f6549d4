#include "hidden/lines/line_overlaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "clip/base/budgeted_work.h"
#include "hidden/boxes/extents.h"
#include "hidden/exact/orientation.h"

namespace displayfile {

namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

bool has_length(const DeepStroke& s) { return Point2(s.from) != Point2(s.to); }

double cross(const Point2& u, const Point2& v) { return u.x * v.y - u.y * v.x; }

/// Boxes around parts of strokes, short enough that the box of a slanted part is not much larger
/// than the part.
struct BoxedParts {
  std::vector<Extent> boxes;
  std::vector<std::uint32_t> stroke;  // per box
};

/// Axes parallel or perpendicular to most of the strokes, in pixels: boxes along them are thin,
/// even for long parallel strokes. Quadrupling the angle makes both directions of both axes equal.
class BoxAxes {
 public:
  BoxAxes(std::span<const DeepStroke> strokes, const Point2& pixels) : pixels_(pixels) {
    const auto squared = [](const Point2& z) {
      return Point2(z.x * z.x - z.y * z.y, 2.0 * z.x * z.y);
    };
    Point2 sum(0.0);
    for (const DeepStroke& s : strokes) {
      const Point2 way = Point2(s.to - s.from) * pixels;
      const double length = glm::length(way);
      if (length > 0.0 && std::isfinite(length)) sum += length * squared(squared(way / length));
    }
    const double angle = std::atan2(sum.y, sum.x) / 4.0;
    along_ = {std::cos(angle), std::sin(angle)};
  }

  Point2 operator()(const Point2& device) const {
    const Point2 p = device * pixels_;
    return {along_.x * p.x + along_.y * p.y, along_.x * p.y - along_.y * p.x};
  }

 private:
  Point2 pixels_, along_{1.0, 0.0};
};

BoxedParts boxed_parts(std::span<const DeepStroke> strokes, const Point2& pixels) {
  constexpr double kBoxesOfStroke = 4.0;  // on average
  const BoxAxes axes(strokes, pixels);
  const auto length = [&](const DeepStroke& s) {
    return glm::length(Point2(s.to - s.from) * pixels);
  };
  double all = 0.0;
  for (const DeepStroke& s : strokes) all += length(s);
  const double side = std::max(all / (kBoxesOfStroke * static_cast<double>(strokes.size())), 1e-9);
  BoxedParts parts;
  for (std::uint32_t k = 0; k < strokes.size(); ++k) {
    const DeepStroke& s = strokes[k];
    if (!has_length(s)) continue;
    const double count = std::clamp(std::ceil(length(s) / side), 1.0, 1e6);
    const Point2 from = axes(Point2(s.from)), way = axes(Point2(s.to)) - from;
    const double farthest = std::abs(from.x) + std::abs(from.y) + std::abs(way.x) + std::abs(way.y);
    // A part's box includes half of the pen's width and rounding errors.
    const Point2 margin(s.width / 2.0 + 1e-6 + 1e-12 * farthest);
    for (double i = 0.0; i < count; ++i) {
      const Point2 a = from + (i / count) * way, b = from + ((i + 1.0) / count) * way;
      parts.boxes.push_back(Extent::between(Point3(glm::min(a, b) - margin, 0.0),
                                            Point3(glm::max(a, b) + margin, 0.0)));
      parts.stroke.push_back(k);
    }
  }
  return parts;
}

/// The pairs of strokes with parts whose boxes meet, the lower number first, each pair once.
std::vector<Pair> close_pairs(std::span<const DeepStroke> strokes, const Point2& pixels,
                              int threads) {
  const BoxedParts parts = boxed_parts(strokes, pixels);
  std::vector<Pair> pairs;
  if (parts.boxes.empty()) return pairs;
  const ExtentTree tree = extent_tree(parts.boxes, threads);
  const auto order = tree.order();
  WorkSteps steps;
  tree.pairs(0, tree.leaves(), [&](std::uint32_t p, std::uint32_t q) {
    steps.step();
    const std::uint32_t a = parts.stroke[order[p]], b = parts.stroke[order[q]];
    if (a != b) pairs.emplace_back(std::min(a, b), std::max(a, b));
  });
  std::ranges::sort(pairs);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

/// Finds the overlaps of two strokes.
class Overlapping {
 public:
  Overlapping(std::span<const DeepStroke> strokes, const StrokePicture& picture, const Pair& pair)
      : a_(strokes[pair.first]), b_(strokes[pair.second]), pair_(pair), picture_(picture) {}

  void add_to(std::vector<StrokeOverlap>& all) const {
    const Point2 a(a_.from), b(a_.to), c(b_.from), d(b_.to);
    const int of_c = orientation(a, b, c), of_d = orientation(a, b, d);
    const int of_a = orientation(c, d, a), of_b = orientation(c, d, b);
    const bool in_line = of_c == 0 && of_d == 0;
    if (!in_line && of_c * of_d <= 0 && of_a * of_b <= 0) {
      const double at_a = share(orientation_value(c, d, a), orientation_value(c, d, b));
      const double at_b = share(orientation_value(a, b, c), orientation_value(a, b, d));
      all.push_back(overlap(nearer_at_crossing(of_d != 0 ? of_d : -of_c), at_a, at_b, true));
    } else if (a_.look != b_.look) {
      in_line ? add_along(all) : add_beside(all);
    }
  }

 private:
  /// The fraction at which a line crosses another, from its ends' distances to it on either side.
  static double share(const OrientationValue& from, const OrientationValue& to) {
    const double all = std::abs(from.determinant) + std::abs(to.determinant);
    return all > 0.0 ? std::abs(from.determinant) / all : 0.5;
  }

  /// At the crossing, 1 if the second stroke is nearer by more than `apart`, -1 if the first is, 0
  /// if neither is. `turn` is the sign of the turn from the first's direction to the second's: the
  /// tetrahedron of the four ends has this sign if the first is nearer.
  int nearer_at_crossing(int turn) const {
    const auto second_nearer = [&](double moved) {
      Point3 c = b_.from, d = b_.to;
      c.z += moved;
      d.z += moved;
      return -turn * orientation(a_.from, a_.to, c, d);
    };
    if (second_nearer(-picture_.apart) > 0) return 1;
    return second_nearer(picture_.apart) < 0 ? -1 : 0;
  }

  int nearer_by(double difference) const {
    return difference > picture_.apart ? 1 : difference < -picture_.apart ? -1 : 0;
  }

  /// `nearer` is 1 if the second stroke is nearer, -1 if the first is, 0 if neither is.
  StrokeOverlap overlap(int nearer, double at_a, double at_b, bool crosses) const {
    const bool second = nearer != 0 ? nearer > 0 : b_.entry >= a_.entry;
    const Point2 a = pixel(a_.from), b = pixel(a_.to), c = pixel(b_.from), d = pixel(b_.to);
    const double reach = (a_.width + b_.width) / 2.0;
    const PartOfLine of_a = part_within(a, b, c, d, reach).value_or(PartOfLine{at_a, at_a});
    const PartOfLine of_b = part_within(c, d, a, b, reach).value_or(PartOfLine{at_b, at_b});
    StrokeOverlap o{pair_.first, pair_.second, nearer == 0, crosses, at_a, at_b, of_a, of_b};
    if (!second) {
      std::swap(o.far, o.near);
      std::swap(o.at_far, o.at_near);
      std::swap(o.of_far, o.of_near);
    }
    return o;
  }

  /// Handles collinear axes: where their depths cross, the strokes exchange order.
  void add_along(std::vector<StrokeOverlap>& all) const {
    const Point2 a = pixel(a_.from), b = pixel(a_.to), c = pixel(b_.from), d = pixel(b_.to);
    const double in_a = along(a, b, c), to_a = along(a, b, d);
    const double low = std::max(0.0, std::min(in_a, to_a));
    const double high = std::min(1.0, std::max(in_a, to_a));
    if (low > high) return add_beside(all);
    const auto in_b = [&](double t) { return std::clamp(along(c, d, a + t * (b - a)), 0.0, 1.0); };
    const auto difference = [&](double t) { return depth(b_, in_b(t)) - depth(a_, t); };
    const double first = difference(low), last = difference(high);
    const auto add = [&](double from, double to) {
      const double middle = from + (to - from) / 2.0;
      StrokeOverlap o = overlap(nearer_by(difference(middle)), middle, in_b(middle), false);
      const bool swapped = o.far != pair_.first;
      const double s = in_b(from), e = in_b(to);
      (swapped ? o.of_near : o.of_far) = {from, to};
      (swapped ? o.of_far : o.of_near) = {std::min(s, e), std::max(s, e)};
      all.push_back(o);
    };
    if (nearer_by(first) * nearer_by(last) >= 0) return add(low, high);
    const double meet = low + (high - low) * (first / (first - last));
    add(low, meet);
    add(meet, high);
  }

  /// Handles axes that do not meet, whose widths may overlap: they are closest at an end of one.
  void add_beside(std::vector<StrokeOverlap>& all) const {
    const Point2 a = pixel(a_.from), b = pixel(a_.to), c = pixel(b_.from), d = pixel(b_.to);
    struct Nearest {
      double distance, at_a, at_b;
    };
    const auto of_end = [&](const Point2& end, const Point2& p, const Point2& q) {
      const double t = std::clamp(along(p, q, end), 0.0, 1.0);
      return std::pair(glm::distance(end, p + t * (q - p)), t);
    };
    const auto [from_a, b_of_a] = of_end(a, c, d);
    const auto [from_b, b_of_b] = of_end(b, c, d);
    const auto [from_c, a_of_c] = of_end(c, a, b);
    const auto [from_d, a_of_d] = of_end(d, a, b);
    const std::array<Nearest, 4> ends{{{from_a, 0.0, b_of_a},
                                       {from_b, 1.0, b_of_b},
                                       {from_c, a_of_c, 0.0},
                                       {from_d, a_of_d, 1.0}}};
    const Nearest& nearest = *std::ranges::min_element(ends, {}, &Nearest::distance);
    if (!(nearest.distance < (a_.width + b_.width) / 2.0)) return;
    const double difference = depth(b_, nearest.at_b) - depth(a_, nearest.at_a);
    all.push_back(overlap(nearer_by(difference), nearest.at_a, nearest.at_b, false));
  }

  static double along(const Point2& p, const Point2& q, const Point2& point) {
    return glm::dot(point - p, q - p) / glm::dot(q - p, q - p);
  }
  static double depth(const DeepStroke& s, double t) { return s.from.z + t * (s.to.z - s.from.z); }
  Point2 pixel(const Point3& p) const { return Point2(p) * picture_.pixels; }

  const DeepStroke &a_, &b_;
  Pair pair_;
  const StrokePicture& picture_;
};

/// The part with |start + t * slope| <= reach.
std::optional<PartOfLine> within(double start, double slope, double reach) {
  if (slope == 0.0) {
    if (std::abs(start) > reach) return std::nullopt;
    return PartOfLine{0.0, 1.0};
  }
  const double s = (-reach - start) / slope, t = (reach - start) / slope;
  return PartOfLine{std::min(s, t), std::max(s, t)};
}

void widen(std::optional<PartOfLine>& all, double from, double to) {
  from = std::max(from, 0.0);
  to = std::min(to, 1.0);
  if (!(from <= to)) return;
  all = all ? PartOfLine{std::min(all->from, from), std::max(all->to, to)} : PartOfLine{from, to};
}

}  // namespace

/// The points within reach form a convex set, so the result is a single part: from the first to the
/// last point in one of the two discs or the rectangle between them.
std::optional<PartOfLine> part_within(const Point2& a, const Point2& b, const Point2& p,
                                      const Point2& q, double reach) {
  std::optional<PartOfLine> all;
  const Point2 way = b - a;
  const double squared = glm::dot(way, way);
  for (const Point2& centre : {p, q}) {
    const Point2 to_centre = centre - a;
    if (squared == 0.0) {
      if (glm::length(to_centre) <= reach) widen(all, 0.0, 1.0);
      continue;
    }
    const double middle = glm::dot(to_centre, way) / squared;
    const double aside = cross(way, to_centre) / std::sqrt(squared);
    const double rest = reach * reach - aside * aside;
    if (rest < 0.0) continue;
    const double half = std::sqrt(rest / squared);
    widen(all, middle - half, middle + half);
  }
  const double length = glm::distance(p, q);
  if (!(length > 0.0)) return all;
  const Point2 u = (q - p) / length;
  const auto beside = within(cross(u, a - p), cross(u, way), reach);
  const auto between = within(glm::dot(u, a - p) - length / 2.0, glm::dot(u, way), length / 2.0);
  if (beside && between) {
    widen(all, std::max(beside->from, between->from), std::min(beside->to, between->to));
  }
  return all;
}

std::vector<StrokeOverlap> stroke_overlaps(std::span<const DeepStroke> strokes,
                                           const StrokePicture& picture, int threads) {
  std::vector<StrokeOverlap> all;
  if (strokes.size() < 2) return all;
  WorkSteps steps;
  for (const Pair& pair : close_pairs(strokes, picture.pixels, threads)) {
    steps.step();
    Overlapping(strokes, picture, pair).add_to(all);
  }
  return all;
}

}  // namespace displayfile
