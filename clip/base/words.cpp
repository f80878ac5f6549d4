#include "clip/base/words.h"

#include "clip/base/error.h"
#include "clip/base/nearest_word.h"

namespace displayfile {

std::string quoted(std::string_view word) {
  constexpr std::size_t kMostShown = 40;
  const bool is_short = word.size() <= kMostShown;
  std::size_t length = is_short ? word.size() : kMostShown;
  while (!is_short && length > 0 && (static_cast<unsigned char>(word[length]) & 0xC0) == 0x80) {
    --length;
  }
  std::string text("'");
  for (const char c : word.substr(0, length)) {
    const bool is_control = static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
    text += is_control ? '?' : c;
  }
  return text += is_short ? "'" : "...'";
}

void refuse_word(std::string_view word, std::span<const std::string_view> known,
                 std::string_view expected) {
  std::string message(expected);
  for (std::size_t i = 0; i < known.size(); ++i) {
    message.append(i == 0 ? " " : i + 1 < known.size() ? ", " : " or ").append(known[i]);
  }
  message.append(", not ").append(quoted(word));
  if (const std::string meant = did_you_mean(word, known); !meant.empty()) {
    message.append(":").append(meant);
  }
  throw Error(message);
}

}  // namespace displayfile
