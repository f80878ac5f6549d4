#include "interp/files/npy_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>

#include "clip/base/error.h"
#include "clip/base/words.h"
#include "displayfile/text/output.h"
#include "interp/device/picture.h"
#include "interp/files/binary_input.h"

namespace displayfile {

namespace {

constexpr std::string_view kMagic{"\x93NUMPY", 6};
constexpr std::size_t kLongestHeader = 1 << 16;

/// The bytes of a number in the file's order, little endian, whatever the machine's.
template <class T>
using Bytes = std::array<char, sizeof(T)>;

template <class T>
Bytes<T> little_endian(T value) {
  auto bytes = std::bit_cast<Bytes<T>>(value);
  if constexpr (std::endian::native == std::endian::big) std::ranges::reverse(bytes);
  return bytes;
}

template <class T>
T from_little_endian(const char* from) {
  Bytes<T> bytes;
  std::memcpy(bytes.data(), from, bytes.size());
  if constexpr (std::endian::native == std::endian::big) std::ranges::reverse(bytes);
  return std::bit_cast<T>(bytes);
}

// ---- Writing ---------------------------------------------------------------------------

std::string header(std::string_view type, int width, int height) {
  std::string dictionary = fmt::format(
      "{{'descr': '{}', 'fortran_order': False, 'shape': ({}, {}), }}", type, height, width);
  constexpr std::size_t kPreamble = 10;  // magic, version, length
  dictionary.append(63 - (kPreamble + dictionary.size()) % 64, ' ').push_back('\n');
  const auto length = little_endian(static_cast<std::uint16_t>(dictionary.size()));
  return std::string(kMagic) + std::string("\x01\x00", 2) + std::string(length.data(), 2) +
         dictionary;
}

template <class T>
constexpr std::string_view kType = "<i4";
template <>
constexpr std::string_view kType<double> = "<f8";

/// An array's file, written as its rows come.
template <class T>
class NpyWriter {
 public:
  NpyWriter(const Destination& to, int width, int height) : file_(output_to(to)) {
    require_picture_size(width, height);
    row_.resize(static_cast<std::size_t>(width) * sizeof(T));
    file_->stream() << header(kType<T>, width, height);
  }
  /// Whole rows.
  void write(std::span<const T> values) {
    const std::size_t columns = row_.size() / sizeof(T);
    for (std::size_t first = 0; first < values.size(); first += columns) {
      for (std::size_t i = 0; i < columns; ++i) {
        const Bytes<T> bytes = little_endian(values[first + i]);
        std::memcpy(&row_[i * sizeof(T)], bytes.data(), bytes.size());
      }
      file_->stream().write(row_.data(), static_cast<std::streamsize>(row_.size()));
    }
  }
  void finish() { file_->finish(); }
  void commit() { file_->commit(); }

 private:
  std::unique_ptr<Output> file_;
  std::vector<char> row_;
};

template <class T>
void write(std::span<const T> values, int width, int height, const Destination& to) {
  require_picture_size(width, height);
  if (values.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
    throw Error(
        fmt::format("{}: {} values, expected {} x {}", to.name(), values.size(), width, height));
  }
  NpyWriter<T> writer(to, width, height);
  writer.write(values);
  writer.commit();
}

/// One of a picture's arrays.
template <class T, std::vector<T> Picture::*array>
class ArrayRowFile : public RowFile {
 public:
  ArrayRowFile(const Destination& to, int width, int height) : writer_(to, width, height) {}
  void write(const Picture& rows) override { writer_.write(rows.*array); }
  void finish() override { writer_.finish(); }
  void commit() override { writer_.commit(); }

 private:
  NpyWriter<T> writer_;
};

// ---- Reading ---------------------------------------------------------------------------

/// The header's Python dictionary: strings, True and False, and tuples of numbers.
class DictionaryReader {
 public:
  explicit DictionaryReader(std::string_view text) : text_(text) {}

  bool take(char c) {
    skip_blanks();
    if (text_.empty() || text_.front() != c) return false;
    text_.remove_prefix(1);
    return true;
  }
  bool take_word(std::string_view word) {
    skip_blanks();
    if (!text_.starts_with(word)) return false;
    text_.remove_prefix(word.size());
    return true;
  }
  std::optional<std::string_view> take_string() {
    skip_blanks();
    if (text_.empty() || (text_.front() != '\'' && text_.front() != '"')) return {};
    const std::size_t end = text_.find(text_.front(), 1);
    if (end == std::string_view::npos) return {};
    const std::string_view content = text_.substr(1, end - 1);
    text_.remove_prefix(end + 1);
    return content;
  }
  std::optional<std::vector<long long>> take_tuple() {
    std::vector<long long> numbers;
    if (!take('(')) return {};
    while (!take(')')) {
      skip_blanks();
      std::size_t digits = 0;
      long long value = 0;
      for (; digits < text_.size() && text_[digits] >= '0' && text_[digits] <= '9'; ++digits) {
        if (digits == 18) return {};
        value = 10 * value + (text_[digits] - '0');
      }
      if (digits == 0) return {};
      text_.remove_prefix(digits);
      numbers.push_back(value);
      if (!take(',')) {
        if (!take(')')) return {};
        break;
      }
    }
    return numbers;
  }
  bool at_end() {
    skip_blanks();
    return text_.empty();
  }

 private:
  void skip_blanks() {
    const std::size_t first = text_.find_first_not_of(" \t\r\n");
    text_.remove_prefix(first == std::string_view::npos ? text_.size() : first);
  }
  std::string_view text_;
};

struct Header {
  std::string type;
  bool fortran_order = false;
  std::vector<long long> shape;
};

/// None if the text is not a dictionary of descr, fortran_order and shape.
std::optional<Header> parse_header(std::string_view text) {
  DictionaryReader in(text);
  Header header;
  bool type = false, order = false, shape = false;
  if (!in.take('{')) return {};
  while (!in.take('}')) {
    const auto key = in.take_string();
    if (!key || !in.take(':')) return {};
    if (*key == "descr") {
      const auto value = in.take_string();
      if (!value) return {};
      header.type = *value;
      type = true;
    } else if (*key == "fortran_order") {
      header.fortran_order = in.take_word("True");
      if (!header.fortran_order && !in.take_word("False")) return {};
      order = true;
    } else if (*key == "shape") {
      auto value = in.take_tuple();
      if (!value) return {};
      header.shape = std::move(*value);
      shape = true;
    } else {
      return {};
    }
    if (in.take(',')) continue;
    if (!in.take('}')) return {};
    break;
  }
  if (!in.at_end() || !type || !order || !shape) return {};
  return header;
}

Header read_header(BinaryInput& input) {
  std::array<char, 8> start{};
  input.stream().read(start.data(), start.size());
  if (!input.stream() || std::string_view(start.data(), kMagic.size()) != kMagic) {
    input.fail("not a .npy file");
  }
  const int version = static_cast<unsigned char>(start[6]);
  if (version < 1 || version > 3) {
    input.fail(fmt::format(".npy format version {}: expected 1 to 3", version));
  }
  std::array<char, 4> length_bytes{};
  input.read(length_bytes.data(), version == 1 ? 2 : 4);
  const auto length = from_little_endian<std::uint32_t>(length_bytes.data());
  if (length > kLongestHeader) {
    input.fail(fmt::format(".npy header of {} bytes: expected at most {}", length, kLongestHeader));
  }
  std::string text(length, ' ');
  input.read(text.data(), text.size());
  const auto header = parse_header(text);
  if (!header) input.fail(".npy header: expected a dictionary of descr, fortran_order and shape");
  return *header;
}

/// Converts column-major (Fortran) order to row-major order.
template <class Value>
std::vector<Value> row_after_row(const std::vector<Value>& columns, std::size_t width,
                                 std::size_t height) {
  std::vector<Value> rows(columns.size());
  for (std::size_t x = 0; x < width; ++x) {
    for (std::size_t y = 0; y < height; ++y) rows[y * width + x] = columns[x * height + y];
  }
  return rows;
}

/// The array's elements in stored order, read as type Stored, each passed through `convert`.
template <class Stored, class Value, class Convert>
std::vector<Value> read_values(BinaryInput& input, std::size_t width, std::size_t height,
                               Convert&& convert) {
  const std::uint64_t expected = std::uint64_t{width} * height * sizeof(Stored);
  if (const std::uint64_t left = input.bytes_left(); left != expected) {
    input.fail(fmt::format("{}: {} bytes of values, expected {}",
                           left < expected ? "truncated" : "too long", left, expected));
  }
  std::vector<Value> values;
  values.reserve(width * height);
  std::vector<char> row(width * sizeof(Stored));
  for (std::size_t y = 0; y < height; ++y) {
    input.read(row.data(), row.size());
    for (std::size_t x = 0; x < width; ++x) {
      values.push_back(convert(from_little_endian<Stored>(&row[x * sizeof(Stored)])));
    }
  }
  return values;
}

}  // namespace

void write_npy(std::span<const std::int32_t> values, int width, int height, const Destination& to) {
  write(values, width, height, to);
}

void write_npy(std::span<const double> values, int width, int height, const Destination& to) {
  write(values, width, height, to);
}

std::unique_ptr<RowFile> ids_row_file(const Destination& to, int width, int height) {
  return std::make_unique<ArrayRowFile<std::int32_t, &Picture::ids>>(to, width, height);
}

std::unique_ptr<RowFile> depth_row_file(const Destination& to, int width, int height) {
  return std::make_unique<ArrayRowFile<double, &Picture::depth>>(to, width, height);
}

NpyArray read_npy(const std::filesystem::path& path) {
  BinaryInput input(path);
  const Header header = read_header(input);
  if (header.shape.size() != 2) {
    input.fail(
        fmt::format("array of {} dimensions: expected shape (height, width)", header.shape.size()));
  }
  const long long rows = header.shape[0], columns = header.shape[1];
  if (rows < 1 || rows > kLargestSide || columns < 1 || columns > kLargestSide) {
    input.fail(fmt::format("array of shape ({}, {}): expected 1 to {} rows and columns", rows,
                           columns, kLargestSide));
  }
  NpyArray array{static_cast<int>(columns), static_cast<int>(rows), {}};
  const auto width = static_cast<std::size_t>(columns), height = static_cast<std::size_t>(rows);
  if (header.type == "<i4") {
    array.values = read_values<std::int32_t, std::int32_t>(input, width, height,
                                                           [](std::int32_t v) { return v; });
  } else if (header.type == "|u1") {
    array.values = read_values<std::uint8_t, std::int32_t>(
        input, width, height, [](std::uint8_t v) { return std::int32_t{v}; });
  } else if (header.type == "<i8") {
    array.values =
        read_values<std::int64_t, std::int32_t>(input, width, height, [&](std::int64_t v) {
          if (v < std::numeric_limits<std::int32_t>::min() ||
              v > std::numeric_limits<std::int32_t>::max()) {
            input.fail(fmt::format("value {}: expected one that fits int32", v));
          }
          return static_cast<std::int32_t>(v);
        });
  } else if (header.type == "<f4") {
    array.values = read_values<float, double>(input, width, height,
                                              [](float v) { return static_cast<double>(v); });
  } else if (header.type == "<f8") {
    array.values = read_values<double, double>(input, width, height, [](double v) { return v; });
  } else {
    input.fail(fmt::format(
        "array of type {}: expected int32, int64, uint8, float32 or float64, little endian",
        displayfile::quoted(header.type)));
  }
  if (header.fortran_order) {
    std::visit([&](auto& values) { values = row_after_row(values, width, height); }, array.values);
  }
  return array;
}

}  // namespace displayfile
