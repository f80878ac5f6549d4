#include "clip/base/nearest_word.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace displayfile {

namespace {

constexpr std::size_t kLongest = 64;  // characters of a word that are compared

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1), before(b.size() + 1), two_before;
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    two_before = std::exchange(before, row);
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const bool same = lower(a[i]) == lower(b[j]);
      row[j + 1] = std::min({before[j + 1] + 1, row[j] + 1, before[j] + (same ? 0 : 1)});
      const bool exchanged =
          i > 0 && j > 0 && lower(a[i]) == lower(b[j - 1]) && lower(a[i - 1]) == lower(b[j]);
      if (exchanged) row[j + 1] = std::min(row[j + 1], two_before[j - 1] + 1);
    }
  }
  return row.back();
}

std::vector<std::string_view> nearest_words(std::string_view word,
                                            std::span<const std::string_view> known) {
  struct Near {
    std::size_t distance, unlike;  // the index of the first different character
    std::string_view word;
  };
  std::vector<Near> near;
  for (const std::string_view other : known) {
    const auto apart = std::ranges::mismatch(word, other).in1 - word.begin();
    near.push_back({edit_distance(word.substr(0, kLongest), other),
                    kLongest - std::min(kLongest, static_cast<std::size_t>(apart)), other});
  }
  std::ranges::stable_sort(
      near, {}, [](const Near& other) { return std::pair(other.distance, other.unlike); });
  std::vector<std::string_view> words;
  words.reserve(near.size());
  for (const Near& other : near) words.push_back(other.word);
  return words;
}

std::string did_you_mean(std::string_view word, std::span<const std::string_view> known) {
  if (known.empty() || word.size() < 2 || word.size() > kLongest) return "";
  std::string_view meant = nearest_words(word, known).front();
  if (edit_distance(word, meant) > std::max<std::size_t>(1, word.size() / 3)) {
    // The word may be a part of a known one; the shortest such word adds the least.
    const auto length_of_whole = [&](std::string_view other) {
      const bool is_part = other.starts_with(word) || other.ends_with(word);
      return is_part ? other.size() : std::string_view::npos;
    };
    const auto whole = std::ranges::min_element(known, {}, length_of_whole);
    if (length_of_whole(*whole) == std::string_view::npos) return "";
    meant = *whole;
  }
  return " did you mean '" + std::string(meant) + "'?";
}

}  // namespace displayfile
