#pragma once

#include <vector>

#include "displayfile/mesh/section.h"

namespace displayfile {

/// The cut face of a section by that plane, as even-odd polygons that may overlap where bodies do:
/// one for each loop around solid, with the holes within it joined to it by bridges. A hole within
/// several is that of the smallest. Where the mesh is turned inside out as a whole, so is what is
/// solid.
std::vector<std::vector<Point3>> cap_polygons(const Section& section, const SectionPlane& plane);

}  // namespace displayfile
