#include "clip/system/fused_product.h"

#include <cmath>

namespace displayfile {

double fused_product(double a, double b, double c) { return std::fma(a, b, c); }

}  // namespace displayfile
