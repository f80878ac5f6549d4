#include "programs/options/colour_word.h"

#include <algorithm>

#include "displayfile/looks/colour_words.h"
#include "programs/options/number_list.h"

namespace displayfile {

std::optional<Colour> colour_of(std::string_view word) {
  if (const auto colour = colour_of_word(word)) return colour;
  const auto values = number_list(word);
  const auto is_part = [](double c) { return c >= 0.0 && c <= 1.0; };
  if (!values || values->size() != 3 || !std::ranges::all_of(*values, is_part)) return std::nullopt;
  return Colour((*values)[0], (*values)[1], (*values)[2]);
}

}  // namespace displayfile
