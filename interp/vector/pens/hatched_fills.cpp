#include "interp/vector/pens/hatched_fills.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "interp/vector/pens/hatching.h"

namespace displayfile {

namespace {

/// A tone is large if it has room for this many lines of this many spacings' length.
constexpr double kLinesOfLargeTone = 10.0;

/// Even spacings are quantised to this fraction of the closest: tones that differ by rounding are
/// one.
constexpr double kPartsOfSpacing = 16.0;

double area_of(std::span<const Point2> polygon) {
  double twice = 0.0;
  for (std::size_t i = 0, before = polygon.size() - 1; i < polygon.size(); before = i++) {
    const Point2 a = polygon[before] - polygon[0], b = polygon[i] - polygon[0];
    twice += a.x * b.y - a.y * b.x;
  }
  return std::abs(twice) / 2.0;
}

}  // namespace

void HatchedFills::add(std::span<const Point2> polygon, std::span<const double> darkness,
                       bool overlaps_nothing, const Point2& slope) {
  const std::size_t first = points_.size();
  points_.insert(points_.end(), polygon.begin(), polygon.end());
  darkness_.insert(darkness_.end(), darkness.begin(), darkness.end());
  const auto [least, most] = std::minmax_element(darkness.begin(), darkness.end());
  const bool even = *most - *least <= kSameTone;
  fills_.push_back({first, points_.size(), even, area_of(polygon), slope});
  overlap_ = overlap_ || !overlaps_nothing;
}

/// Facets of round surfaces are excluded: they get the lines of the common grid, which continue
/// from one to the next. Tones that differ by rounding are one.
HatchedFills::LargeTones HatchedFills::large_tones() const {
  constexpr double kTones = 1024.0;  // from paper to pen
  const HatchedFaces faces = hatched_faces(fills_, points_, darkness_);
  LargeTones large{std::vector<double>(fills_.size(), 0.0), {}};
  std::map<double, double> areas;
  for (std::size_t i = 0; i < fills_.size(); ++i) {
    if (!fills_[i].is_even || faces.is_facet[i] != 0) continue;
    const double tone = std::round(kTones * darkness(fills_[faces.face_of[i]])) / kTones;
    if (!(tone > 0.0)) continue;
    large.of_fill[i] = tone;
    areas[tone] += fills_[i].area;
  }
  const double side = kLinesOfLargeTone * hatching_.spacing;
  for (const auto& [tone, area] : areas) {
    if (area >= side * side) large.tones.push_back(tone);
  }
  return large;
}

/// Adds the lines of one direction, for a darkness multiplied by `factor`, less `less`.
void HatchedFills::add_direction(double degrees, double factor, double less,
                                 const LargeTones& large, std::vector<Stroke>& strokes) const {
  constexpr double kBlank = -1.0;
  const auto is_of = [&](const std::vector<double>& tones, std::size_t fill) {
    return std::ranges::binary_search(tones, large.of_fill[fill]);
  };
  const auto draw = [&](double spacing, const auto& darkness_at) {
    HatchLines lines(spacing, degrees, frame_);
    std::vector<double> dark;
    for (std::size_t f = 0; f < fills_.size(); ++f) {
      const Fill& fill = fills_[f];
      dark.clear();
      for (std::size_t i = fill.first; i < fill.end; ++i) dark.push_back(darkness_at(f, i));
      const bool blank = std::ranges::all_of(dark, [](double d) { return d <= 0.0; });
      if (overlap_ || !blank) lines.add(polygon(fill), dark);
    }
    const std::vector<Stroke> drawn = lines.strokes(shortest_);
    strokes.insert(strokes.end(), drawn.begin(), drawn.end());
  };
  draw(hatching_.spacing, [&](std::size_t fill, std::size_t i) {
    return is_of(large.tones, fill) ? kBlank : factor * darkness_[i] - less;
  });
  std::map<double, std::vector<double>> tones_of_spacing;
  for (const double tone : large.tones) {
    const double dark = std::min(1.0, factor * tone - less);
    if (dark <= 0.0) continue;
    const double parts = std::round(kPartsOfSpacing / dark);
    tones_of_spacing[parts * hatching_.spacing / kPartsOfSpacing].push_back(tone);
  }
  for (const auto& [spacing, tones] : tones_of_spacing) {
    const auto& all = tones;
    draw(spacing, [&](std::size_t fill, std::size_t) { return is_of(all, fill) ? 1.0 : kBlank; });
  }
}

std::vector<Stroke> HatchedFills::strokes() const {
  std::vector<Stroke> strokes;
  const LargeTones large = large_tones();
  if (!hatching_.cross) {
    add_direction(hatching_.angle, 1.0, 0.0, large, strokes);
  } else {  // one direction up to the middle tone, the other for darker fills
    add_direction(hatching_.angle, 2.0, 0.0, large, strokes);
    add_direction(hatching_.angle + 90.0, 2.0, 1.0, large, strokes);
  }
  return strokes;
}

}  // namespace displayfile
