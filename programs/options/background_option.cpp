#include "programs/options/background_option.h"

#include <CLI/CLI.hpp>

#include "clip/base/error.h"
#include "programs/options/colour_word.h"
#include "programs/options/option_groups.h"

namespace displayfile {

void BackgroundWord::add_to(CLI::App& command) {
  command
      .add_option(
          "--background", word,
          "background colour, overriding the programs' [white]: R,G,B, each 0 to 1, #rrggbb, "
          "white, black, or none, which is transparent in .png and omitted in vectors")
      ->type_name("R,G,B|#rrggbb|white|black|none")
      ->group(kPictureOptions);
}

std::optional<Background> BackgroundWord::background() const {
  if (word.empty()) return std::nullopt;
  if (word == "none") return Background{Background::Kind::none};
  if (const auto colour = colour_of(word)) return Background{Background::Kind::solid, *colour};
  throw Error("--background " + word +
              ": expected R,G,B, each 0 to 1, #rrggbb, white, black, or none");
}

}  // namespace displayfile
