#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/bench/command/side_by_side.h"

namespace displayfile::bench {

/// Figures, keys in the order written (tests/bench/command/bench.md lists them).
using Json = nlohmann::ordered_json;

/// To four digits.
inline double figure(double value) {
  return std::isfinite(value) ? std::strtod(fmt::format("{:.4g}", value).c_str(), nullptr) : value;
}
inline Json figures(const Spread& s) {
  return {
      {"median", figure(s.median)}, {"least", figure(s.least)}, {"greatest", figure(s.greatest)}};
}

/// A method at a precision, on a scene, with a number of threads, before anything is measured of
/// it.
inline Json cell_of(const std::string& scene, const std::string& method,
                    const std::string& precision, int threads, bool exact) {
  return {{"scene", scene},
          {"method", method},
          {"precision", precision},
          {"threads", threads},
          {"exact", exact}};
}

}  // namespace displayfile::bench
