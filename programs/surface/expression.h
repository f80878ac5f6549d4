#pragma once

#include <string>
#include <vector>

#include "clip/base/work_progress.h"
#include "programs/surface/surface_data.h"

namespace displayfile {

/// True if this build can read expressions.
bool reads_expressions();

/// The heights of an expression in x and y over a grid; NaN where it has no value. Throws Error for
/// an invalid expression, with the position in it and what was expected.
std::vector<double> heights_of(const std::string& expression, const GridRange& grid,
                               const WorkProgress& progress);

}  // namespace displayfile
