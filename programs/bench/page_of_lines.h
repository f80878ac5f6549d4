#pragma once

#include <string>

#include "programs/bench/report.h"

namespace displayfile::bench {

/// What the page (page.h) says of hidden lines: their speed against their error as a plot, nothing
/// if none were measured; their table is among those that a README's blocks hold (summary.h).
std::string lines_plot(const Report& report);

/// Every figure of lines, a table a scene.
std::string figures_of_lines(const Report& report);

}  // namespace displayfile::bench
