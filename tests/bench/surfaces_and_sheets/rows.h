#pragma once

#include <span>
#include <string>
#include <vector>

#include "programs/bench/process.h"
#include "tests/bench/result_table.h"

namespace displayfile::bench {

/// How much is measured.
struct TableOptions {
  std::vector<std::string> meshes;
  int rounds = 3;
  int grids = 200;     ///< random surfaces
  int size = 500;      ///< points each way beside gnuplot
  int most = 2000;     ///< points each way of growth
  double limit = 300;  ///< seconds that OpenCASCADE may take to be ready, and for a view
};

/// The least costs of some rounds of a whole process. Throws Error if it fails.
Cost least_cost(const std::vector<std::string>& command, int rounds);

/// Surfaces beside gnuplot's, how they grow, and beside the truth (surface_rows.cpp).
void add_surface_rows(const TableOptions& options, std::vector<Result>& results);
/// The sheet of each mesh beside OpenCASCADE (sheet_rows.cpp).
void add_sheet_rows(const TableOptions& options, std::vector<Result>& results);
/// The areas of sections of each closed mesh (section_rows.cpp).
void add_section_rows(const TableOptions& options, std::vector<Result>& results);

}  // namespace displayfile::bench
