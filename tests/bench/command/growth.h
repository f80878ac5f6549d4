#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace displayfile::bench {

/// The exponent e of the power c * n^e that fits best: the slope of the least-squares line through
/// the logarithms. Two different sizes at least.
inline double fitted_exponent(std::span<const double> sizes, std::span<const double> costs) {
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const double log_size = std::log(sizes[i]), log_cost = std::log(costs[i]);
    x += log_size;
    y += log_cost;
    xx += log_size * log_size;
    xy += log_size * log_cost;
  }
  const auto count = static_cast<double>(sizes.size());
  return (count * xy - x * y) / (count * xx - x * x);
}

/// Sizes from 10^low to 10^high, two a decade.
inline std::vector<std::size_t> sizes_of_growth(int low, int high) {
  std::vector<std::size_t> sizes;
  for (int half = 2 * low; half <= 2 * high; ++half) {
    sizes.push_back(static_cast<std::size_t>(std::llround(std::pow(10.0, 0.5 * half))));
  }
  return sizes;
}

}  // namespace displayfile::bench
