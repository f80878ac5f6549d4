#pragma once

#include "tests/bench/command/report.h"

namespace displayfile::bench {

/// The cost of each feature, off and on (tests/bench/command/features.h), on one scene that is
/// drawn on one thread from the first routine to the picture. Memory is counted in this process,
/// instructions by a valgrind that runs this program; without one, `instructions_not_counted` has
/// the reason. `own` figures are those of functions that only the feature needs, which it may not
/// have: then it is a branch in code that all drawings run.
Json feature_costs();

/// Makes the drawings to be counted, under callgrind, for the command's option
/// `--features-under-callgrind`.
void draw_features_to_be_counted();

}  // namespace displayfile::bench
