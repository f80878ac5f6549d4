#pragma once

#include <span>
#include <vector>

#include "displayfile/segments/segment.h"

namespace displayfile {

/// Connected components of segments that overlap in the projection: no segment hides anything of
/// another group. By their extents, after the image transformations, lines without their width.
using SegmentGroup = std::vector<const Segment*>;

/// The segments in groups; both keep the input order, groups by their first segment.
std::vector<SegmentGroup> overlapping_groups(std::span<const Segment* const> segments);

}  // namespace displayfile
