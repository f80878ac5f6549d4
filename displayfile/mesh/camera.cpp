#include "displayfile/mesh/camera.h"

#include <string>

#include "clip/error.h"

namespace displayfile {

Upright upright(std::string_view axis) {
  const Point3 x(1.0, 0.0, 0.0), y(0.0, 1.0, 0.0), z(0.0, 0.0, 1.0);
  if (axis == "x") return {-y, x, z};
  if (axis == "y") return {x, y, z};
  if (axis == "z") return {x, z, -y};
  if (axis == "-x") return {y, -x, z};
  if (axis == "-y") return {-x, -y, z};
  if (axis == "-z") return {x, -z, y};
  throw Error("up is x, y, z, -x, -y or -z, not '" + std::string(axis) + "'");
}

}  // namespace displayfile
