#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "displayfile/segments/segment.h"
#include "displayfile/segments/sorted_scene.h"
#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

/// True for object-space methods, which HIDDEN-SURFACE-CHECK runs: those that sort polygons and the
/// map, also for the colour rule, and those that find lines.
bool is_object_space(HiddenMethod by);

/// HIDDEN-SURFACE-CHECK (algorithm 9.8): a segment's polygons and lines back to front, by `bsp`,
/// `plain_bsp` or `depth_sort`; by `map` the visible parts of polygons, which do not overlap,
/// followed by the visible parts of lines and sides; by a method of lines the visible parts of its
/// lines and polygon sides, without fills. If the plan has hidden lines, these are drawn dashed:
/// before the visible ones, or after all fills. Points are after the image transformation, in the
/// input and the result. Each piece of a cut polygon keeps its styles, its pick identifier and its
/// shading; sides made by cuts are invisible. Polygons that draw nothing, hollow with line style
/// none, are omitted. The instructions must not grow during the result's lifetime.
///
/// Throws Error for another method, and for more than 2^32 - 2 points.
std::shared_ptr<const SortedScene> hidden_surface_check(
    const std::shared_ptr<const Instructions>& entered, const ImageTransformation& image,
    const SurfacePlan& plan);

/// HIDDEN-SURFACE-CHECK of several segments together, in order of creation, with a segment
/// instruction at each change of segment. Of coplanar polygons the one in the segment created later
/// is visible.
std::shared_ptr<const SortedScene> hidden_surface_check(std::span<const Segment* const> segments,
                                                        const SurfacePlan& plan);

/// The limit of pieces in force for the map, for lines and for all else that does not sort: that of
/// the budget, or else the largest number.
std::size_t most_pieces_in_force();

/// True if hidden_surface_check with this plan, and the budget in force, would give this result
/// again rather than reach a limit of pieces. False if unknown: the scene must then be sorted
/// again.
bool is_within_limit(const SortedScene& sorted, const SurfacePlan& plan);

}  // namespace displayfile
