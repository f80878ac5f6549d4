#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace displayfile {

/// The edit distance of two words: characters to insert, remove or replace, or neighbours to
/// exchange, ignoring case. Symmetric; 0 if they differ only in case.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The known words by edit distance from a word, nearest first; of equal ones the first listed.
std::vector<std::string_view> nearest_words(std::string_view word,
                                            std::span<const std::string_view> known);

/// For messages about an unknown word: " did you mean 'bsp'?", or nothing if no known word is near:
/// within a third of the word's length and at least one character, or with the word as prefix or
/// suffix.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> known);

}  // namespace displayfile
