#include "displayfile/solids/combining_steps.h"

#include <fmt/format.h>

#include "clip/base/error.h"

namespace displayfile {

void CountedSteps::fail() const {
  throw Error(
      fmt::format("{} is not found in {} steps: expected parts that meet in fewer places, or of "
                  "fewer polygons",
                  what_, most_));
}

}  // namespace displayfile
