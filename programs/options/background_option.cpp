#include "programs/options/background_option.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "clip/base/error.h"
#include "displayfile/looks/colour_words.h"
#include "programs/options/colour_word.h"
#include "programs/options/option_groups.h"

namespace displayfile {

void BackgroundWord::add_to(CLI::App& command) {
  command
      .add_option(
          "--background", word,
          "background colour, overriding the programs' [white]: R,G,B, each 0 to 1, #rrggbb, a "
          "CSS name, or none or transparent, which is transparent in .png and omitted in vectors")
      ->type_name("R,G,B|#rrggbb|white|black|none|transparent")
      ->group(kPictureOptions);
}

void BackgroundWord::add_colour_to(CLI::App& command) {
  may_be_none = false;
  command
      .add_option("--background", word,
                  "background colour, overriding the programs' [white]: R,G,B, each 0 to 1, "
                  "#rrggbb or a CSS name")
      ->type_name("R,G,B|#rrggbb|white|black")
      ->group(kPictureOptions);
}

std::optional<Background> BackgroundWord::background() const {
  if (word.empty()) return std::nullopt;
  const bool is_none = word == "none" || word == "transparent";
  if (may_be_none && is_none) return Background{Background::Kind::none};
  if (const auto colour = colour_of(word)) return Background{Background::Kind::solid, *colour};
  throw Error(fmt::format(
      "--background {}:{} {}", word, is_none ? "" : nearest_colour_name(word),
      may_be_none ? "expected R,G,B, each 0 to 1, #rrggbb, a CSS name, none or transparent"
      : is_none   ? "a picture without alpha: expected R,G,B or a colour's name"
                  : "expected R,G,B, each 0 to 1, #rrggbb or a CSS name"));
}

}  // namespace displayfile
