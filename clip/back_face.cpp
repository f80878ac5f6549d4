#include "clip/back_face.h"

namespace displayfile {

bool is_back_face(std::span<const Point3> vertices) { return newell_c(vertices) <= 0.0; }

}  // namespace displayfile
