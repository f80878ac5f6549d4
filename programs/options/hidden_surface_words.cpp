#include "programs/options/hidden_surface_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/nearest_word.h"
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
      .add_option("--hidden", hidden, "hidden-surface method, overriding the program's:" + methods)
      ->type_name("METHOD")
      ->group(kHiddenSurfaceOptions);
  command
      .add_option(
          "--scope", scope,
          "sort each segment by itself, or all visible segments together [all with --hidden and "
          "where the method is automatic, otherwise segment, unless a program sets another]")
      ->type_name("segment|all")
      ->group(kHiddenSurfaceOptions);
  command
      .add_option("--precision", precision,
                  "precision of the methods [exact, unless a program sets another]")
      ->type_name("exact|roundoff[=EPS]")
      ->group(kHiddenSurfaceOptions);
  command
      .add_option(
          "--lines", lines,
          "kinds of polygon sides drawn as lines, overriding programs, for every method; separated "
          "by commas: all (those that the line style shows), outline, boundary (sides of one "
          "polygon), crease or crease=DEGREES (sides between polygons that meet at a greater "
          "angle; 30), intersection, material (sides between different fills), and hidden (hidden "
          "parts of lines). KIND=WIDTH sets a width, in pixels, in mm with --paper, or with a unit "
          "(0.35mm, 1pt, 2px); after it, separated by blanks, solid or dashed [DASH GAP], and a "
          "colour: outline=0.5,hidden='0.13 dashed'. crease=NUMBER is a width below 5")
      ->type_name("KIND,...")
      ->group(kHiddenSurfaceOptions);
  command
      .add_option("--hidden-lines", hidden_lines,
                  "draw hidden parts of lines dashed; for methods that find lines, and over fills")
      ->type_name("none|dashed")
      ->group(kHiddenSurfaceOptions);
  add_touching_option(command, touching);
}

void add_touching_option(CLI::App& command, std::optional<std::string>& touching) {
  command
      .add_option("--touching", touching,
                  "distance within which polygons touch, overriding programs: a polygon that "
                  "touches a plane is taken to lie in it, and of coplanar polygons the one entered "
                  "last is visible; auto (from the precision of the numbers), off, or a length in "
                  "the coordinates of the input")
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

HiddenMethod method_among(const std::string& word, std::span<const HiddenMethod> taken,
                          std::string_view lack) {
  std::vector<std::string_view> names;
  for (const HiddenMethod method : taken) names.push_back(name_of(method));
  const auto found = std::ranges::find(names, word);
  if (found != names.end()) return taken[static_cast<std::size_t>(found - names.begin())];
  const auto entry = std::ranges::find(hidden_methods(), word, &HiddenMethodEntry::name);
  const bool is_known = entry != hidden_methods().end() || word.starts_with("colour-rule=");
  throw Error(is_known ? fmt::format("--hidden {}: {}: expected one of {}", word, lack,
                                     fmt::join(names, " "))
                       : fmt::format("unknown hidden-surface method '{}':{} expected one of {}",
                                     word, did_you_mean(word, names), fmt::join(names, " ")));
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
  if (const auto words = line_words(); words && words->draws_hidden()) {
    if (read.hidden_lines == HiddenLines::none) {
      throw Error("--lines " + *lines + ": hidden lines are not drawn with --hidden-lines none");
    }
    read.hidden_lines = HiddenLines::dashed;
  }
  return read;
}

LineSelection line_selection_of_option(const std::string& words) {
  const LineWords read(words);
  if (read.has_styles() || !read.selection()) {
    throw Error("--lines " + words +
                ": styles of kinds and hidden lines are options of draw and dump: expected kinds "
                "alone");
  }
  return *read.selection();
}

std::optional<LineWords> HiddenSurfaceWords::line_words() const {
  if (!lines) return std::nullopt;
  return LineWords(*lines);
}

std::optional<LineSelection> HiddenSurfaceWords::line_selection() const {
  if (!lines) return std::nullopt;
  return line_selection_of_option(*lines);
}

}  // namespace displayfile
