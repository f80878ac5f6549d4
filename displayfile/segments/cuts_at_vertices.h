#pragma once

#include "displayfile/segments/viewed_scene.h"
#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

/// By how much put_cuts_at_vertices moves points along x and y, at most.
double cuts_may_move(const ViewedScene& scene);

/// A cut that is a vertex of the scene, or an earlier cut, but for what viewing and cutting have
/// rounded, gets its coordinates: a display file then has one number where corners meet, and no
/// cracks of one ulp but slivers as wide. Depths are the vertex's where they are as close. Sides
/// that lose their length are left out, and pieces of lines. Nothing decides by these numbers any
/// more.
void put_cuts_at_vertices(const ViewedScene& scene, SortedPieces& pieces);

}  // namespace displayfile
