#pragma once

#include <string>

#include "programs/bench/report.h"

namespace displayfile::bench {

/// For the terminal: a table for each name of a scene, at its largest number of polygons, and one
/// of all hard cases together.
std::string text_report(const Report& report);

}  // namespace displayfile::bench
