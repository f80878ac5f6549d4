#pragma once

#include "tests/bench/command/report.h"

namespace displayfile::bench {

/// What each feature costs when it is off and when it is on (tests/bench/command/features.h), on
/// one scene that is drawn on one thread from the first routine to the picture. Memory is counted
/// in this process, instructions by a valgrind that runs this program; without one
/// `instructions_not_counted` says why. `own` figures are those of functions that only the feature
/// needs, which it may not have: then it is a branch in what all drawings run through.
Json feature_costs();

/// Draws all that is counted, for callgrind to look on. What the command's option
/// `--features-under-callgrind` does.
void draw_features_to_be_counted();

}  // namespace displayfile::bench
