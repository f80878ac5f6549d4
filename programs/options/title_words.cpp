#include "programs/options/title_words.h"

#include <fmt/format.h>

#include "clip/base/error.h"
#include "displayfile/text/characters.h"

namespace displayfile {

void require_drawable(std::string_view option, std::string_view text) {
  if (const std::size_t good = drawable_length(text); good < text.size()) {
    throw Error(fmt::format("{}: {}", option, not_drawable(text.substr(good))));
  }
}

std::string title_or_name(const std::string& title, const std::string& name) {
  require_drawable("--title", title);
  return title.empty() ? drawable(name) : title;
}

}  // namespace displayfile
