#include "interp/vector/pens/hatched_fills.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "interp/vector/pens/hatching.h"

namespace displayfile {

namespace {

/// A tone is large from so many lines, each as long as they are apart times this.
constexpr double kLinesOfLargeTone = 10.0;

/// Even spacings are whole parts of the closest: tones that differ by rounding are one.
constexpr double kPartsOfSpacing = 16.0;

double area_of(std::span<const Point2> polygon) {
  double twice = 0.0;
  for (std::size_t i = 0, before = polygon.size() - 1; i < polygon.size(); before = i++) {
    const Point2 a = polygon[before] - polygon[0], b = polygon[i] - polygon[0];
    twice += a.x * b.y - a.y * b.x;
  }
  return std::abs(twice) / 2.0;
}

bool comes_before(const Point3& a, const Point3& b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

/// True if one of the corners is there, and as dark up to rounding.
bool is_among(std::span<const Point3> corners, const Point2& there, double dark) {
  constexpr double kRounding = 1e-9;
  const auto at = std::ranges::lower_bound(corners, Point3(there, dark - kRounding), comes_before);
  return at != corners.end() && Point2(*at) == there && at->z <= dark + kRounding;
}

}  // namespace

void HatchedFills::add(std::span<const Point2> polygon, std::span<const double> darkness,
                       bool overlaps_nothing) {
  const std::size_t first = points_.size();
  points_.insert(points_.end(), polygon.begin(), polygon.end());
  darkness_.insert(darkness_.end(), darkness.begin(), darkness.end());
  const bool even = std::ranges::all_of(darkness, [&](double d) { return d == darkness.front(); });
  fills_.push_back({first, points_.size(), even});
  overlap_ = overlap_ || !overlaps_nothing;
}

/// Corners of the fills that are not as dark everywhere, each with its darkness, in order.
std::vector<Point3> HatchedFills::corners_of_uneven() const {
  std::vector<Point3> corners;
  for (const Fill& fill : fills_) {
    for (std::size_t i = fill.first; !fill.is_even && i < fill.end; ++i) {
      corners.emplace_back(points_[i], darkness_[i]);
    }
  }
  std::ranges::sort(corners, comes_before);
  return corners;
}

/// In order of darkness. A tone into which an uneven fill runs at a corner that both have is part
/// of one smooth surface with it, and gets the lines of the common grid.
std::vector<double> HatchedFills::large_tones() const {
  const std::vector<Point3> uneven = corners_of_uneven();
  std::map<double, double> areas;
  std::set<double> running_on;
  for (const Fill& fill : fills_) {
    if (!fill.is_even || !(darkness(fill) > 0.0)) continue;
    areas[darkness(fill)] += area_of(polygon(fill));
    const bool runs_on = std::ranges::any_of(polygon(fill), [&](const Point2& corner) {
      return is_among(uneven, corner, darkness(fill));
    });
    if (runs_on) running_on.insert(darkness(fill));
  }
  const double side = kLinesOfLargeTone * hatching_.spacing;
  std::vector<double> tones;
  for (const auto& [tone, area] : areas) {
    if (area >= side * side && !running_on.contains(tone)) tones.push_back(tone);
  }
  return tones;
}

/// The lines of one direction, for `factor` times the darkness and `less`.
void HatchedFills::add_direction(double degrees, double factor, double less,
                                 std::vector<Stroke>& strokes) const {
  constexpr double kBlank = -1.0;
  // A dot where a line would be shorter than it is wide adds a speck, not a tone.
  const double shortest = hatching_.width / 4.0;
  const std::vector<double> large = large_tones();
  const auto is_large = [&](const Fill& fill) {
    return fill.is_even && std::ranges::binary_search(large, darkness(fill));
  };
  const auto draw = [&](double spacing, const auto& darkness_at) {
    HatchLines lines(spacing, degrees, frame_);
    std::vector<double> dark;
    for (const Fill& fill : fills_) {
      dark.clear();
      for (std::size_t i = fill.first; i < fill.end; ++i) dark.push_back(darkness_at(fill, i));
      const bool blank = std::ranges::all_of(dark, [](double d) { return d <= 0.0; });
      if (overlap_ || !blank) lines.add(polygon(fill), dark);
    }
    const std::vector<Stroke> drawn = lines.strokes(shortest);
    strokes.insert(strokes.end(), drawn.begin(), drawn.end());
  };
  draw(hatching_.spacing, [&](const Fill& fill, std::size_t i) {
    return is_large(fill) ? kBlank : factor * darkness_[i] - less;
  });
  std::map<double, std::vector<double>> tones_of_spacing;
  for (const double tone : large) {
    const double dark = std::min(1.0, factor * tone - less);
    if (dark <= 0.0) continue;
    const double parts = std::round(kPartsOfSpacing / dark);
    tones_of_spacing[parts * hatching_.spacing / kPartsOfSpacing].push_back(tone);
  }
  for (const auto& [spacing, tones] : tones_of_spacing) {
    const auto& all = tones;
    draw(spacing, [&](const Fill& fill, std::size_t) {
      return fill.is_even && std::ranges::binary_search(all, darkness(fill)) ? 1.0 : kBlank;
    });
  }
}

std::vector<Stroke> HatchedFills::strokes() const {
  std::vector<Stroke> strokes;
  if (!hatching_.cross) {
    add_direction(hatching_.angle, 1.0, 0.0, strokes);
  } else {  // one direction up to the middle tone, and what is darker by the other
    add_direction(hatching_.angle, 2.0, 0.0, strokes);
    add_direction(hatching_.angle + 90.0, 2.0, 1.0, strokes);
  }
  return strokes;
}

}  // namespace displayfile
