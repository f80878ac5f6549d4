#include "displayfile/mesh/text_cursor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "clip/base/error.h"
#include "displayfile/text/characters.h"

namespace displayfile {

namespace {

/// For each character, whether it ends a field: blanks and line ends of every kind.
constexpr std::array<bool, 256> kEndsField = [] {
  std::array<bool, 256> ends{};
  for (const char c : {' ', '\t', '\r', '\n', '\f', '\v'})
    ends[static_cast<unsigned char>(c)] = true;
  return ends;
}();
bool ends_field(char c) { return kEndsField[static_cast<unsigned char>(c)]; }

char line_end_of(std::string_view text, LineBreaks ends) {
  const std::size_t cr = std::min(text.find_first_of("\r\n"), text.size());
  const std::size_t next = std::min(text.find_first_not_of('\r', cr), text.size());
  if (next == cr || (next < text.size() && text[next] == '\n')) return '\n';
  if (ends == LineBreaks::as_first) return '\r';
  return std::ranges::count(text, '\r') > 2 * std::ranges::count(text, '\n') ? '\r' : '\n';
}

}  // namespace

TextCursor::TextCursor(std::string_view path, std::string_view text, LineBreaks ends)
    : path_(path), text_(text), line_end_(line_end_of(text, ends)) {
  at_ = text_.size() - without_byte_order_mark(text_).size();
}

bool TextCursor::is_blank(char c) const { return c != line_end_ && ends_field(c); }

std::size_t TextCursor::after_joined_line_end(std::size_t at) const {
  if (text_[at] != '\\') return std::string_view::npos;
  std::size_t next = at + 1;
  while (next < text_.size() && text_[next] == '\r' && line_end_ != '\r') ++next;
  return next < text_.size() && text_[next] == line_end_ ? next + 1 : std::string_view::npos;
}

std::string_view TextCursor::field() {
  while (at_ < text_.size()) {
    const char c = text_[at_];
    if (c > ' ' && c != '\\') break;  // most are
    if (is_blank(c)) {
      ++at_;
    } else if (const std::size_t next = after_joined_line_end(at_);
               next != std::string_view::npos) {
      at_ = next;
    } else {
      break;
    }
  }
  const std::size_t start = at_;
  const auto end =
      std::find_if(text_.begin() + static_cast<std::ptrdiff_t>(start), text_.end(), ends_field);
  at_ = static_cast<std::size_t>(end - text_.begin());
  if (at_ > start && text_[at_ - 1] == '\\' &&
      after_joined_line_end(at_ - 1) != std::string_view::npos) {
    --at_;  // the line goes on, the field does not
  }
  return text_.substr(start, at_ - start);
}

std::string_view TextCursor::field_on_any_line() {
  for (;;) {
    if (const std::string_view f = field(); is_content(f)) return f;
    if (!next_line()) return {};
  }
}

std::span<const std::string_view> TextCursor::fields(std::span<std::string_view> room) {
  std::size_t n = 0;
  for (auto f = field(); is_content(f) && n < room.size(); f = field()) room[n++] = f;
  return room.first(n);
}

std::string_view TextCursor::rest_of_line() {
  const std::size_t end = std::min(text_.find(line_end_, at_), text_.size());
  std::string_view line = text_.substr(at_, end - at_);
  at_ = end;
  while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
  while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
  return line;
}

std::optional<TextCursor::Digits> TextCursor::next_digits() {
  constexpr std::size_t kMost = 9;
  std::size_t at = at_;
  while (at < text_.size() && text_[at] == ' ') ++at;
  const std::size_t start = at, most = std::min(text_.size(), start + kMost + 1);
  std::int64_t value = 0;
  for (; at < most && text_[at] >= '0' && text_[at] <= '9'; ++at) {
    value = 10 * value + (text_[at] - '0');
  }
  if (at == start || at == most || !ends_field(text_[at])) return std::nullopt;
  at_ = at;
  return Digits{value, start};
}

bool TextCursor::next_line() {
  lines_.step();
  const bool is_here = at_ < text_.size() && text_[at_] == line_end_;
  const std::size_t end = is_here ? at_ : text_.find(line_end_, at_);
  at_ = end == std::string_view::npos ? text_.size() : end + 1;
  return at_ < text_.size();
}

bool TextCursor::next_filled_line() {
  while (next_line()) {
    const std::size_t start = at_;
    const bool filled = is_content(field());
    at_ = start;
    if (filled) return true;
  }
  return false;
}

std::size_t TextCursor::count_filled_lines() {
  std::size_t lines = 0;
  while (next_filled_line()) ++lines;
  return lines;
}

Point3 TextCursor::position(int dimension) {
  Point3 p(0.0);
  for (int axis = 0; axis < dimension; ++axis) p[axis] = coordinate(field());
  return p;
}

Point3 TextCursor::over_weight(const Point3& p, std::string_view w) const {
  const Point3 divided = p / real(w, "a weight");
  for (int axis = 0; axis < 3; ++axis) {
    if (!(std::abs(divided[axis]) <= kLargestCoordinate)) {
      fail(w, fmt::format("weight {}: expected one that leaves finite coordinates", w));
    }
  }
  return divided;
}

Point3 TextCursor::direction() {
  Point3 d(0.0);
  for (int axis = 0; axis < 3; ++axis) d[axis] = real(field(), "a part of a normal");
  return d;
}

std::optional<Rgba> TextCursor::colour(std::span<const std::string_view> fields) const {
  if (fields.size() != 3 && fields.size() != 4) return std::nullopt;
  Rgba colour(kOpaque);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (!number<double>(fields[i])) return std::nullopt;
    colour[static_cast<int>(i)] = finite(fields[i], "a part of a colour");
  }
  return colour;
}

double TextCursor::coordinate(std::string_view f) {
  const double value = real(f, "a coordinate");
  if (!(std::abs(value) <= kLargestCoordinate)) {
    fail(f, fmt::format("coordinate {}: expected a finite number of magnitude at most {}", f,
                        kLargestCoordinate));
  }
  digits_.see(f);
  return value;
}

double TextCursor::real(std::string_view f, std::string_view expected) const {
  const std::optional<double> value = number<double>(f);
  if (!value) fail(f, fmt::format("{}: expected {}", quoted(f), expected));
  return *value;
}

double TextCursor::finite(std::string_view f, std::string_view expected) const {
  const double value = real(f, expected);
  if (!std::isfinite(value)) fail(f, fmt::format("{}: expected {}, finite", quoted(f), expected));
  return value;
}

std::int64_t TextCursor::integer(std::string_view f, std::string_view expected) const {
  const std::optional<std::int64_t> value = number<std::int64_t>(f);
  if (!value) fail(f, fmt::format("{}: expected {}", quoted(f), expected));
  return *value;
}

std::int64_t TextCursor::announced(std::string_view f, std::string_view what,
                                   std::size_t least_bytes) const {
  const std::int64_t count = integer(f, fmt::format("a number of {}", what));
  if (count < 0 || static_cast<std::uint64_t>(count) > (bytes_left() + 1) / least_bytes) {
    fail(f, fmt::format("{} {} announced, but only {} bytes follow", count, what, bytes_left()));
  }
  return count;
}

void TextCursor::fail(std::size_t at, const std::string& what) const {
  throw Error(fmt::format("{}:{}: {}", path_, place(at), what));
}

std::string TextCursor::place(std::size_t at) const {
  const std::string_view before = text_.substr(0, at);
  const auto line = std::count(before.begin(), before.end(), line_end_) + 1;
  const std::size_t line_start = before.rfind(line_end_) + 1;  // npos + 1 is 0
  return fmt::format("{}:{}", line, at - line_start + 1);
}

std::string TextCursor::quoted(std::string_view f) {
  if (f.empty()) return "end of line";
  std::string s = "'";
  for (const char c : f.substr(0, 20)) s += c >= ' ' && c <= '~' ? c : '?';
  return s + (f.size() > 20 ? "...'" : "'");
}

TextCursor text_of(std::string_view path, std::string_view data) {
  TextCursor text(path, data);
  if (const std::size_t zero = data.find('\0'); zero != std::string_view::npos) {
    text.fail(zero, "binary data: expected text");
  }
  return text;
}

}  // namespace displayfile
