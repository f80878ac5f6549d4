#include "displayfile/user_routines/ranges.h"

#include <fmt/format.h>

#include <cmath>

#include "clip/base/error.h"

namespace displayfile {

void require_within(const Limit& limit, std::initializer_list<double> values, const char* what) {
  for (double v : values) {
    if (!(std::abs(v) <= limit.most)) {
      throw Error(fmt::format("{} is {}: expected a finite number of magnitude at most {}", what, v,
                              limit.text));
    }
  }
}

void require_finite(std::initializer_list<double> values, const char* what) {
  require_within({kCoordinateLimit, "1e100"}, values, what);
}

void require_colour(const Colour& colour) {
  for (int i = 0; i < 3; ++i) {
    if (!(colour[i] >= 0.0 && colour[i] <= 1.0)) {
      throw Error(fmt::format("colour component {} out of range: expected 0 to 1", colour[i]));
    }
  }
}

}  // namespace displayfile
