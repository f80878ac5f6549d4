#pragma once

#include <algorithm>
#include <optional>

#include "clip/point.h"
#include "clip/view_volume.h"
#include "displayfile/looks/style.h"

namespace displayfile {

/// The intensity of a surface where the light is at an angle of that cosine to the normal of the
/// side that is seen; NaN stands for a surface that has none.
inline double intensity_at(const Light& light, double cosine) {
  return std::min(1.0, light.ambient + (1.0 - light.ambient) * std::max(0.0, cosine));
}

/// The intensity of a surface of that normal (of any length, or zero): ambient + (1 - ambient)
/// max(0, cosine of the angle between the light and the normal, turned round if it is turned away).
double intensity(const Light& light, const Point3& normal, bool turned_away);

/// A colour in that light: the colour times the intensity.
inline Colour lit(const Colour& colour, const Light& light, const Point3& normal,
                  bool turned_away) {
  return colour * intensity(light, normal, turned_away);
}

/// The fill of a polygon of that normal (of any length, out of its light face; zero if it has
/// none): the colour times the intensity of the side that is seen. Hollow stays hollow.
FillStyle lit(const FillStyle& fill, const Light& light, const Point3& normal, bool turned_away);

/// How a lit fill is drawn where something hides the light: in the ambient light alone, as `unlit`
/// says. None if that makes no difference, as where the side that is seen is turned away from the
/// light.
std::optional<FillShadow> shadow_on(const FillStyle& lit_fill, const FillStyle& unlit,
                                    const Light& light, const ViewVolume& volume);

/// The fill of that intensity everywhere.
FillStyle lit(const FillStyle& fill, double intensity);

}  // namespace displayfile
