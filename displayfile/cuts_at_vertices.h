#pragma once

#include "displayfile/viewed_scene.h"
#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

/// A cut that is a vertex of the scene, or an earlier cut, but for what viewing and cutting have
/// rounded, gets its coordinates: a display file then has one number where corners meet, and no
/// cracks of one ulp. Points move by no more than twice ViewedScene::boundary_error in x and y, and
/// to the vertex's depth where theirs is as close. Sides that lose their length are left out, and
/// pieces of which nothing is left. Nothing decides by these numbers any more.
void put_cuts_at_vertices(const ViewedScene& scene, SortedPieces& pieces);

}  // namespace displayfile
