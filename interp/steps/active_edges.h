#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "interp/steps/step_items.h"
#include "interp/steps/step_record.h"
#include "interp/visibility/plain_scan_line.h"

namespace displayfile {

/// The active edge list of a row as shown in steps.
using ActiveEdgesOfRow = std::span<const ActiveEdgeList::Edge>;

/// Rows of a table: polygon, x of the crossing in pixels, its change per row, last row, IN or OUT
/// from there on. Edges first <= k < end are marked active; of a long list, only those around them
/// are shown.
inline constexpr std::string_view kEdgeColumns = "polygon|x|change of x|last row|flag";
std::vector<StepRow> rows_of(const StepItems& scene, const StepRecord& record,
                             ActiveEdgesOfRow edges, std::size_t first = 0, std::size_t end = 0);

/// The runs of pixels in which the polygons are IN on this row, in order of entry.
std::vector<StepRun> runs_of(const StepItems& scene, ActiveEdgesOfRow edges, int row);

/// The runs as a profile of the row.
std::vector<StepSegment> profile_of(const StepItems& scene, const std::vector<StepRun>& runs);

/// The sides of active edges over the picture, to be marked.
void mark_edges(StepRecord& record, ActiveEdgesOfRow edges);

}  // namespace displayfile
