#pragma once

#include <cstdint>
#include <vector>

#include "displayfile/segments/viewed_scene.h"
#include "hidden/lines/lines_in_order.h"

namespace displayfile {

// The lines of a viewed scene (hidden/lines/lines_in_order.h): its lines, and its polygons' visible
// sides with a line style.

std::vector<LineToDraw> lines_to_draw(const ViewedScene& scene);
/// For each item a number of its segment and line style, since a stroke does not join different
/// ones. Empty if all are the same.
std::vector<std::uint32_t> looks_of_lines(const ViewedScene& scene);
/// The style of a stroke of an item, not hidden: of a line, or of a polygon's side, or line of
/// intersection, of these kinds.
LineStyle style_of_stroke(const ViewedScene& scene, ViewedScene::Item item, LineKinds kinds);
/// Throws Error for a plan whose method finds no lines.
FoundLines find_lines(const ViewedScene& scene, const SurfacePlan& plan);

/// Joins lines of one segment and line style into chains.
SortedPieces lines_in_order(const ViewedScene& scene, const FoundLines& found,
                            HiddenLines hidden_lines);
SortedPieces lines_beside_sides(const ViewedScene& scene, const FoundLines& found,
                                HiddenLines hidden_lines);

/// The scene's map, and after all fills its lines.
SortedPieces map_in_order(const ViewedScene& scene, const SurfacePlan& plan);

/// Appends to an order of the scene's polygons, after all fills, the plan's lines that no polygon
/// of the order has: hidden ones, and lines of intersection.
void append_lines(const ViewedScene& scene, const SurfacePlan& plan, SortedPieces& sorted);

}  // namespace displayfile
