#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "clip/base/error.h"
#include "clip/point.h"
#include "displayfile/graphics_system.h"

namespace displayfile {

/// An Error with its position in the text.
struct ErrorAt : Error {
  ErrorAt(const char* place, const std::string& message) : Error(message), at(place) {}
  const char* at;
};

/// Returns the result of `read` for a word; its Error gets the word's position.
template <class Read>
auto understood(std::string_view word, const Read& read) {
  try {
    return read(word);
  } catch (const Error& error) {
    throw ErrorAt(word.data(), error.what());
  }
}

/// A hint for a message about a word where a number, or numbers, were expected. Empty if there is
/// none.
std::string_view hint_at(std::string_view word);

/// One line of a drawing program as words: the routine's name, then its arguments, which are read
/// in order. A quoted text is one word, including its quotation marks.
class ProgramLine {
 public:
  void split(std::string_view text);

  bool empty() const { return words_.empty(); }
  std::string_view name() const { return words_[0]; }
  std::size_t arguments() const { return words_.size() - 1; }
  std::string_view argument(std::size_t i) const { return words_[i + 1]; }
  /// Reads one argument, or as many as T has coordinates: a number, a point, or a text without its
  /// quotation marks, valid until the next read; for other T see argument_words.h. Throws ErrorAt
  /// for an invalid word; there must be enough words.
  template <class T>
  T take();
  /// Reads all remaining arguments, which must be whole points. Valid until the next line is split.
  template <class Point>
  std::span<const Point> take_points();
  std::string_view take_word() { return words_[taken_++]; }
  /// Must be called where the next argument may be a colour. If the words end here with a comment
  /// that begins with #rrggbb or #rgb and then a blank or the line's end, that colour becomes a
  /// word, as do the words behind it. Everywhere else `#` begins a comment.
  void expect_colour();

 private:
  void append_words(std::string_view text);

  std::vector<std::string_view> words_;
  std::size_t taken_ = 0;  // words
  std::string characters_;
  std::tuple<std::vector<Point2>, std::vector<Point3>> points_;
  std::string_view comment_;  // from its #
};

template <>
double ProgramLine::take<double>();
template <>
int ProgramLine::take<int>();
template <>
Point2 ProgramLine::take<Point2>();
template <>
Point3 ProgramLine::take<Point3>();
template <>
std::string_view ProgramLine::take<std::string_view>();
template <>
std::string ProgramLine::take<std::string>();
extern template std::span<const Point2> ProgramLine::take_points();
extern template std::span<const Point3> ProgramLine::take_points();

/// Calls the user routine named by the line, with its arguments. The line must not be empty. Throws
/// ErrorAt for an unknown routine or invalid arguments, and what the routine throws.
void call_routine(ProgramLine& line, GraphicsSystem& system);

/// Called after a line of a drawing program, counted from 1, with the routine that it called.
using AfterLine = std::function<void(std::size_t line, std::string_view routine)>;

/// As replay (displayfile/files.h), with a call after each line that calls a routine.
void replay_lines(std::string_view text, std::string_view file_name, GraphicsSystem& system,
                  const AfterLine& after_line);

}  // namespace displayfile
