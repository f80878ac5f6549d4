#include "clip/words.h"

#include <string>

#include "clip/error.h"
#include "clip/nearest_word.h"

namespace displayfile {

void refuse_word(std::string_view word, std::span<const std::string_view> known,
                 std::string_view expected) {
  std::string message(expected);
  for (std::size_t i = 0; i < known.size(); ++i) {
    message += (i == 0 ? " " : i + 1 < known.size() ? ", " : " or ") + std::string(known[i]);
  }
  message += ", not '" + std::string(word) + "'";
  if (const std::string meant = did_you_mean(word, known); !meant.empty()) message += ":" + meant;
  throw Error(message);
}

}  // namespace displayfile
