#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

#include "clip/base/budgeted_work.h"
#include "clip/base/work_budget.h"
#include "clip/point.h"
#include "displayfile/mesh/mesh_file.h"
#include "displayfile/mesh/written_digits.h"

namespace displayfile {

/// The largest coordinate of meshes, so that every mesh can be fitted into a view.
inline constexpr double kLargestCoordinate = std::numeric_limits<float>::max();

/// Reads a field of up to 15 digits with at most one point and an optional minus, the usual form in
/// meshes: the digits and the power of ten are exact doubles, and one division rounds correctly.
/// Nothing for other forms.
inline std::optional<double> short_decimal(std::string_view field) {
  constexpr std::array kPowers{1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                               1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  const bool negative = field.starts_with('-');
  if (negative) field.remove_prefix(1);
  if (field.size() > kPowers.size()) return std::nullopt;
  std::int64_t digits = 0;
  std::size_t count = 0, before_point = 0;
  bool point = false;
  for (const char c : field) {
    if (c == '.' && !point) {
      point = true;
      before_point = count;
    } else if (c >= '0' && c <= '9') {
      digits = 10 * digits + (c - '0');
      ++count;
    } else {
      return std::nullopt;
    }
  }
  if (count == 0 || count == kPowers.size()) return std::nullopt;
  const double value = static_cast<double>(digits) / kPowers[point ? count - before_point : 0];
  return negative ? -value : value;
}

/// Reads a whole field as a number, correctly rounded; nothing if it is invalid or out of range.
template <class Number>
std::optional<Number> number(std::string_view field) {
  if (field.starts_with('+')) field.remove_prefix(1);
  if constexpr (std::is_same_v<Number, double>) {
    if (const auto value = short_decimal(field)) return value;
  }
  Number value{};
  const char* const end = field.data() + field.size();
  const auto result = std::from_chars(field.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
  return value;
}

/// Line ends of a text whose first line ends in a CR without an LF: each CR, if most line ends are
/// CRs, or without examining the rest, where that is not text.
enum class LineBreaks { as_most, as_first };

/// A file's text, read field by field: fields are separated by blanks, lines end in LF, CR LF, or
/// all in CR as on the Macintosh before 2001; a byte order mark of UTF-8 at the beginning is
/// skipped.
class TextCursor {
 public:
  TextCursor(std::string_view path, std::string_view text, LineBreaks ends = LineBreaks::as_most);

  /// The next field of this line; empty at its end. A backslash before a line end joins lines.
  std::string_view field();
  /// The next field on this line or a later one, skipping comments; empty at the end of the file.
  std::string_view field_on_any_line();
  /// The remaining fields of this line, before a comment; at most as many as fit.
  std::span<const std::string_view> fields(std::span<std::string_view> room);
  /// The rest of this line, without surrounding blanks.
  std::string_view rest_of_line();

  /// The next field of this line if it is up to 9 digits and not at the end of the file: its number
  /// and position. Otherwise nothing, and the field is not consumed.
  struct Digits {
    std::int64_t value;
    std::size_t at;
  };
  std::optional<Digits> next_digits();

  /// Moves to the start of the next line; false if there is none.
  bool next_line();
  /// Moves to the start of the next line that is not blank or a comment; false if there is none.
  bool next_filled_line();
  /// Counts the filled lines after this one, moving to the end of the file.
  std::size_t count_filled_lines();

  /// The next fields of this line as a position with this many coordinates, the others 0.
  Point3 position(int dimension = 3);
  /// The position of the homogeneous coordinates x, y, z and this field.
  Point3 over_weight(const Point3& p, std::string_view w) const;
  /// The next three fields of this line as a direction, which need not be finite.
  Point3 direction();

  /// Three or four fields as red, green, blue and optional opacity. Nothing for anything else.
  std::optional<Rgba> colour(std::span<const std::string_view> fields) const;

  /// The rounding error of the decimals so far; 0 if they are meant exactly.
  double rounding_of_coordinates() const { return digits_.rounding(); }

  /// These throw Error at the field's position if it is not such a number.
  double coordinate(std::string_view f);
  double real(std::string_view f, std::string_view expected) const;
  double finite(std::string_view f, std::string_view expected) const;
  std::int64_t integer(std::string_view f, std::string_view expected) const;
  /// A count announced by the file, of elements that each take at least `least_bytes` of the rest.
  std::int64_t announced(std::string_view f, std::string_view what, std::size_t least_bytes) const;

  /// Throws Error with the position of a field of this text; an empty field stands for the current
  /// position.
  [[noreturn]] void fail(std::string_view f, const std::string& what) const {
    fail(f.empty() ? at_ : offset(f), what);
  }
  [[noreturn]] void fail(std::size_t at, const std::string& what) const;
  /// Line and column of an offset, for messages: "3:5".
  std::string place(std::size_t at) const;

  std::size_t offset(std::string_view f) const {
    return static_cast<std::size_t>(f.data() - text_.data());
  }
  std::size_t at() const { return at_; }
  std::size_t bytes_left() const { return text_.size() - at_; }
  std::string_view rest() const { return text_.substr(at_); }

  static bool is_content(std::string_view f) { return !f.empty() && f[0] != '#'; }
  static std::string quoted(std::string_view f);

 private:
  bool is_blank(char c) const;
  /// The start of the line that a backslash before a line end joins; npos if it is none.
  std::size_t after_joined_line_end(std::size_t at) const;

  std::string_view path_, text_;
  char line_end_;
  std::size_t at_ = 0;
  WorkSteps lines_;
  WrittenDigits digits_;
};

/// Removes quotation marks around a name.
constexpr std::string_view without_quotation_marks(std::string_view name) {
  const bool quoted = name.size() > 1 && name.starts_with('"') && name.ends_with('"');
  return quoted ? name.substr(1, name.size() - 2) : name;
}

/// A cursor over data that must be text: throws Error at the first zero byte.
TextCursor text_of(std::string_view path, std::string_view data);

}  // namespace displayfile
