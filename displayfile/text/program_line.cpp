#include "displayfile/text/program_line.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

#include "clip/base/words.h"
#include "displayfile/looks/colour_words.h"
#include "displayfile/text/characters.h"

namespace displayfile {

namespace {

/// The characters of words: all but blanks and the start of a comment. (Other control characters
/// are refused before any line is read.) A table, as every byte of a program is examined.
constexpr auto kInWord = [] {
  std::array<bool, 256> in_word{};
  for (std::size_t c = 0; c < in_word.size(); ++c) {
    in_word[c] = c != ' ' && c != '\t' && c != '\r' && c != '#';
  }
  return in_word;
}();
bool in_word(char c) { return kInWord[static_cast<unsigned char>(c)]; }

/// The closing quotation mark of a word that begins with one: the next one without a backslash
/// before it, or the end of the line. Characters after it belong to the word up to a blank.
const char* end_of_quoted(const char* p, const char* end) {
  do ++p;
  while (p != end && *p != '"' && (*p != '\\' || ++p != end));
  return p;
}

/// As from_chars, but reads the whole word and allows a plus sign.
template <class Number>
std::errc read(std::string_view word, Number& value) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return end == word.data() + word.size() ? error : std::errc::invalid_argument;
}

double number_of_word(std::string_view word) {
  double value = 0.0;
  const std::errc error = read(word, value);
  if (error == std::errc{} && std::isfinite(value)) return value;
  if (error == std::errc::result_out_of_range) {
    throw ErrorAt(word.data(), "number " + quoted(word) + " out of range of a double");
  }
  throw ErrorAt(word.data(), error == std::errc{} ? "expected a finite number, not " + quoted(word)
                                                  : fmt::format("expected a number, not {}{}",
                                                                quoted(word), hint_at(word)));
}

}  // namespace

std::string_view hint_at(std::string_view word) {
  return word.find(',') != word.npos && word[0] != '"'
             ? ": numbers have no commas: separate them by blanks, and write decimals with a point"
             : "";
}

void ProgramLine::split(std::string_view text) {
  words_.clear();
  taken_ = 1;
  append_words(text);
}

void ProgramLine::append_words(std::string_view text) {
  const char* p = text.data();
  const char* const end = p + text.size();
  for (;;) {
    while (p != end && !in_word(*p) && *p != '#') ++p;
    if (p == end || *p == '#') {
      comment_ = {p, static_cast<std::size_t>(end - p)};
      return;
    }
    const char* const start = p;
    if (*p == '"') p = end_of_quoted(p, end);
    while (p != end && in_word(*p)) ++p;
    words_.emplace_back(start, static_cast<std::size_t>(p - start));
  }
}

void ProgramLine::expect_colour() {
  if (taken_ < words_.size()) return;
  const std::string_view comment = comment_;
  const std::string_view word = comment.substr(0, comment.find_first_of(" \t\r"));
  if (!is_hexadecimal_colour(word)) return;
  words_.push_back(word);
  append_words(comment.substr(word.size()));
}

template <>
double ProgramLine::take<double>() {
  return number_of_word(take_word());
}

template <>
Point2 ProgramLine::take<Point2>() {
  const double x = take<double>(), y = take<double>();
  return {x, y};
}

template <>
Point3 ProgramLine::take<Point3>() {
  const double x = take<double>(), y = take<double>(), z = take<double>();
  return {x, y, z};
}

template <>
int ProgramLine::take<int>() {
  const std::string_view word = take_word();
  int value = 0;
  const std::errc error = read(word, value);
  if (error == std::errc{}) return value;
  throw ErrorAt(word.data(), error == std::errc::result_out_of_range
                                 ? "whole number " + quoted(word) + " out of range"
                                 : "expected a whole number, not " + quoted(word));
}

template <>
std::string_view ProgramLine::take<std::string_view>() {
  const std::string_view word = take_word();
  if (word[0] != '"') {
    throw ErrorAt(word.data(), "expected a text in quotation marks, not " + quoted(word));
  }
  characters_.clear();
  std::size_t i = 1;
  for (; i < word.size() && word[i] != '"'; ++i) {
    if (word[i] == '\\' && ++i < word.size() && word[i] != '"' && word[i] != '\\') {
      throw ErrorAt(&word[i - 1], "expected \\\" or \\\\ after a backslash in a text");
    }
    if (i < word.size()) characters_ += word[i];
  }
  if (i >= word.size()) {
    throw ErrorAt(word.data() + word.size(), "the text does not end: expected a quotation mark");
  }
  if (i + 1 != word.size()) {
    throw ErrorAt(&word[i + 1], "expected a blank after the text's quotation mark");
  }
  const auto drawable = word.substr(0, drawable_length(word));
  if (drawable.size() < word.size()) {
    throw ErrorAt(word.data() + drawable.size(), not_drawable(word.substr(drawable.size())));
  }
  return characters_;
}

template <>
std::string ProgramLine::take<std::string>() {
  return std::string(take<std::string_view>());
}

template <class Point>
std::span<const Point> ProgramLine::take_points() {
  auto& points = std::get<std::vector<Point>>(points_);
  points.clear();
  while (taken_ < words_.size()) points.push_back(take<Point>());
  return points;
}

template std::span<const Point2> ProgramLine::take_points();
template std::span<const Point3> ProgramLine::take_points();

}  // namespace displayfile
