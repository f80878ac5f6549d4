#pragma once

#include <algorithm>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/text/argument_words.h"
#include "displayfile/text/program_line.h"

namespace displayfile {

/// An entry of the table of user routines (routines.cpp): its description, and its call with a
/// line's arguments, whose number is as in the entry unless it varies.
struct Routine : UserRoutine {
  void (*call)(GraphicsSystem&, ProgramLine&, const Routine&);
};

/// Throws ErrorAt: the line has another number of arguments than the routine expects.
[[noreturn]] void wrong_count(const ProgramLine& line, const Routine& routine);

// ---- Entries ------------------------------------------------------------------------------------

/// A routine of the application API, taken apart: how many words its arguments are, and the
/// call with arguments read from a line.
template <auto routine>
struct Api;
template <class... Argument, void (GraphicsSystem::*routine)(Argument...)>
struct Api<routine> {
  template <class T>
  static constexpr int kWords = std::is_same_v<T, Point3> ? 3 : 1;
  static constexpr int words = (0 + ... + kWords<std::decay_t<Argument>>);

  static void call(GraphicsSystem& system, ProgramLine& line, const Routine&) {
    const std::tuple<std::decay_t<Argument>...> arguments{line.take<std::decay_t<Argument>>()...};
    std::apply([&](const auto&... argument) { (system.*routine)(argument...); }, arguments);
  }
};

consteval int words_in(std::string_view text) {
  return text.empty() ? 0 : static_cast<int>(1 + std::ranges::count(text, ' '));
}

/// A routine of the application API.
template <auto routine>
consteval Routine fixed(std::string_view name, std::string_view expected,
                        std::string_view meaning) {
  if (words_in(expected) != Api<routine>::words) throw "the words do not match the routine";
  return {{name, expected, Api<routine>::words, meaning}, Api<routine>::call};
}

/// A routine whose call reads as many words as it expects.
template <auto call>
consteval Routine counted(std::string_view name, std::string_view expected,
                          std::string_view meaning) {
  return {{name, expected, words_in(expected), meaning}, call};
}

/// A routine whose call checks the number of words itself.
template <auto call>
consteval Routine varying(std::string_view name, std::string_view expected,
                          std::string_view meaning) {
  return {{name, expected, UserRoutine::kVaries, meaning}, call};
}

}  // namespace displayfile
