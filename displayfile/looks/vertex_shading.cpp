#include "displayfile/looks/vertex_shading.h"

#include <cassert>

namespace displayfile {

std::span<const double> vertex_intensities(const VertexShading& shading,
                                           std::vector<double>& of_normals) {
  if (shading.normals.empty()) return shading.intensities;
  assert(shading.light != nullptr);
  of_normals.clear();
  for (const Point3& n : shading.normals) of_normals.push_back(intensity(*shading.light, n, false));
  return of_normals;
}

}  // namespace displayfile
