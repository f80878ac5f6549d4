#pragma once

#include <string>
#include <vector>

#include "programs/bench/report.h"

namespace displayfile::bench {

/// Which method to use for a purpose, and why, from the figures of a report alone.
struct Advice {
  std::string purpose, use;
  std::string reason;  ///< short
  std::vector<std::string> why;
};

/// Only of purposes that the report has figures for.
std::vector<Advice> advice(const Report& report);

}  // namespace displayfile::bench
