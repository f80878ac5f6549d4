#include "clip/base/error.h"
#include "programs/surface/expression.h"

namespace displayfile {

bool reads_expressions() { return false; }

std::vector<double> heights_of(const std::string& expression, const GridRange&,
                               const WorkProgress&) {
  throw Error("expression '" + expression +
              "': this build has no muParser, which reads expressions: expected a grid of heights, "
              ".npy, .txt or .csv");
}

}  // namespace displayfile
