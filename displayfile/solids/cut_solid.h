#pragma once

#include <cstdint>

#include "clip/cutting_planes.h"
#include "displayfile/solids/solid_faces.h"

namespace displayfile {

/// What cutting planes leave of a closed solid, closed again by its cut faces (cut_solid.md):
/// `cut_by` of those is the plane's number, and `attributes` what they are drawn with. Vertices of
/// the solid that are equal in position need not be one. A vertex on a plane counts as cut away.
SolidFaces cut_solid(const SolidFaces& solid, const CuttingPlanes& planes,
                     std::uint32_t attributes);

}  // namespace displayfile
