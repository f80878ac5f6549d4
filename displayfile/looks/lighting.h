#pragma once

#include <algorithm>
#include <optional>

#include "clip/point.h"
#include "clip/view/view_volume.h"
#include "displayfile/looks/style.h"

namespace displayfile {

/// The intensity of a surface, given the cosine of the angle between the light and the visible
/// side's normal; NaN: no normal.
inline double intensity_at(const Light& light, double cosine) {
  return std::min(1.0, light.ambient + (1.0 - light.ambient) * std::max(0.0, cosine));
}

/// The intensity of a surface with this normal (of any length, or zero): ambient + (1 - ambient)
/// max(0, cosine of the angle between the light and the normal, reversed if turned away).
double intensity(const Light& light, const Point3& normal, bool turned_away);

/// A lit colour: the colour times the intensity.
inline Colour lit(const Colour& colour, const Light& light, const Point3& normal,
                  bool turned_away) {
  return colour * intensity(light, normal, turned_away);
}

/// The lit fill of a polygon with this normal (of any length, out of its light face; zero: none):
/// the colour times the intensity of the visible side. Hollow stays hollow.
FillStyle lit(const FillStyle& fill, const Light& light, const Point3& normal, bool turned_away);

/// The fill's shadow: `unlit` in ambient light alone. None if that makes no difference, as where
/// the visible side faces away from the light.
std::optional<FillShadow> shadow_on(const FillStyle& lit_fill, const FillStyle& unlit,
                                    const Light& light, const ViewVolume& volume);

/// The fill with this intensity everywhere.
FillStyle lit(const FillStyle& fill, double intensity);

}  // namespace displayfile
