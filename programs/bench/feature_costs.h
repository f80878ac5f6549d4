#pragma once

#include "programs/bench/report.h"

namespace displayfile::bench {

/// What each feature costs when it is off and when it is on (programs/bench/features.h). Memory is
/// counted in this process, instructions by a valgrind that runs this program; without one the
/// report says so.
FeatureCosts feature_costs();

/// Draws all that is counted, for callgrind to look on. What the command's option
/// `--features-under-callgrind` does.
void draw_features_to_be_counted();

}  // namespace displayfile::bench
