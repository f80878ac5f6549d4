#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "displayfile/segments/segment.h"
#include "displayfile/segments/sorted_scene.h"
#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

/// True for the methods that work in object space, which HIDDEN-SURFACE-CHECK runs: those that sort
/// polygons and the map, also for the colour rule, and those that find lines.
bool is_object_space(HiddenMethod by);

/// HIDDEN-SURFACE-CHECK (algorithm 9.8): a segment's polygons and lines back to front, by `bsp`,
/// `plain_bsp` or `depth_sort`; by `map` the parts of polygons that are seen, which do not overlap,
/// and after all of them what is seen of lines and sides; or by a method of lines what is seen of
/// its lines and its polygons' sides, and no fills. If the plan has hidden lines, these are drawn
/// dashed: before the visible ones, or after all fills. Points are those after the image
/// transformation, and so are those of the result. Each piece of a polygon that was cut keeps its
/// styles and its pick identifier, and if the polygon is shaded its place in the shade; sides that
/// cuts made are invisible. A polygon that draws nothing, hollow and of line style none, is left
/// out. The instructions must not grow while the result lives.
///
/// Throws Error for another method, and for more than 2^32 - 2 points.
std::shared_ptr<const SortedScene> hidden_surface_check(
    const std::shared_ptr<const Instructions>& entered, const ImageTransformation& image,
    const SurfacePlan& plan);

/// HIDDEN-SURFACE-CHECK of several segments together, in order of creation, with a segment
/// instruction wherever the segment changes. Of coplanar polygons the one of the segment created
/// later is seen.
std::shared_ptr<const SortedScene> hidden_surface_check(std::span<const Segment* const> segments,
                                                        const SurfacePlan& plan);

/// The limit of pieces that is in force for the map, for lines and for all that is no sort: that of
/// the budget, or else the largest number.
std::size_t most_pieces_in_force();

/// True if hidden_surface_check with this plan, and the budget in force, would come to the end that
/// this result of it came to, and not to a limit of pieces. False if that is not known: the scene
/// is to be sorted again.
bool is_within_limit(const SortedScene& sorted, const SurfacePlan& plan);

}  // namespace displayfile
