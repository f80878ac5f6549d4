#pragma once

#include <optional>
#include <string>

#include "programs/bench/report.h"

namespace displayfile::bench {

/// The report as one HTML page that needs nothing else: a plot of all, tables, which method to use
/// when, small plots, and every figure of the JSON.
std::string html_page(const Report& report);

/// The plot that the page begins with, as an SVG file: all methods and peers, speed against error.
/// Nothing if there is no scene that all of them were measured on.
std::optional<std::string> front_plot(const Report& report);

}  // namespace displayfile::bench
