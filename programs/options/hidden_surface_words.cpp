#include "programs/options/hidden_surface_words.h"

#include "clip/base/error.h"
#include "clip/surfaces.h"
#include "programs/options/option_groups.h"

namespace displayfile {

void HiddenSurfaceWords::add_to(CLI::App& command) {
  std::string methods;
  for (const auto& entry : hidden_methods()) {
    methods.append(" ").append(entry.name);
  }
  methods.append(" colour-rule=METHOD bsp=last|first|sample|free (the root of a tree)");
  command
      .add_option("--hidden", hidden, "hidden-surface method in place of the program's:" + methods)
      ->type_name("METHOD")
      ->group(kHiddenSurfaceOptions);
  command.add_option("--scope", scope, "sort each segment, or all visible ones together")
      ->type_name("segment|all")
      ->group(kHiddenSurfaceOptions);
  command
      .add_option("--precision", precision,
                  "of the methods' decisions; exact unless a program sets another")
      ->type_name("exact|roundoff[=EPS]")
      ->group(kHiddenSurfaceOptions);
  command
      .add_option(
          "--lines", lines,
          "which sides of polygons are lines, in place of the programs' setting, for any method; "
          "with commas between several: all (those that the line style shows), outline, boundary "
          "(sides of one polygon), crease or crease=DEGREES (sides at which two turn by more; 30), "
          "intersection, material (sides at which fills differ)")
      ->type_name("KIND,...")
      ->group(kHiddenSurfaceOptions);
  command
      .add_option("--hidden-lines", hidden_lines,
                  "hidden parts of lines; by the methods of hidden lines, and over fills")
      ->type_name("none|dashed")
      ->group(kHiddenSurfaceOptions);
  add_touching_option(command, touching);
}

void add_touching_option(CLI::App& command, std::optional<std::string>& touching) {
  command
      .add_option("--touching", touching,
                  "the distance within which polygons touch, in place of the programs' setting: a "
                  "polygon that touches a plane lies in it, and of polygons in one plane the one "
                  "entered later is visible; auto (by the precision of the numbers), off, or a "
                  "length in the coordinates of the input")
      ->type_name("auto|off|LENGTH")
      ->group(kHiddenSurfaceOptions);
}

Touching touching_of_option(const std::string& word) {
  try {
    return touching(word);
  } catch (const Error& error) {
    throw Error("--touching: " + std::string(error.what()));
  }
}

std::optional<Touching> HiddenSurfaceWords::touching_in_force() const {
  if (!touching) return std::nullopt;
  return touching_of_option(*touching);
}

HiddenSurfaceOptions HiddenSurfaceWords::options(int threads) const {
  HiddenSurfaceOptions read;
  read.threads = threads;
  constexpr std::string_view kOfTree = "bsp=";
  if (hidden.starts_with(kOfTree)) {
    read.method = HiddenMethod::bsp;
    read.root = root_choice(std::string_view(hidden).substr(kOfTree.size()));
  } else if (!hidden.empty()) {
    read.method = hidden_method(hidden);
  }
  if (!scope.empty()) read.scope = hidden_scope(scope);
  if (!precision.empty()) read.precision = displayfile::precision(precision);
  if (!hidden_lines.empty()) read.hidden_lines = displayfile::hidden_lines(hidden_lines);
  return read;
}

LineSelection line_selection_of_option(const std::string& words) {
  try {
    return line_selection(words);
  } catch (const Error& error) {
    throw Error("--lines: " + std::string(error.what()));
  }
}

std::optional<LineSelection> HiddenSurfaceWords::line_selection() const {
  if (!lines) return std::nullopt;
  return line_selection_of_option(*lines);
}

}  // namespace displayfile
