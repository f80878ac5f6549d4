#pragma once

#include "displayfile/segments/viewed_scene.h"
#include "hidden/map/visible_map.h"
#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

/// The pieces of a scene's map, as of pieces_of_map, each lit or in shadow by SortedPieces::lights
/// (displayfile/segments/lit_parts.md). The scene shows shadows; `items` are its own. Device
/// coordinates.
SortedPieces lit_pieces_of_map(const ViewedScene& scene, const Primitives& items,
                               const MapOptions& options);

}  // namespace displayfile
