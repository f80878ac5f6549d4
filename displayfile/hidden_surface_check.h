#pragma once

#include <span>

#include "displayfile/segment.h"
#include "displayfile/sorted_instructions.h"
#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

/// True for the methods that sort polygons in object space, which HIDDEN-SURFACE-CHECK runs.
bool sorts(HiddenMethod method);

/// HIDDEN-SURFACE-CHECK (algorithm 9.8): a segment's polygons and lines back to front, by `bsp`
/// or `depth_sort`. Points are those after the image transformation, and so are those of the
/// result. Each piece of a polygon that was cut keeps its styles and its pick identifier, and if
/// the polygon is shaded its place in the shade; sides that cuts made are invisible. A polygon that
/// draws nothing, hollow and of line style none, is left out.
///
/// Throws Error for another method, and for more than 2^32 - 1 points.
SortedInstructions hidden_surface_check(const Instructions& entered,
                                        const ImageTransformation& image, HiddenMethod method,
                                        const SortOptions& options);

/// The same for several segments together, in order of creation, with a segment instruction
/// wherever the segment changes. Of coplanar polygons the one of the segment created later is seen.
SortedInstructions hidden_surface_check(std::span<const Segment* const> segments,
                                        HiddenMethod method, const SortOptions& options);

}  // namespace displayfile
