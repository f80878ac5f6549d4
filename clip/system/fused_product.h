#pragma once

namespace displayfile {

/// a * b + c, rounded once: C's fma, which MinGW-w64's library rounds twice (one result in five, by
/// its last digit).
double fused_product(double a, double b, double c);

}  // namespace displayfile
