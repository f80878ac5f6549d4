#include "programs/options/number_list.h"

#include <charconv>
#include <cmath>

namespace displayfile {

std::optional<std::vector<double>> number_list(std::string_view text) {
  std::vector<double> values;
  const char *p = text.data(), *const end = p + text.size();
  for (;;) {
    if (p != end && *p == '+' && p + 1 != end && p[1] != '-') ++p;
    double value = 0.0;
    const auto [stop, failure] = std::from_chars(p, end, value);
    if (failure != std::errc{} || !std::isfinite(value)) return std::nullopt;
    values.push_back(value);
    if (stop == end) return values;
    if (*stop != ',') return std::nullopt;
    p = stop + 1;
  }
}

}  // namespace displayfile
