#pragma once

#include <vector>

#include "hidden/lines/strokes_once.h"
#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

class ViewedScene;

/// The strokes of an order of a scene's pieces (SortedPieces::first_stroke and those after it, by
/// numbers from 0) as a picture has them: each place of the strokes of one segment and style once,
/// and those known that join no other (hidden/lines/strokes_once.md).
std::vector<StrokePart> drawn_strokes(const ViewedScene& scene, const SortedPieces& pieces);

}  // namespace displayfile
