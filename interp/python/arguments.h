#pragma once

#include <pybind11/pybind11.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "displayfile/files.h"

namespace displayfile::python {

/// NumPy's numbers as Python's; other values unchanged. `what` names the argument in messages.
pybind11::object plain(pybind11::handle value, std::string_view what);

// Arguments from Python, with an Error for wrong types. `what` names the argument in messages.

double number_in(pybind11::handle value, std::string_view what);  ///< finite
int whole_number_in(pybind11::handle value, std::string_view what);
std::uint64_t count_in(pybind11::handle value, std::string_view what);  ///< 0 or more
std::string word_in(pybind11::handle value, std::string_view what);
/// A string, bytes or an object with __fspath__, in the file system's encoding. Not "-", which is
/// standard input or output in C++.
std::string path_in(pybind11::handle value, std::string_view what);
int threads_in(pybind11::handle value);                         ///< 1 to 1024
bool switch_in(pybind11::handle value, std::string_view what);  ///< True, False, "on" or "off"

/// The same with None for a missing argument.
template <class Read>
auto if_given(pybind11::handle value, std::string_view what, const Read& read)
    -> std::optional<decltype(read(value, what))> {
  if (value.is_none()) return std::nullopt;
  return read(value, what);
}

/// The names of a routine's arguments, if each is one number or word and has a name, as Python
/// writes them; empty otherwise. Those from `optional` on may be left out.
struct ArgumentNames {
  std::vector<std::string> names;
  std::size_t optional = 0;
};
ArgumentNames names_of(const UserRoutine& routine);
/// The arguments as in a docstring: "x, y, z, radius, facets", or "/, *arguments".
std::string signature_of(const UserRoutine& routine);
/// The arguments with keyword arguments in their places. Throws Error for a name that the routine
/// does not have, one given twice, or one after a missing argument.
pybind11::args in_places(const pybind11::args& arguments, const pybind11::kwargs& by_name,
                         const UserRoutine& routine);

/// Throws Error if the routine takes any number of points, and an array or a sequence of numbers in
/// the arguments does not hold whole points.
void require_whole_points(const pybind11::args& arguments, const UserRoutine& routine);

/// The arguments of a user routine as the words of a drawing program: numbers in the shortest form
/// that reads back to the same double, True and False as on and off, sequences and arrays
/// flattened. Strings are quoted where the routine expects a quoted text.
std::string words_of(const pybind11::args& arguments, const UserRoutine& routine);

/// The same for numbers alone: adds them, or returns false for anything else.
bool add_numbers(const pybind11::args& arguments, std::vector<double>& numbers);

}  // namespace displayfile::python
