#include "programs/hidden_surface_words.h"

#include "hidden/exact/precision.h"
#include "programs/option_groups.h"

namespace displayfile {

void HiddenSurfaceWords::add_to(CLI::App& command) {
  std::string methods;
  for (const auto& entry : hidden_methods()) {
    if (entry.available) methods.append(" ").append(entry.name);
  }
  command
      .add_option("--hidden", hidden, "hidden-surface method in place of the program's:" + methods)
      ->group(kHiddenSurfaceOptions);
  command
      .add_option("--scope", scope, "sort each segment, or all visible ones together: segment all")
      ->group(kHiddenSurfaceOptions);
  command
      .add_option("--precision", precision,
                  "exact, roundoff or roundoff=EPS; exact unless a program sets another")
      ->group(kHiddenSurfaceOptions);
  command
      .add_option("--hidden-lines", hidden_lines,
                  "lines where they are hidden: none dashed; by the methods that find lines, and "
                  "over what bsp and depth-sort put in order")
      ->group(kHiddenSurfaceOptions);
}

HiddenSurfaceOptions HiddenSurfaceWords::options(int threads) const {
  HiddenSurfaceOptions read;
  read.threads = threads;
  if (!hidden.empty()) read.method = hidden_method(hidden);
  if (!scope.empty()) read.scope = hidden_scope(scope);
  if (!precision.empty()) read.precision = displayfile::precision(precision);
  if (!hidden_lines.empty()) read.hidden_lines = displayfile::hidden_lines(hidden_lines);
  return read;
}

}  // namespace displayfile
