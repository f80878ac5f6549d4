#pragma once

#include <cstdint>

#include "clip/cutting_planes.h"
#include "displayfile/solids/solid_faces.h"

namespace displayfile {

/// Cuts a closed solid by cutting planes and closes it by cut faces (cut_solid.md): their `cut_by`
/// is the plane's number, and `attributes` their attributes. Vertices of the solid with equal
/// positions need not be shared. A vertex on a plane counts as cut away.
SolidFaces cut_solid(const SolidFaces& solid, const CuttingPlanes& planes,
                     std::uint32_t attributes);

}  // namespace displayfile
