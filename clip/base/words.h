#pragma once

#include <cassert>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace displayfile {

/// A value and its word in drawing programs and on the command line.
template <class Value>
struct Word {
  Value value;
  std::string_view word;
};

/// A word for messages: in quotes, a long one shortened between two characters, control characters
/// as ?.
std::string quoted(std::string_view word);

/// Throws Error: "`expected` a, b or c, not 'word'", with a suggestion.
[[noreturn]] void refuse_word(std::string_view word, std::span<const std::string_view> known,
                              std::string_view expected);

/// The value of a word in a table. Throws Error for any other word; the message begins with
/// `expected`.
template <class Value, std::size_t N>
const Value& value_of(const Word<Value> (&words)[N], std::string_view word,
                      std::string_view expected) {
  std::vector<std::string_view> known;
  for (const auto& [value, name] : words) {
    if (name == word) return value;
    known.push_back(name);
  }
  refuse_word(word, known, expected);
}

/// The word of a value, which must be in the table.
template <class Value, std::size_t N>
constexpr std::string_view word_of(const Word<Value> (&words)[N], const Value& value) {
  std::size_t i = 0;
  while (!(words[i].value == value)) {
    ++i;
    assert(i < N);
  }
  return words[i].word;
}

}  // namespace displayfile
