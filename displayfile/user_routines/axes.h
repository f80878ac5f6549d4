#pragma once

#include <string>
#include <vector>

namespace displayfile {

/// The numbers from low to high (low < high) at which an axis has ticks: multiples of the least of
/// 1, 2 and 5 times a power of ten that gives at most this many steps.
std::vector<double> axis_ticks(double low, double high, int most_steps);
/// The label of such a number, with a minus sign instead of the hyphen.
std::string axis_number(double value);

}  // namespace displayfile
