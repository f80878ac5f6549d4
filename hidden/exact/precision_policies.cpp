#include "hidden/exact/precision_policies.h"

#include <algorithm>

#include "clip/bounds.h"

namespace displayfile {

Roundoff Roundoff::relative(const Definitions& all, double part) {
  if (all.points.empty()) return {all, 0.0};
  Bounds box;
  for (const Point3& p : all.points) box.include(p);
  const Point3 size = box.high - box.low;
  return {all, part * std::max({size.x, size.y, size.z})};
}

}  // namespace displayfile
