#include "programs/surface/surface_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string_view>
#include <system_error>
#include <variant>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "clip/base/memory.h"
#include "clip/base/words.h"
#include "clip/base/work_budget.h"
#include "displayfile/mesh/text_cursor.h"
#include "displayfile/text/characters.h"
#include "interp/files/npy_file.h"
#include "programs/process/progress.h"
#include "programs/surface/expression.h"

namespace displayfile {

namespace {

bool read_height(std::string_view text, double& value) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

bool read_points(std::string_view text, int& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

double height_of(std::string_view word, const std::string& place) {
  double value = 0.0;
  if (!read_height(word, value) || std::isinf(value)) {
    throw Error(
        fmt::format("{}: {}: expected a finite number, or nan for a hole", place, quoted(word)));
  }
  return value;
}

/// Reads one row of a text; the error for anything but a number has its column. Between commas or
/// semicolons, a missing height is a hole.
std::vector<double> heights_of_row(std::string_view line, const std::string& file, int row) {
  constexpr std::string_view kBlanks = " \t\r", kEndsWord = " \t\r,;";
  constexpr double kHole = std::numeric_limits<double>::quiet_NaN();
  line = line.substr(0, line.find('#'));
  const auto place = [&](std::size_t at) { return fmt::format("{}:{}:{}", file, row, at + 1); };
  std::vector<double> numbers;
  char separator = '\0';         // of this row, if it has one
  bool separator_before = true;  // and no height since
  for (std::size_t at = line.find_first_not_of(kBlanks); at != line.npos;) {
    const char c = line[at];
    std::size_t end = at + 1;
    if (c == ',' || c == ';') {
      if (separator != '\0' && separator != c) {
        throw Error(fmt::format(
            "{}: '{}' in a row with '{}': expected one of them between heights, and a point before "
            "decimals",
            place(at), c, separator));
      }
      separator = c;
      if (separator_before) numbers.push_back(kHole);
      separator_before = true;
    } else {
      end = std::min(line.find_first_of(kEndsWord, at), line.size());
      numbers.push_back(height_of(line.substr(at, end - at), place(at)));
      separator_before = false;
    }
    at = line.find_first_not_of(kBlanks, end);
  }
  if (separator != '\0' && separator_before) numbers.push_back(kHole);
  return numbers;
}

void read_text_grid(const std::string& file, SurfaceData& surface) {
  const std::string text = read_text_file(file);
  text_of(file, text);  // throws for binary data
  std::size_t columns = 0;
  int row = 0, rows = 0;
  for (std::string_view rest = without_byte_order_mark(text); !rest.empty();) {
    const std::size_t length = std::min(rest.find('\n'), rest.size());
    const std::vector<double> numbers = heights_of_row(rest.substr(0, length), file, ++row);
    rest.remove_prefix(std::min(length + 1, rest.size()));
    if (numbers.empty()) continue;
    if (rows++ > 0 && numbers.size() != columns) {
      throw Error(fmt::format("{}:{}:1: a row of {} heights: expected {}, as in the first", file,
                              row, numbers.size(), columns));
    }
    columns = numbers.size();
    surface.heights.insert(surface.heights.end(), numbers.begin(), numbers.end());
  }
  surface.range.x_points = static_cast<int>(columns);
  surface.range.y_points = rows;
}

void read_npy_grid(const std::string& file, SurfaceData& surface) {
  const NpyArray array = read_npy(file);
  surface.range.x_points = array.width;
  surface.range.y_points = array.height;
  std::visit([&](const auto& values) { surface.heights.assign(values.begin(), values.end()); },
             array.values);
}

/// An expression may be longer than any file's name.
bool is_there(const std::string& file) {
  std::error_code failed;
  return std::filesystem::exists(file, failed);
}

/// The error for an invalid expression that names a file, which may be meant, asks for a grid's
/// extension. A valid expression takes precedence over a file of its name.
std::vector<double> heights_of_words(const std::string& words, const GridRange& range) {
  Progress progress("evaluating " + words);
  try {
    return heights_of(words, range, progress.told());
  } catch (const LimitReached&) {
    throw;
  } catch (const Error&) {
    if (is_there(words)) throw Error(words + ": expected heights in a file .npy, .txt or .csv");
    throw;
  }
}

}  // namespace

void read_range(const char* option, const std::string& text, double& low, double& high) {
  if (text.empty()) return;
  const std::size_t colon = text.find(':');
  const std::string_view words = text;
  double from = 0.0, to = 0.0;
  const bool read = colon != text.npos && read_height(words.substr(0, colon), from) &&
                    read_height(words.substr(colon + 1), to) && std::isfinite(from) &&
                    std::isfinite(to) && from < to;
  if (!read) {
    throw Error(
        fmt::format("{} {}: expected A:B, two finite numbers, the first less", option, text));
  }
  low = from;
  high = to;
}

void read_grid_size(const std::string& text, GridRange& range) {
  if (text.empty()) return;
  const std::string_view words = text;
  const std::size_t cross = words.find('x');
  int across = 0, along = 0;
  const bool read = cross != words.npos && read_points(words.substr(0, cross), across) &&
                    read_points(words.substr(cross + 1), along) && across >= 2 && along >= 2;
  if (!read) {
    throw Error(fmt::format("--grid {}: expected NXxNY points, 2 or more each way", text));
  }
  range.x_points = across;
  range.y_points = along;
}

bool is_grid_file(const std::string& expression_or_file) {
  return std::ranges::any_of(std::array{".npy", ".txt", ".csv"}, [&](const char* extension) {
    return expression_or_file.ends_with(extension);
  });
}

SurfaceData read_surface(const std::string& expression_or_file, const GridRange& range) {
  SurfaceData surface{expression_or_file, range, {}};
  if (expression_or_file.ends_with(".npy")) {
    read_npy_grid(expression_or_file, surface);
  } else if (is_grid_file(expression_or_file)) {
    read_text_grid(expression_or_file, surface);
  } else if (expression_or_file == "-") {
    throw Error("-: expected an expression in x and y, or heights in a file .npy, .txt or .csv");
  } else {
    surface.heights = with_memory(
        range.points() * sizeof(double),
        [&] { return fmt::format("a grid of {} x {} points", range.x_points, range.y_points); },
        [&] { return heights_of_words(expression_or_file, range); });
  }
  try {
    require_surface(surface.grid());
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", expression_or_file, error.what()));
  }
  if (std::ranges::all_of(surface.heights, [](double z) { return std::isnan(z); })) {
    throw Error(expression_or_file + ": there is no height at any point: expected numbers");
  }
  return surface;
}

}  // namespace displayfile
