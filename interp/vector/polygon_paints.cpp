#include "interp/vector/polygon_paints.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "clip/geometry/corners.h"
#include "displayfile/looks/lighting.h"
#include "hidden/exact/support_plane.h"
#include "interp/device/picture.h"

namespace displayfile {

namespace {

/// In pixels.
constexpr double kNarrowPiece = 0.5;

/// In levels of the brightest component, of 255.
constexpr double kEvenLevels = 0.5, kRampTolerance = 0.125;

/// In pixels.
constexpr double kLongestRamp = 1e6;

/// More digits than renderers use.
constexpr int kMostDecimals = 6;

/// An intensity that is linear over the page.
struct PageIntensity {
  Point2 origin, slope;
  double at_origin;
  double at(const Point2& p) const {
    return at_origin + slope.x * (p.x - origin.x) + slope.y * (p.y - origin.y);
  }
  double steepness() const { return std::sqrt(slope.x * slope.x + slope.y * slope.y); }
};

PageIntensity intensity_over_page(const DrawnPolygon& polygon, std::span<const Point2> page) {
  const SupportVertices support = support_vertices(polygon.vertices);
  const auto corner = [&](std::size_t k) {
    return Point3(page[support.index[k]], polygon.intensities[support.index[k]]);
  };
  const Point3 p = corner(0), q = corner(1), r = corner(2);
  const Point2 along = Point2(q) - Point2(p), aside = Point2(r) - Point2(p);
  const double length = std::sqrt(along.x * along.x + along.y * along.y);
  if (!(length > 0.0)) return {p, Point2(0.0), mean_intensity(polygon.intensities)};  // a point
  const double height = std::abs(along.x * aside.y - along.y * aside.x) / length;
  if (support.edge_on || !(height >= kNarrowPiece)) {
    return {p, (q.z - p.z) / (length * length) * along, p.z};
  }
  const DepthPlane plane = depth_plane(p, q, r);
  return {p, {plane.dz_dx, plane.dz_dy}, p.z};
}

/// Black where the intensity is 0 and full where it is 1, on a line through that point.
ColourRamp ramp_through(const Point2& middle, const PageIntensity& intensity) {
  const Point2& slope = intensity.slope;
  const Point2 whole = 1.0 / (slope.x * slope.x + slope.y * slope.y) * slope;
  const Point2 black = middle - intensity.at(middle) * whole, full = black + whole;
  return {black.x, black.y, full.x, full.y};
}

ColourRamp rounded_to(const ColourRamp& ramp, double step) {
  const auto to_step = [&](double v) { return std::round(v / step) * step; };
  return {to_step(ramp.black_x), to_step(ramp.black_y), to_step(ramp.full_x), to_step(ramp.full_y)};
}

template <class IntensityAt>
bool lies_on(const ColourRamp& ramp, std::span<const Point2> page, double tolerance,
             const IntensityAt& intensity_at) {
  for (std::size_t i = 0; i < page.size(); ++i) {
    if (!(std::abs(ramp.at(page[i]) - intensity_at(i)) <= tolerance)) return false;
  }
  return true;
}

}  // namespace

FillPaint PolygonPaints::paint_of(const DrawnPolygon& polygon, std::span<const Point2> page,
                                  std::span<const Point2> shown, double unit) {
  const Colour& colour = polygon.fill.colour;
  const auto& intensities = polygon.intensities;
  if (intensities.empty()) return {pixel_of(colour)};
  const std::uint32_t pixel = pixel_of(colour);
  const double levels = 255.0 * std::max({colour.r, colour.g, colour.b});
  const double tolerance = kRampTolerance / levels;
  if (const auto last = last_of_pick_.find(polygon.pick);
      last != last_of_pick_.end() && last->second.pixel == pixel &&
      lies_on(*last->second.ramp, page, tolerance, [&](std::size_t i) { return intensities[i]; })) {
    return last->second;
  }
  const auto [low, high] = std::ranges::minmax(intensities);
  if ((high - low) * levels >= kEvenLevels) {
    const PageIntensity intensity = intensity_over_page(polygon, page);
    const Point2 middle = mean_of_vertices(shown);
    if (!(intensity.steepness() > 1.0 / kLongestRamp)) {
      return {pixel_of(colour * std::clamp(intensity.at(middle), low, high))};
    }
    const ColourRamp exact = ramp_through(middle, intensity);
    double step = unit;
    for (int decimals = 0; decimals <= kMostDecimals; ++decimals, step /= 10.0) {
      const ColourRamp ramp = rounded_to(exact, step);
      if (lies_on(ramp, page, tolerance, [&](std::size_t i) { return intensity.at(page[i]); })) {
        return last_of_pick_[polygon.pick] = {pixel, ramp};
      }
    }
  }
  return {pixel_of(even_fill(polygon).colour)};
}

}  // namespace displayfile
