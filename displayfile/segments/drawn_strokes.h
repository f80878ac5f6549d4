#pragma once

#include <vector>

#include "clip/point.h"
#include "hidden/lines/lines_in_order.h"
#include "hidden/lines/strokes_once.h"
#include "hidden/lines/visible_lines.h"
#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

class ViewedScene;
struct SurfacePlan;

/// The strokes of a sorted scene (SortedPieces::first_stroke and those after it, by numbers from 0)
/// as drawn in a picture: each position of the strokes of one segment and style once, with isolated
/// strokes marked (hidden/lines/strokes_once.md).
std::vector<StrokePart> drawn_strokes(const ViewedScene& scene, const SortedPieces& pieces);

/// Puts those parts into the order of depth, after the hidden ones, and cuts them where that needs
/// it or a halo leaves them out (hidden/lines/strokes_by_depth.h). A part that a halo leaves
/// between two gaps is alone.
void put_by_depth(const ViewedScene& scene, const SortedPieces& pieces, const SurfacePlan& plan,
                  std::vector<StrokePart>& parts);

/// The visible lines of a scene as drawn in a picture: each position once, without crumbs. `pixels`
/// is the picture's size in the unit of widths; 0: crumbs are drawn too.
std::vector<VisiblePiece> pieces_of_picture(const ViewedScene& scene, const FoundLines& found,
                                            const Point2& pixels);

}  // namespace displayfile
