#pragma once

#include "displayfile/graphics_system.h"
#include "displayfile/solids/combining_steps.h"
#include "displayfile/solids/exact_surface.h"

namespace displayfile {

/// Combines solids that may touch themselves and each other in any way, by the arrangement of their
/// triangles, without rounding. The result may touch itself, too. Coincident faces of both have a's
/// source in the result. Throws what `steps` throws.
///
/// Source: Zhou, Grinspun, Zorin, Jacobson, "Mesh arrangements for solid geometry", ACM
/// Transactions on Graphics 35 (4), 2016, with two solids and without rounding.
ExactSurface combined_by_arrangement(SolidOperation operation, const ExactSurface& a,
                                     const ExactSurface& b, CombiningSteps& steps);

}  // namespace displayfile
