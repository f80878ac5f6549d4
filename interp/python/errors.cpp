#include "interp/python/errors.h"

#include <algorithm>
#include <charconv>
#include <exception>
#include <string_view>
#include <system_error>

#include "clip/base/work_budget.h"

namespace displayfile::python {

namespace py = pybind11;

namespace {

/// The number between two colons, the first of which is at `colon`.
std::optional<int> number_after(std::string_view message, std::size_t colon) {
  const std::size_t end = message.find(':', colon + 1);
  if (end == message.npos) return std::nullopt;
  int value = 0;
  const char* const last = message.data() + end;
  const auto [read, error] = std::from_chars(message.data() + colon + 1, last, value);
  if (error != std::errc{} || read != last) return std::nullopt;
  return value;
}

}  // namespace

py::str text_of(std::string_view words) {
  PyObject* const text =
      PyUnicode_DecodeUTF8(words.data(), static_cast<Py_ssize_t>(words.size()), "surrogateescape");
  if (text == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::str>(text);
}

std::optional<ErrorInFile> with_place(const Error& error) {
  const std::string_view message = error.what();
  for (std::size_t colon = message.find(':'); colon != message.npos;
       colon = message.find(':', colon + 1)) {
    const auto line = number_after(message, colon);
    if (!line) continue;
    const auto column = number_after(message, message.find(':', colon + 1));
    return ErrorInFile(error, std::string(message.substr(0, colon)), *line, column);
  }
  return std::nullopt;
}

namespace {

PyObject* error_type = nullptr;  // they live as long as the process
PyObject* limit_type = nullptr;

void raise(const Error& error) {
  const auto* const placed = dynamic_cast<const ErrorInFile*>(&error);
  const bool is_limit =
      placed != nullptr ? placed->is_limit : dynamic_cast<const LimitReached*>(&error) != nullptr;
  PyObject* const type = is_limit ? limit_type : error_type;
  const py::object raised = py::reinterpret_steal<py::object>(
      PyObject_CallFunctionObjArgs(type, text_of(error.what()).ptr(), nullptr));
  if (!raised) return;  // what Python raised in its place
  if (placed != nullptr) {
    raised.attr("file") = text_of(placed->file);
    raised.attr("line") = placed->line;
    raised.attr("column") = placed->column ? py::object(py::int_(*placed->column)) : py::none();
  }
  PyErr_SetObject(type, raised.ptr());
}

}  // namespace

bool says_that_it_is_another(const py::error_already_set& raised) {
  PyObject* const kinds[] = {PyExc_TypeError,   PyExc_ValueError,         PyExc_OverflowError,
                             PyExc_IndexError,  PyExc_BufferError,        PyExc_ReferenceError,
                             PyExc_MemoryError, PyExc_NotImplementedError};
  return std::ranges::any_of(kinds, [&](PyObject* kind) { return raised.matches(kind); });
}

void raise_from(py::error_already_set& raised, const std::string& message) {
  py::raise_from(raised, error_type, message.c_str());
  throw py::error_already_set();
}

void add_errors(py::module_& module) {
  py::dict members;
  for (const char* name : {"file", "line", "column"}) members[name] = py::none();
  error_type = PyErr_NewExceptionWithDoc(
      "displayfile.Error",
      "Raised for an invalid call, which leaves the state unchanged. file, line and column give "
      "the position in the input, or are None.",
      PyExc_Exception, members.ptr());
  if (error_type == nullptr) throw py::error_already_set();
  module.attr("Error") = py::handle(error_type);
  limit_type = PyErr_NewExceptionWithDoc(
      "displayfile.LimitReached",
      "An Error: a limit was reached. The message names the limit and an alternative method.",
      error_type, nullptr);
  if (limit_type == nullptr) throw py::error_already_set();
  module.attr("LimitReached") = py::handle(limit_type);
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Error& error) {
      raise(error);
    }
  });
}

}  // namespace displayfile::python
