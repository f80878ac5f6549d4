#pragma once

#include <span>
#include <vector>

#include "displayfile/segments/segment.h"

namespace displayfile {

/// Segments of which each overlaps another of its group in the projection, or one that overlaps
/// one, and so on: no segment hides anything of another group. By their extents, after the image
/// transformations, lines without their width.
using SegmentGroup = std::vector<const Segment*>;

/// The segments in groups; both keep the order given, groups by their first segment.
std::vector<SegmentGroup> overlapping_groups(std::span<const Segment* const> segments);

}  // namespace displayfile
