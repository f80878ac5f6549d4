#pragma once

#include <initializer_list>
#include <vector>

#include "programs/scenes/hard_cases.h"

namespace displayfile {

// The parts of the table of hard cases, by difficulty. Each is in the file of its name, after its
// generators, which are that file's own. A case is a line: name, description, meaning of the
// severity, size, severities, generator, difficulty.

std::vector<HardCase> coplanar_families();    ///< polygons that lie in one plane
std::vector<HardCase> gap_families();         ///< a gap that shrinks
std::vector<HardCase> cycle_families();       ///< cyclic overlap
std::vector<HardCase> crossing_families();    ///< polygons that pass through each other
std::vector<HardCase> touching_families();    ///< shared edges and vertices
std::vector<HardCase> coverage_families();    ///< which centres are covered
std::vector<HardCase> degenerate_families();  ///< polygons whose vertices or edges coincide
std::vector<HardCase> shape_families();       ///< no simple convex shapes
std::vector<HardCase> scale_families();       ///< coordinates of unlike sizes
std::vector<HardCase> view_families();        ///< perspective and oblique views
std::vector<HardCase> contact_families();     ///< touching parts as people draw them, in any view

/// The gaps of the table; the sweep has its own.
inline constexpr std::initializer_list<double> kGaps{3, 6, 9, 12, 15};

}  // namespace displayfile
