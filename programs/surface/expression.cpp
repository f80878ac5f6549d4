#include "programs/surface/expression.h"

#include <fmt/format.h>
#include <muParser.h>

#include <cstddef>
#include <numbers>

#include "clip/error.h"

namespace displayfile {

bool reads_expressions() { return true; }

/// Row by row, so that the values of x are written once.
std::vector<double> heights_of(const std::string& expression, const GridRange& grid) {
  const auto columns = static_cast<std::size_t>(grid.x_points);
  std::vector<double> xs(columns), ys(columns),
      heights(columns * static_cast<std::size_t>(grid.y_points));
  for (int i = 0; i < grid.x_points; ++i) xs[static_cast<std::size_t>(i)] = grid.x(i);
  try {
    mu::Parser parser;
    parser.DefineConst("pi", std::numbers::pi);
    parser.DefineConst("e", std::numbers::e);
    parser.DefineVar("x", xs.data());
    parser.DefineVar("y", ys.data());
    parser.SetExpr(expression);
    for (int j = 0; j < grid.y_points; ++j) {
      ys.assign(columns, grid.y(j));
      parser.Eval(heights.data() + static_cast<std::size_t>(j) * columns, grid.x_points);
    }
  } catch (const mu::Parser::exception_type& error) {
    throw Error(
        fmt::format("expression '{}': at character {}: {}: expected an expression in x and y",
                    expression, error.GetPos() + 1, error.GetMsg()));
  }
  return heights;
}

}  // namespace displayfile
