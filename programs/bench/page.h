#pragma once

#include <string>

#include "programs/bench/report.h"

namespace displayfile::bench {

/// The report as one HTML page that needs nothing else: which method to use when, plots in SVG, and
/// every figure of the JSON in tables.
std::string html_page(const Report& report);

}  // namespace displayfile::bench
