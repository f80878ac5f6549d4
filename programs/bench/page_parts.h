#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "programs/bench/analysis.h"
#include "programs/bench/report.h"
#include "programs/bench/svg_plot.h"

namespace displayfile::bench {

/// A contender's mark in plots of all of them: the colour is the method's, the shape the
/// precision's; exact ones are filled.
Mark mark_of(const std::vector<Column>& all, const Column& column);

/// A row of a table of HTML, whose cells are th or td.
std::string table_row(std::string_view tag, const std::vector<std::string>& cells);

/// The median, the least and the greatest as what stands in three cells of a row.
std::string spread_cells(const Spread& s);

/// The row of a cell's figures: as far as it is the same whatever was measured, and one that says
/// why nothing was, across so many columns.
std::string row_begun(const Cell& cell);
std::string row_skipped(const Cell& cell, int columns);

}  // namespace displayfile::bench
