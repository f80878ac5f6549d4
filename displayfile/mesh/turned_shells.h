#pragma once

#include "displayfile/mesh/solid_triangles.h"

namespace displayfile {

/// Turns the closed shells of an object that are inside out: those of negative volume in no other
/// shell's material, each with all shells inside it, so that a cavity stays a cavity. A shell is
/// triangles connected over sides that two of them have; shells that are closed only together,
/// where more than two triangles have a side, are one. Open shells stay as they are.
void turn_shells_out(SolidTriangles::Object& object);

}  // namespace displayfile
