#include "interp/python/arguments.h"

#include <fmt/format.h>
#include <pybind11/numpy.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "clip/base/error.h"
#include "clip/base/words.h"
#include "interp/python/arrays.h"
#include "interp/python/errors.h"

namespace displayfile::python {

namespace py = pybind11;

namespace {

[[noreturn]] void refuse(py::handle value, std::string_view what, std::string_view expected) {
  throw Error(fmt::format("{}: expected {}, not {}", what, expected, type_name(value)));
}

/// True for anything that float() converts, such as Decimal and Fraction.
bool is_real(py::handle value) {
  return PyFloat_Check(value.ptr()) || PyLong_Check(value.ptr()) ||
         (py::hasattr(value, "__float__") && !py::hasattr(value, "__len__"));
}

double real(py::handle value, std::string_view what) {
  const double number = PyFloat_AsDouble(value.ptr());
  if (number != -1.0 || PyErr_Occurred() == nullptr) return number;
  if (PyErr_ExceptionMatches(PyExc_OverflowError) != 0) {
    PyErr_Clear();
    throw Error(fmt::format("{}: number out of range of a double", what));
  }
  return reading(fmt::format("{}: expected a number, not {}", what, type_name(value)),
                 []() -> double { throw py::error_already_set(); });
}

}  // namespace

py::object plain(py::handle value, std::string_view what) {
  if (PyFloat_Check(value.ptr()) || PyLong_Check(value.ptr()) || PyUnicode_Check(value.ptr()) ||
      !py::hasattr(value, "dtype") || !py::hasattr(value, "item")) {
    return py::reinterpret_borrow<py::object>(value);
  }
  return reading(fmt::format("{}: {} that cannot be read", what, type_name(value)), [&] {
    const py::object dimensions = py::getattr(value, "ndim", py::int_(0));
    if (!dimensions.equal(py::int_(0))) return py::reinterpret_borrow<py::object>(value);
    return py::object(value.attr("item")());
  });
}

double number_in(py::handle value, std::string_view what) {
  const py::object number = plain(value, what);
  if (PyBool_Check(number.ptr()) || !is_real(number)) refuse(number, what, "a number");
  const double read = real(number, what);
  if (std::isfinite(read)) return read;
  throw Error(fmt::format("{}: expected a finite number, not {}", what, read));
}

namespace {

template <class Whole>
Whole whole_in(py::handle value, std::string_view what) {
  const py::object number = plain(value, what);
  if (PyBool_Check(number.ptr()) || PyLong_Check(number.ptr()) == 0) {
    refuse(number, what, "a whole number");
  }
  int overflow = 0;
  const long long read = PyLong_AsLongLongAndOverflow(number.ptr(), &overflow);
  if (overflow != 0 || !std::in_range<Whole>(read)) {
    throw Error(fmt::format("{}: whole number out of range", what));
  }
  return static_cast<Whole>(read);
}

}  // namespace

int whole_number_in(py::handle value, std::string_view what) { return whole_in<int>(value, what); }

std::uint64_t count_in(py::handle value, std::string_view what) {
  return whole_in<std::uint64_t>(value, what);
}

std::string word_in(py::handle value, std::string_view what) {
  if (PyUnicode_Check(value.ptr()) == 0) refuse(value, what, "a string");
  Py_ssize_t length = 0;
  const char* const characters = PyUnicode_AsUTF8AndSize(value.ptr(), &length);
  if (characters == nullptr) {
    PyErr_Clear();
    throw Error(fmt::format("{}: a string that is not Unicode: it has lone surrogates", what));
  }
  return {characters, static_cast<std::size_t>(length)};
}

std::string path_in(py::handle value, std::string_view what) {
  PyObject* bytes = nullptr;
  if (PyUnicode_FSConverter(value.ptr(), &bytes) != 0) {
    std::string path = py::reinterpret_steal<py::bytes>(bytes);
    if (path != "-") return path;
    throw Error(fmt::format(
        "{}: -: expected a file's name, such as ./-; standard input and output are the command's",
        what));
  }
  const bool is_type = PyErr_ExceptionMatches(PyExc_TypeError) != 0;
  if (!is_type && PyErr_ExceptionMatches(PyExc_ValueError) == 0) throw py::error_already_set();
  PyErr_Clear();
  if (is_type) refuse(value, what, "a path");
  throw Error(
      fmt::format("{}: expected a path without null characters, in the file system's "
                  "encoding",
                  what));
}

int threads_in(py::handle value) {
  const int threads = whole_number_in(value, "threads");
  if (threads >= 1 && threads <= 1024) return threads;
  throw Error(fmt::format("threads: {}: expected 1 to 1024", threads));
}

bool switch_in(py::handle value, std::string_view what) {
  const py::object plainly = plain(value, what);
  if (PyBool_Check(plainly.ptr()) != 0) return plainly.is(py::handle(Py_True));
  if (PyUnicode_Check(plainly.ptr()) == 0) refuse(plainly, what, "True or False");
  constexpr Word<bool> kSwitches[] = {{true, "on"}, {false, "off"}};
  return value_of(kSwitches, word_in(plainly, what), std::string(what) + ": expected");
}

// ---- Words -------------------------------------------------------------------------------

namespace {

class Words {
 public:
  explicit Words(const UserRoutine& routine)
      : routine_(routine), quotes_(routine.expected.find('"') != std::string_view::npos) {}

  void add(py::handle value, int depth = 0) {
    const py::object plainly = plain(value, routine_.name);
    PyObject* const object = plainly.ptr();
    if (PyFloat_Check(object) != 0) return add_number(PyFloat_AS_DOUBLE(object));
    if (PyBool_Check(object) != 0) return add_word(object == Py_True ? "on" : "off");
    if (PyLong_Check(object) != 0) return add_whole_number(plainly);
    if (PyUnicode_Check(object) != 0) return add_text(word_in(plainly, name()));
    if (PyList_Check(object) != 0 || PyTuple_Check(object) != 0) {
      if (depth == kDeepest) throw Error(name() + ": sequences are nested too deep");
      // It may change while its parts are read.
      for (Py_ssize_t i = 0; i < PySequence_Fast_GET_SIZE(object); ++i) {
        const auto part = py::reinterpret_borrow<py::object>(PySequence_Fast_GET_ITEM(object, i));
        add(part, depth + 1);
      }
      return;
    }
    if (is_real(plainly)) return add_number(real(plainly, name()));
    for (const double number : numbers_in(plainly, name())) add_number(number);
  }
  std::string take() { return std::move(text_); }

 private:
  static constexpr int kDeepest = 16;

  std::string name() const { return std::string(routine_.name); }
  void add_word(std::string_view word) {
    if (!text_.empty()) text_ += ' ';
    text_ += word;
  }
  template <class Number>
  void add_characters(Number number) {
    std::array<char, 32> characters;
    const auto written =
        std::to_chars(characters.data(), characters.data() + characters.size(), number);
    add_word({characters.data(), static_cast<std::size_t>(written.ptr - characters.data())});
  }
  void add_number(double number) { add_characters(number); }
  void add_whole_number(const py::object& value) {
    int overflow = 0;
    const long long number = PyLong_AsLongLongAndOverflow(value.ptr(), &overflow);
    if (overflow != 0) return add_number(real(value, name()));
    add_characters(number);
  }
  void add_text(const std::string& text) {
    if (!quotes_) return add_word(text);
    std::string quoted = "\"";
    for (const char c : text) {
      if (c == '"' || c == '\\') quoted += '\\';
      quoted += c;
    }
    add_word(quoted + '"');
  }

  const UserRoutine& routine_;
  bool quotes_;
  std::string text_;
};

}  // namespace

namespace {

/// The number of coordinates of each point that the routine takes; 1 if it takes no points.
std::size_t numbers_of_point(const UserRoutine& routine) {
  constexpr std::string_view kPoints = "a multiple of ";
  if (!routine.expected.starts_with(kPoints)) return 1;
  return static_cast<std::size_t>(routine.expected[kPoints.size()] - '0');
}

/// The number of elements of a list or a tuple of numbers alone, or of an array's last dimension;
/// none for anything else. Calls no Python code of the objects, which could change others.
std::optional<py::ssize_t> numbers_held(py::handle value) {
  PyObject* const object = value.ptr();
  if (py::isinstance<py::array>(value)) {
    const auto array = py::reinterpret_borrow<py::array>(value);
    if (array.ndim() > 0) return array.shape(array.ndim() - 1);
  }
  if (PyList_CheckExact(object) == 0 && PyTuple_CheckExact(object) == 0) return std::nullopt;
  const Py_ssize_t held = PySequence_Fast_GET_SIZE(object);
  for (Py_ssize_t i = 0; i < held; ++i) {
    PyObject* const part = PySequence_Fast_GET_ITEM(object, i);
    if (PyFloat_Check(part) == 0 && PyLong_Check(part) == 0) return std::nullopt;
  }
  return held;
}

void require_points_of(std::size_t numbers, py::handle value, const UserRoutine& routine) {
  const auto held = numbers_held(value);
  if (!held || static_cast<std::size_t>(*held) % numbers == 0) return;
  throw Error(fmt::format("{}: expected points of {} numbers, or an array of shape (N, {}), not {}",
                          routine.name, numbers, numbers, *held));
}

}  // namespace

void require_whole_points(const py::args& arguments, const UserRoutine& routine) {
  const std::size_t numbers = numbers_of_point(routine);
  if (numbers == 1) return;
  for (const py::handle argument : arguments) {
    require_points_of(numbers, argument, routine);
    PyObject* const object = argument.ptr();
    if (PyList_CheckExact(object) == 0 && PyTuple_CheckExact(object) == 0) continue;
    for (Py_ssize_t i = 0; i < PySequence_Fast_GET_SIZE(object); ++i) {
      require_points_of(numbers, PySequence_Fast_GET_ITEM(object, i), routine);
    }
  }
}

namespace {

/// The name of an argument, taken from a word of the routine's expectation; empty if that has none.
std::string argument_name(std::string_view word) {
  if (word == "on|off") return "on";
  if (word == "\"characters\"") return "characters";
  const auto is_of_name = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); };
  std::string name;
  for (const char c : word) {
    if (!is_of_name(c) && c != '-') return {};
    name += c == '-' ? '_' : c;
  }
  return name;
}

}  // namespace

ArgumentNames names_of(const UserRoutine& routine) {
  std::string_view expected = routine.expected;
  if (const auto colon = expected.find(": "); colon != expected.npos) {
    expected.remove_prefix(colon + 2);
  }
  ArgumentNames result;
  bool is_optional = false;
  while (!expected.empty()) {
    const std::size_t end = std::min(expected.find(' '), expected.size());
    std::string_view word = expected.substr(0, end);
    expected.remove_prefix(std::min(end + 1, expected.size()));
    if (word.empty()) continue;
    if (word.front() == '[' && word.back() == ']' && expected.empty()) {
      is_optional = true;
      result.optional = result.names.size();
      word = word.substr(1, word.size() - 2);
    }
    std::string name = argument_name(word);
    if (name.empty() || std::ranges::find(result.names, name) != result.names.end()) return {};
    result.names.push_back(std::move(name));
  }
  if (!is_optional) result.optional = result.names.size();
  return result;
}

std::string signature_of(const UserRoutine& routine) {
  const ArgumentNames all = names_of(routine);
  if (all.names.empty()) return routine.expected.empty() ? "/" : "/, *arguments";
  std::string signature;
  for (std::size_t k = 0; k < all.names.size(); ++k) {
    signature +=
        fmt::format("{}{}{}", k == 0 ? "" : ", ", all.names[k], k < all.optional ? "" : "=None");
  }
  return signature;
}

namespace {

/// Throws Error unless the value is one number, word or text.
void require_one(py::handle value, std::string_view what) {
  PyObject* const object = value.ptr();
  if (PyUnicode_Check(object) != 0 || PyBool_Check(object) != 0) return;
  const py::object plainly = plain(value, what);
  if (!is_real(plainly)) refuse(value, what, "one number or word");
}

std::size_t words_held(py::handle value, int depth = 0) {
  PyObject* const object = value.ptr();
  if (py::isinstance<py::array>(value)) {
    return static_cast<std::size_t>(py::reinterpret_borrow<py::array>(value).size());
  }
  if (depth > 8 || (PyList_Check(object) == 0 && PyTuple_Check(object) == 0)) return 1;
  std::size_t count = 0;
  for (Py_ssize_t i = 0; i < PySequence_Fast_GET_SIZE(object); ++i) {
    count += words_held(PySequence_Fast_GET_ITEM(object, i), depth + 1);
  }
  return count;
}

}  // namespace

py::args in_places(const py::args& arguments, const py::kwargs& by_name,
                   const UserRoutine& routine) {
  const std::vector<std::string> names = names_of(routine).names;
  std::size_t place = 0;
  for (const py::handle argument : arguments) place += words_held(argument);
  const auto is_name = [&](const auto& item) {
    return std::ranges::find(names, py::cast<std::string>(item.first)) != names.end();
  };
  for (const auto& item : by_name) {
    if (is_name(item)) continue;
    throw Error(fmt::format("{}: unknown argument {}: expected {}", routine.name,
                            py::cast<std::string>(item.first),
                            names.empty() ? "none by name" : signature_of(routine)));
  }
  py::list all(arguments);
  std::size_t left = by_name.size();
  for (std::size_t k = 0; k < names.size(); ++k) {
    const py::str name(names[k]);
    if (!by_name.contains(name)) {
      if (k >= place && left > 0) {
        throw Error(fmt::format("{}: {} is missing: expected {}", routine.name, names[k],
                                signature_of(routine)));
      }
      continue;
    }
    if (k < place) throw Error(fmt::format("{}: {} is set twice", routine.name, names[k]));
    const py::object value = by_name[name];
    require_one(value, names[k]);
    all.append(value);
    --left;
  }
  return py::args(py::tuple(all));
}

std::string words_of(const py::args& arguments, const UserRoutine& routine) {
  Words words(routine);
  for (const py::handle argument : arguments) words.add(argument);
  return words.take();
}

namespace {

bool add_numbers_of(py::handle value, std::vector<double>& numbers, int depth) {
  PyObject* const object = value.ptr();
  if (PyFloat_Check(object) != 0) {
    numbers.push_back(PyFloat_AS_DOUBLE(object));
    return true;
  }
  if (PyLong_CheckExact(object) != 0) {
    numbers.push_back(PyLong_AsDouble(object));
    if (numbers.back() != -1.0 || PyErr_Occurred() == nullptr) return true;
    PyErr_Clear();
    return false;
  }
  if (PyList_CheckExact(object) != 0 || PyTuple_CheckExact(object) != 0) {
    if (depth == 2) return false;
    for (Py_ssize_t i = 0; i < PySequence_Fast_GET_SIZE(object); ++i) {
      if (!add_numbers_of(PySequence_Fast_GET_ITEM(object, i), numbers, depth + 1)) return false;
    }
    return true;
  }
  return add_array(value, numbers);
}

}  // namespace

bool add_numbers(const py::args& arguments, std::vector<double>& numbers) {
  for (const py::handle argument : arguments) {
    if (!add_numbers_of(argument, numbers, 0)) return false;
  }
  return true;
}

}  // namespace displayfile::python
