#include "clip/words.h"

#include "clip/error.h"
#include "clip/nearest_word.h"

namespace displayfile {

std::string quoted(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  if (word.size() <= kLongest) return "'" + std::string(word) + "'";
  std::size_t length = kLongest;
  while (length > 0 && (static_cast<unsigned char>(word[length]) & 0xC0) == 0x80) --length;
  return "'" + std::string(word.substr(0, length)) + "...'";
}

void refuse_word(std::string_view word, std::span<const std::string_view> known,
                 std::string_view expected) {
  std::string message(expected);
  for (std::size_t i = 0; i < known.size(); ++i) {
    message += (i == 0 ? " " : i + 1 < known.size() ? ", " : " or ") + std::string(known[i]);
  }
  message += ", not " + quoted(word);
  if (const std::string meant = did_you_mean(word, known); !meant.empty()) message += ":" + meant;
  throw Error(message);
}

}  // namespace displayfile
