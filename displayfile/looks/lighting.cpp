#include "displayfile/looks/lighting.h"

#include <glm/geometric.hpp>

#include "clip/geometry/unit.h"

namespace displayfile {

double intensity(const Light& light, const Point3& normal, bool turned_away) {
  double cosine = normal == Point3(0.0) ? 0.0 : glm::dot(unit(normal), light.toward);
  if (turned_away) cosine = -cosine;  // the dark face is the one that is seen
  return intensity_at(light, cosine);
}

FillStyle lit(const FillStyle& fill, double intensity) {
  if (fill.kind == FillStyle::Kind::hollow) return fill;
  return {FillStyle::Kind::solid, fill.colour * intensity};
}

FillStyle lit(const FillStyle& fill, const Light& light, const Point3& normal, bool turned_away) {
  if (fill.kind == FillStyle::Kind::hollow) return fill;
  return lit(fill, intensity(light, normal, turned_away));
}

std::optional<FillShadow> shadow_on(const FillStyle& lit_fill, const FillStyle& unlit,
                                    const Light& light, const ViewVolume& volume) {
  const Colour in_ambient_light = unlit.colour * light.ambient;
  if (unlit.kind == FillStyle::Kind::hollow || lit_fill.colour == in_ambient_light) return {};
  return FillShadow{in_ambient_light, volume.infinitely_far(light.toward)};
}

}  // namespace displayfile
