#pragma once

#include <vector>

#include "displayfile/mesh/section.h"

namespace displayfile {

/// Turns the loops of bodies that are inside out, as what is mirrored is, so that all are
/// counterclockwise around what is solid. A body that lies in no other is solid whichever way it
/// is turned; what lies within one that is inside out is turned with it.
void turn_bodies_out(Section& section, const SectionPlane& plane);

/// The cut face of a section by that plane, as even-odd polygons that may overlap where bodies do:
/// one for each loop around solid, with the holes within it joined to it by bridges. A hole within
/// several is that of the smallest.
std::vector<std::vector<Point3>> cap_polygons(const Section& section, const SectionPlane& plane);

}  // namespace displayfile
