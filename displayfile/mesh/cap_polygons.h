#pragma once

#include <vector>

#include "displayfile/mesh/section.h"

namespace displayfile {

/// Reverses the loops of inside-out bodies, such as mirrored ones, so that all run counterclockwise
/// around solid. A body in no other's material is solid in either orientation; bodies within an
/// inside-out body are reversed with it.
void turn_bodies_out(Section& section, const SectionPlane& plane);

/// The cut face of a section, as even-odd polygons, one per object, whose loops are joined by
/// bridges; they may overlap where bodies do. A cavity, of negative area, is a hole of the smallest
/// object with it in its material.
std::vector<std::vector<Point3>> cap_polygons(const Section& section, const SectionPlane& plane);

}  // namespace displayfile
