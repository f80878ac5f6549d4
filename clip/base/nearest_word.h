#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace displayfile {

/// How many characters to insert, remove or replace, or neighbours to exchange, to turn one word
/// into the other, whatever their case. edit_distance(a, b) = edit_distance(b, a); 0 if they differ
/// in case alone.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The known words by their edit distance from a word, the nearest first, of equal ones the first.
std::vector<std::string_view> nearest_words(std::string_view word,
                                            std::span<const std::string_view> known);

/// For messages about an unknown word: " did you mean 'bsp'?", or nothing if no known word is near:
/// within a third of the word's length, at least one character, or one that it is the start or the
/// end of.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> known);

}  // namespace displayfile
