#include "programs/sheet/view_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>
#include <system_error>

#include "clip/base/error.h"

namespace displayfile {

namespace {

constexpr std::size_t kCutViews = 3;  // all but the isometric

std::optional<std::size_t> view_named(std::string_view name, std::size_t views) {
  const auto names = std::span(kViewNames).first(views);
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

std::optional<double> finite_number(std::string_view word) {
  double value = 0.0;
  const char* const end = word.data() + word.size();
  const auto [stop, failure] = std::from_chars(word.data(), end, value);
  if (failure != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<DetailWanted> read_detail(std::string_view word) {
  const std::size_t equals = word.find('='), at = word.find('@');
  if (equals == word.npos || at == word.npos || at < equals) return std::nullopt;
  const auto view = view_named(word.substr(0, equals), kViewNames.size());
  const auto scale = read_scale(word.substr(at + 1));
  const auto circle = words_between_commas(word.substr(equals + 1, at - equals - 1));
  if (!view || !scale || circle.size() != 3) return std::nullopt;
  const auto x = finite_number(circle[0]), y = finite_number(circle[1]),
             radius = finite_number(circle[2]);
  if (!x || !y || !radius || !(*radius > 0.0)) return std::nullopt;
  return DetailWanted{*view, {*x, *y}, *radius, *scale};
}

}  // namespace

std::vector<std::string_view> words_between_commas(std::string_view words) {
  std::vector<std::string_view> all;
  for (std::size_t begin = 0; begin <= words.size();) {
    const std::size_t end = std::min(words.find(',', begin), words.size());
    all.push_back(words.substr(begin, end - begin));
    begin = end + 1;
  }
  return all;
}

std::array<std::optional<double>, 4> sections_of(const std::vector<std::string>& words) {
  std::array<std::optional<double>, 4> positions;
  for (const std::string& word : words) {
    const auto fail = [&](std::string_view what) {
      throw Error(fmt::format("--section {}: {}", word, what));
    };
    constexpr std::string_view kExpected = "expected front=POSITION, top=POSITION or side=POSITION";
    const std::size_t equals = word.find('=');
    const auto view = view_named(std::string_view(word).substr(0, equals), kCutViews);
    if (equals == std::string::npos || !view) fail(kExpected);
    const auto value = finite_number(std::string_view(word).substr(equals + 1));
    if (!value) fail(kExpected);
    if (positions[*view]) fail("the view already has a section: expected one per view");
    positions[*view] = *value;
  }
  return positions;
}

std::array<bool, 4> hidden_lines_in_views(const std::string& words,
                                          const std::array<std::optional<double>, 4>& sections) {
  std::array<bool, 4> shown{};
  if (words.empty()) {
    for (std::size_t k = 0; k < kCutViews; ++k) shown[k] = !sections[k];
    return shown;
  }
  if (words == "none") return shown;
  if (words == "all" || words == "dashed") {
    shown.fill(true);
    return shown;
  }
  for (const std::string_view word : words_between_commas(words)) {
    const auto view = view_named(word, kViewNames.size());
    if (!view) {
      throw Error(fmt::format(
          "--hidden-lines {}: expected all or none, or some of front,top,side,isometric", words));
    }
    shown[*view] = true;
  }
  return shown;
}

std::vector<DetailWanted> details_of(const std::vector<std::string>& words) {
  std::vector<DetailWanted> details;
  for (const std::string& word : words) {
    const auto detail = read_detail(word);
    if (!detail) {
      throw Error(
          fmt::format("--detail {}: expected front=, top=, side= or isometric= with "
                      "X,Y,RADIUS@PAPER:PART",
                      word));
    }
    details.push_back(*detail);
  }
  if (details.size() > kDetailLetters.size()) {
    throw Error(fmt::format("--detail: {} details: expected at most {}", details.size(),
                            kDetailLetters.size()));
  }
  return details;
}

}  // namespace displayfile
