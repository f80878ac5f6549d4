#pragma once

#include <vector>

#include "displayfile/mesh/section.h"

namespace displayfile {

/// Turns the loops of bodies that are inside out, as what is mirrored is, so that all are
/// counterclockwise around what is solid. A body that lies in no other's material is solid
/// whichever way it is turned; what lies within one that is inside out is turned with it.
void turn_bodies_out(Section& section, const SectionPlane& plane);

/// The cut face of a section by that plane, as even-odd polygons that may overlap where bodies do:
/// one of each object, its loops joined by bridges. One that is a cavity, of negative area, is a
/// hole of the smallest object that has it in its material.
std::vector<std::vector<Point3>> cap_polygons(const Section& section, const SectionPlane& plane);

}  // namespace displayfile
