#pragma once

#include "displayfile/segments/viewed_scene.h"
#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

/// The largest distance in x and y by which put_cuts_at_vertices moves points.
double cuts_may_move(const ViewedScene& scene);

/// Moves each cut point that equals a vertex of the scene, or an earlier cut, up to the rounding of
/// viewing and cutting, to its coordinates, so that a display file has one number where corners
/// meet, and no cracks of one ulp except slivers of that width. Depths become the vertex's where
/// they are as close. Sides and pieces of lines that lose their length are removed. No later
/// decision uses these numbers.
void put_cuts_at_vertices(const ViewedScene& scene, SortedPieces& pieces);

}  // namespace displayfile
