#include "programs/bench/report.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

namespace displayfile::bench {

double figure(double value) {
  if (!std::isfinite(value)) return value;
  return std::strtod(fmt::format("{:.4g}", value).c_str(), nullptr);
}

}  // namespace displayfile::bench
