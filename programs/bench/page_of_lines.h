#pragma once

#include <string>

#include "programs/bench/report.h"

namespace displayfile::bench {

/// What the page (page.h) says of hidden lines: their speed against their error as plots, of all
/// scenes but surfaces and of these, nothing if none were measured; their tables are among those
/// that a README's blocks hold (summary.h).
std::string lines_plot(const Report& report);

/// Every figure of lines, a table a scene.
std::string figures_of_lines(const Report& report);

}  // namespace displayfile::bench
