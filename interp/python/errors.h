#pragma once

#include <pybind11/pybind11.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "clip/base/error.h"
#include "clip/base/work_budget.h"

namespace displayfile::python {

/// UTF-8 text as a Python string. Other bytes, as paths may have, become lone surrogates, as in the
/// names that os.listdir returns.
pybind11::str text_of(std::string_view words);

/// An error whose place in a file is known.
struct ErrorInFile : Error {
  ErrorInFile(const Error& error, std::string of_file, int of_line, std::optional<int> of_column)
      : Error(error.what()),
        file(std::move(of_file)),
        line(of_line),
        column(of_column),
        is_limit(dynamic_cast<const LimitReached*>(&error) != nullptr) {}
  std::string file;
  int line;
  std::optional<int> column;
  bool is_limit;  ///< it is a LimitReached
};

/// The error with the place that readers of files put before their messages, "FILE:LINE:COLUMN: "
/// or "FILE:LINE: "; none if the message has no place.
std::optional<ErrorInFile> with_place(const Error& error);

/// Calls read(), which reads files, and adds to its Error the place named in the message.
template <class Read>
auto placing_errors(Read&& read) {
  try {
    return read();
  } catch (const Error& error) {
    if (const auto placed = with_place(error)) throw *placed;
    throw;
  }
}

bool says_that_it_is_another(const pybind11::error_already_set& raised);
[[noreturn]] void raise_from(pybind11::error_already_set& raised, const std::string& message);

/// Calls read(), which reads an argument's contents. If that raises a Python type or value error
/// (TypeError, ValueError and the like), throws an Error with `message`, with the Python error as
/// its cause. Other exceptions of an argument are passed on.
template <class Read>
auto reading(const std::string& message, Read&& read) {
  try {
    return read();
  } catch (pybind11::error_already_set& raised) {
    if (says_that_it_is_another(raised)) raise_from(raised, message);
    throw;
  }
}

/// Adds displayfile.Error and LimitReached to the module; C++ exceptions are translated to them
/// from then on.
void add_errors(pybind11::module_& module);

}  // namespace displayfile::python
