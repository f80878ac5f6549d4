#pragma once

#include <string>
#include <vector>

namespace displayfile {

/// The numbers from low to high (low < high) at which an axis has ticks: multiples of the least of
/// 1, 2 and 5 times a power of ten that makes so many steps at most.
std::vector<double> axis_ticks(double low, double high, int most_steps);
/// Such a number as it stands at an axis, with a minus sign in place of the hyphen.
std::string axis_number(double value);

}  // namespace displayfile
