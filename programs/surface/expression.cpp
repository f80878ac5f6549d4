#include "programs/surface/expression.h"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <string>
#include <string_view>

#include "clip/base/error.h"

namespace displayfile {

namespace {

/// The library's message without its own place, which counts from 0.
std::string without_position(std::string message) {
  for (const char* const place : {" found at position ", " at position "}) {
    if (const std::size_t at = message.rfind(place); at != std::string::npos) message.resize(at);
  }
  while (message.ends_with('.')) message.pop_back();
  return message;
}

/// Where an = stands that gives a variable a value, and is of no comparison.
std::size_t assignment_in(const std::string& expression) {
  for (std::size_t i = 0; i < expression.size(); ++i) {
    if (expression[i] != '=') continue;
    if (expression.compare(i, 2, "==") == 0) {
      ++i;
    } else if (i == 0 ||
               std::string_view("<>!").find(expression[i - 1]) == std::string_view::npos) {
      return i;
    }
  }
  return std::string::npos;
}

/// The library takes the last of several expressions, and lets them assign.
void require_one_value(const std::string& expression, const mu::Parser& parser) {
  if (const std::size_t at = assignment_in(expression); at != std::string::npos) {
    throw Error(
        fmt::format("expression '{}': at character {}: an assignment: expected an expression "
                    "in x and y, with == to compare",
                    expression, at + 1));
  }
  int values = 0;
  parser.Eval(values);
  if (values == 1) return;
  throw Error(
      fmt::format("expression '{}': {} expressions with commas between them: expected one "
                  "in x and y, with points in its numbers",
                  expression, values));
}

}  // namespace

bool reads_expressions() { return true; }

/// A point at a time: the library's own way of doing many at once has threads that wait for each
/// other after each row, and takes many times as long where the machine has other work.
std::vector<double> heights_of(const std::string& expression, const GridRange& grid,
                               const WorkProgress& progress) {
  std::vector<double> heights;
  try {
    double x = 0.0, y = 0.0;
    mu::Parser parser;
    parser.DefineConst("pi", std::numbers::pi);
    parser.DefineConst("e", std::numbers::e);
    parser.DefineVar("x", &x);
    parser.DefineVar("y", &y);
    parser.SetExpr(expression);
    require_one_value(expression, parser);
    heights.reserve(grid.points());
    CountedWork work(progress, static_cast<std::size_t>(grid.y_points));
    for (int j = 0; j < grid.y_points; ++j) {
      y = grid.y(j);
      for (int i = 0; i < grid.x_points; ++i) {
        x = grid.x(i);
        heights.push_back(parser.Eval());
      }
      work.add(1);
    }
  } catch (const mu::Parser::exception_type& error) {
    const char* const powers =
        expression.find("**") != std::string::npos ? ", with ^ for powers" : "";
    // The library counts a blank that it adds.
    const std::size_t at = std::min(static_cast<std::size_t>(error.GetPos()), expression.size());
    throw Error(
        fmt::format("expression '{}': at character {}: {}: expected an expression in x and y{}",
                    expression, at + 1, without_position(error.GetMsg()), powers));
  }
  return heights;
}

}  // namespace displayfile
