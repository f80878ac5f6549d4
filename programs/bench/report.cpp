#include "programs/bench/report.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

namespace displayfile::bench {

double figure(double value) {
  if (!std::isfinite(value)) return value;
  return std::strtod(fmt::format("{:.4g}", value).c_str(), nullptr);
}

Spread figures(const Spread& s) { return {figure(s.least), figure(s.median), figure(s.greatest)}; }

}  // namespace displayfile::bench
