#include "displayfile/lighting.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace displayfile {

FillStyle lit(const FillStyle& fill, const Light& light, const Point3& normal, bool turned_away) {
  if (fill.kind == FillStyle::Kind::hollow) return fill;
  double cosine = normal == Point3(0.0) ? 0.0 : glm::dot(unit(normal), light.toward);
  if (turned_away) cosine = -cosine;  // the dark face is the one that is seen
  const double intensity =
      std::min(1.0, light.ambient + (1.0 - light.ambient) * std::max(0.0, cosine));
  return {FillStyle::Kind::solid, fill.colour * intensity};
}

}  // namespace displayfile
