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

namespace {

void add_lines_option(CLI::App& command, std::optional<LineWords>& lines, LineWords::Takes taken) {
  const bool with_styles = taken == LineWords::Takes::styles;
  const auto read = [taken](const std::string& words) { return LineWords(words, taken); };
  std::string description =
      "kinds of polygon sides drawn as lines, overriding programs, for every method; separated by "
      "commas: all (those that the line style shows), outline, boundary (sides of one polygon), "
      "crease or crease=DEGREES (sides between polygons that meet at a greater angle; 30), "
      "intersection, material (sides between different fills)";
  if (with_styles) {
    description +=
        ", and hidden (hidden parts of lines). KIND=WIDTH sets a width, in pixels, in mm with "
        "--paper, or with a unit (0.35mm, 1pt, 2px); after it, separated by blanks, solid or "
        "dashed [DASH GAP], and a colour: outline=0.5,hidden='0.13 dashed'. hatch=WIDTH is the "
        "style of hatched cut faces. crease=NUMBER is a width below 5";
  }
  add_word_option(command, "--lines", lines, read, description)
      ->type_name(with_styles ? "STYLED-KIND,..." : "KIND,...")
      ->group(kHiddenSurfaceOptions);
}

}  // namespace

void HiddenSurfaceWords::add_to(CLI::App& command, LineWords::Takes lines_taken) {
  std::string methods;
  for (const auto& entry : hidden_methods()) {
    methods.append(" ").append(entry.name);
  }
  methods.append(" colour-rule=METHOD bsp=last|first|sample|free (the root of a tree)");
  const auto read_method = [this](const std::string& word) {
    constexpr std::string_view kOfTree = "bsp=";
    if (!word.starts_with(kOfTree)) return hidden_method(word);
    surfaces.root = root_choice(std::string_view(word).substr(kOfTree.size()));
    return HiddenMethod::bsp;
  };
  add_word_option(command, "--hidden", surfaces.method, read_method,
                  "hidden-surface method, overriding the program's:" + methods)
      ->type_name("METHOD")
      ->group(kHiddenSurfaceOptions);
  add_word_option(
      command, "--scope", surfaces.scope, hidden_scope,
      "sort each segment by itself, or all visible segments together [all with --hidden and "
      "where the method is automatic, otherwise segment, unless a program sets another]")
      ->type_name("segment|all")
      ->group(kHiddenSurfaceOptions);
  add_word_option(command, "--precision", surfaces.precision, precision,
                  "precision of the methods [exact, unless a program sets another]")
      ->type_name("exact|roundoff[=EPS]")
      ->group(kHiddenSurfaceOptions);
  add_lines_option(command, lines, lines_taken);
  add_word_option(command, "--hidden-lines", surfaces.hidden_lines, hidden_lines,
                  "draw hidden parts of lines dashed; for methods that find lines, and over fills")
      ->type_name("none|dashed")
      ->group(kHiddenSurfaceOptions);
  add_touching_option(command, touching);
}

void add_touching_option(CLI::App& command, std::optional<Touching>& touching) {
  const auto read = [](const std::string& word) {
    try {
      return displayfile::touching(word);
    } catch (const Error& error) {
      throw Error("--touching: " + std::string(error.what()));
    }
  };
  add_word_option(command, "--touching", touching, read,
                  "distance within which polygons touch, overriding programs: a polygon that "
                  "touches a plane is taken to lie in it, and of coplanar polygons the one entered "
                  "last is visible; auto (from the precision of the numbers), off, or a length in "
                  "the coordinates of the input")
      ->type_name("auto|off|LENGTH")
      ->group(kHiddenSurfaceOptions);
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

HiddenSurfaceOptions HiddenSurfaceWords::options() const {
  HiddenSurfaceOptions all = surfaces;
  if (!lines || !lines->draws_hidden()) return all;
  if (all.hidden_lines == HiddenLines::none) {
    throw Error("--lines " + lines->text() +
                ": hidden lines are not drawn with --hidden-lines none");
  }
  all.hidden_lines = HiddenLines::dashed;
  return all;
}

LineSelection selection_of(const LineWords& lines) {
  if (lines.has_styles() || !lines.selection()) {
    throw Error("--lines " + lines.text() +
                ": styles of kinds and hidden lines are options of draw and dump: expected kinds "
                "alone");
  }
  return *lines.selection();
}

std::optional<LineSelection> HiddenSurfaceWords::line_selection() const {
  if (!lines) return std::nullopt;
  return selection_of(*lines);
}

}  // namespace displayfile
