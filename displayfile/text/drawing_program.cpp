#include "displayfile/text/drawing_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "clip/error.h"
#include "clip/nearest_word.h"
#include "clip/words.h"
#include "displayfile/axes.h"
#include "displayfile/characters.h"
#include "displayfile/input_file.h"

namespace displayfile {

namespace {

/// An error whose place in the text is known.
struct ErrorAt : Error {
  ErrorAt(const char* place, const std::string& message) : Error(message), at(place) {}
  const char* at;
};

// ---- The words of a line -----------------------------------------------------------------

struct Routine;

/// One line of a drawing program as words: the routine's name, then its arguments, which are
/// taken in order. What stands in quotation marks is one word, with them.
class Line {
 public:
  void split(std::string_view text);

  bool empty() const { return words_.empty(); }
  std::string_view name() const { return words_[0]; }
  std::size_t arguments() const { return words_.size() - 1; }
  std::string_view argument(std::size_t i) const { return words_[i + 1]; }
  /// Takes one argument, or as many as T has coordinates. Throws ErrorAt for a word that is
  /// not one; there must be enough words.
  template <class T>
  T take();
  /// Takes all that are left. Throws ErrorAt if they do not make whole points.
  template <class Point>
  std::span<const Point> take_points(const Routine& routine);

 private:
  std::vector<std::string_view> words_;
  std::size_t taken_ = 0;  // words
  std::string characters_;
  std::tuple<std::vector<Point2>, std::vector<Point3>> points_;
};

/// What words are made of: all but blanks and the start of a comment. (Other control characters
/// are refused before any line is read.) A table, as every byte of a program is looked at.
constexpr auto kInWord = [] {
  std::array<bool, 256> in_word{};
  for (std::size_t c = 0; c < in_word.size(); ++c) {
    in_word[c] = c != ' ' && c != '\t' && c != '\r' && c != '#';
  }
  return in_word;
}();
bool in_word(char c) { return kInWord[static_cast<unsigned char>(c)]; }

/// Where a word that begins with a quotation mark ends: with the next one that no backslash stands
/// before, and what follows it up to a blank; or else with the line.
const char* end_of_quoted(const char* p, const char* end) {
  do ++p;
  while (p != end && *p != '"' && (*p != '\\' || ++p != end));
  return p;
}

void Line::split(std::string_view text) {
  words_.clear();
  taken_ = 1;
  const char* p = text.data();
  const char* const end = p + text.size();
  for (;;) {
    while (p != end && !in_word(*p) && *p != '#') ++p;
    if (p == end || *p == '#') return;
    const char* const start = p;
    if (*p == '"') p = end_of_quoted(p, end);
    while (p != end && in_word(*p)) ++p;
    words_.emplace_back(start, static_cast<std::size_t>(p - start));
  }
}

/// from_chars, but the whole word and with an optional plus sign.
template <class Number>
std::errc read(std::string_view word, Number& value) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return end == word.data() + word.size() ? error : std::errc::invalid_argument;
}

/// What may be wrong with a word in which a number was expected, or numbers.
std::string_view hint_at(std::string_view word) {
  return word.find(',') != word.npos && word[0] != '"'
             ? ": numbers have no commas: blanks part them, a point their decimals"
             : "";
}

double number(std::string_view word) {
  double value = 0.0;
  const std::errc error = read(word, value);
  if (error == std::errc{} && std::isfinite(value)) return value;
  if (error == std::errc::result_out_of_range) {
    throw ErrorAt(word.data(), "number " + quoted(word) + " out of range of a double");
  }
  throw ErrorAt(word.data(), error == std::errc{} ? "expected a finite number, not " + quoted(word)
                                                  : fmt::format("expected a number, not {}{}",
                                                                quoted(word), hint_at(word)));
}

template <>
double Line::take<double>() {
  return number(words_[taken_++]);
}

template <>
Point2 Line::take<Point2>() {
  const double x = take<double>(), y = take<double>();
  return {x, y};
}

template <>
Point3 Line::take<Point3>() {
  const double x = take<double>(), y = take<double>(), z = take<double>();
  return {x, y, z};
}

template <>
int Line::take<int>() {
  const std::string_view word = words_[taken_++];
  int value = 0;
  const std::errc error = read(word, value);
  if (error == std::errc{}) return value;
  throw ErrorAt(word.data(), error == std::errc::result_out_of_range
                                 ? "whole number " + quoted(word) + " out of range"
                                 : "expected a whole number, not " + quoted(word));
}

/// What `read` makes of a word; its Error, at the word.
template <class Read>
auto understood(std::string_view word, const Read& read) {
  try {
    return read(word);
  } catch (const Error& error) {
    throw ErrorAt(word.data(), error.what());
  }
}

constexpr Word<bool> kSwitches[] = {{true, "on"}, {false, "off"}};
constexpr Word<FillStyle::Kind> kFillKinds[] = {{FillStyle::Kind::solid, "solid"},
                                                {FillStyle::Kind::hollow, "hollow"}};
constexpr Word<LineStyle::Kind> kLineKinds[] = {{LineStyle::Kind::solid, "solid"},
                                                {LineStyle::Kind::dashed, "dashed"},
                                                {LineStyle::Kind::none, "none"}};

template <class Value, std::size_t N>
Value one_of(const Word<Value> (&known)[N], std::string_view word) {
  return understood(word, [&](std::string_view w) { return value_of(known, w, "expected"); });
}

template <>
bool Line::take<bool>() {
  return one_of(kSwitches, words_[taken_++]);
}

template <>
FillStyle::Kind Line::take<FillStyle::Kind>() {
  return one_of(kFillKinds, words_[taken_++]);
}

template <>
LineStyle::Kind Line::take<LineStyle::Kind>() {
  return one_of(kLineKinds, words_[taken_++]);
}

template <>
HiddenMethod Line::take<HiddenMethod>() {
  return understood(words_[taken_++], hidden_method);
}

template <>
HiddenScope Line::take<HiddenScope>() {
  return understood(words_[taken_++], hidden_scope);
}

template <>
HiddenLines Line::take<HiddenLines>() {
  return understood(words_[taken_++], hidden_lines);
}

template <>
Shading Line::take<Shading>() {
  return understood(words_[taken_++], shading);
}

template <>
WindowFit Line::take<WindowFit>() {
  return understood(words_[taken_++], window_fit);
}

template <>
Precision Line::take<Precision>() {
  return understood(words_[taken_++], precision);
}

/// A text in quotation marks, without them. Valid until the next line is split.
template <>
std::string_view Line::take<std::string_view>() {
  const std::string_view word = words_[taken_++];
  if (word[0] != '"') {
    throw ErrorAt(word.data(), "expected a text in quotation marks, not " + quoted(word));
  }
  characters_.clear();
  std::size_t i = 1;
  for (; i < word.size() && word[i] != '"'; ++i) {
    if (word[i] == '\\' && ++i < word.size() && word[i] != '"' && word[i] != '\\') {
      throw ErrorAt(&word[i - 1], "expected \\\" or \\\\ after a backslash in a text");
    }
    if (i < word.size()) characters_ += word[i];
  }
  if (i >= word.size()) {
    throw ErrorAt(word.data() + word.size(), "the text does not end: expected a quotation mark");
  }
  if (i + 1 != word.size()) {
    throw ErrorAt(&word[i + 1], "expected a blank after the text's quotation mark");
  }
  const auto drawable = word.substr(0, drawable_length(word));
  if (drawable.size() < word.size()) {
    throw ErrorAt(word.data() + drawable.size(), not_drawable(word.substr(drawable.size())));
  }
  return characters_;
}

template <>
TextStyle::Alignment Line::take<TextStyle::Alignment>() {
  return understood(words_[taken_++], alignment);
}

// ---- The routines ------------------------------------------------------------------------

constexpr int kVaries = -1;

struct Routine {
  std::string_view name;
  std::string_view expected;  ///< the arguments, in words
  int arguments;              ///< how many; kVaries if `call` looks to it
  void (*call)(GraphicsSystem&, Line&, const Routine&);
};

[[noreturn]] void wrong_count(const Line& line, const Routine& routine) {
  const std::size_t count = line.arguments();
  std::string message =
      fmt::format("{}: {} argument{}, expected ", routine.name, count, count == 1 ? "" : "s");
  if (routine.arguments == 0) {
    message += "none";
  } else if (routine.arguments == kVaries) {
    message += routine.expected;
  } else {
    message += fmt::format("{}: {}", routine.arguments, routine.expected);
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (const std::string_view hint = hint_at(line.argument(i)); !hint.empty()) {
      message += hint;
      break;
    }
  }
  const bool too_many = routine.arguments != kVaries && std::cmp_greater(count, routine.arguments);
  if (too_many) {
    throw ErrorAt(line.argument(static_cast<std::size_t>(routine.arguments)).data(), message);
  }
  const std::string_view last = count == 0 ? line.name() : line.argument(count - 1);
  throw ErrorAt(last.data() + last.size(), message);
}

template <class Point>
std::span<const Point> Line::take_points(const Routine& routine) {
  if (arguments() % static_cast<std::size_t>(Point::length()) != 0) wrong_count(*this, routine);
  auto& points = std::get<std::vector<Point>>(points_);
  points.clear();
  while (taken_ < words_.size()) points.push_back(take<Point>());
  return points;
}

/// A routine of the application API, taken apart: how many words its arguments are, and the
/// call with arguments read from a line.
template <auto routine>
struct Api;
template <class... Argument, void (GraphicsSystem::*routine)(Argument...)>
struct Api<routine> {
  template <class T>
  static constexpr int kWords = std::is_same_v<T, Point3> ? 3 : 1;
  static constexpr int words = (0 + ... + kWords<std::decay_t<Argument>>);

  static void call(GraphicsSystem& system, Line& line, const Routine&) {
    const std::tuple<std::decay_t<Argument>...> arguments{line.take<std::decay_t<Argument>>()...};
    std::apply([&](const auto&... argument) { (system.*routine)(argument...); }, arguments);
  }
};

consteval int words_in(std::string_view text) {
  return text.empty() ? 0 : static_cast<int>(1 + std::ranges::count(text, ' '));
}

template <auto routine>
consteval Routine fixed(std::string_view name, std::string_view expected) {
  if (words_in(expected) != Api<routine>::words) throw "the words do not match the routine";
  return {name, expected, Api<routine>::words, Api<routine>::call};
}

template <class Point, void (GraphicsSystem::*routine)(std::span<const Point>)>
void points(GraphicsSystem& system, Line& line, const Routine& entry) {
  (system.*routine)(line.take_points<Point>(entry));
}

void fill_style(GraphicsSystem& system, Line& line, const Routine& routine) {
  if (line.arguments() == 0) wrong_count(line, routine);
  const auto kind = line.take<FillStyle::Kind>();
  const bool solid = kind == FillStyle::Kind::solid;
  if (line.arguments() != (solid ? 4 : 1)) wrong_count(line, routine);
  system.set_fill_style(solid ? FillStyle{kind, line.take<Point3>()} : FillStyle{kind});
}

void line_style(GraphicsSystem& system, Line& line, const Routine& routine) {
  if (line.arguments() == 0) wrong_count(line, routine);
  const std::size_t count = line.arguments();
  const auto kind = line.take<LineStyle::Kind>();
  if (kind == LineStyle::Kind::none) {
    if (count != 1) wrong_count(line, routine);
    return system.set_line_style({kind});
  }
  const bool dashed = kind == LineStyle::Kind::dashed;
  if (count != 4 && count != 5 && !(dashed && count == 7)) wrong_count(line, routine);
  LineStyle style{kind, line.take<Point3>()};
  if (count >= 5) style.width = line.take<double>();
  if (count == 7) {
    style.dash = line.take<double>();
    style.gap = line.take<double>();
  }
  system.set_line_style(style);
}

void background(GraphicsSystem& system, Line& line, const Routine& routine) {
  if (line.arguments() != 1 && line.arguments() != 3) wrong_count(line, routine);
  if (line.arguments() == 3) {
    return system.set_background({Background::Kind::solid, line.take<Point3>()});
  }
  if (line.argument(0) != "none") {
    throw ErrorAt(line.argument(0).data(),
                  "expected none, or three numbers: r g b, not " + quoted(line.argument(0)));
  }
  system.set_background({Background::Kind::none});
}

void light(GraphicsSystem& system, Line& line, const Routine& routine) {
  if (line.arguments() != 3 && line.arguments() != 4) wrong_count(line, routine);
  const auto toward = line.take<Point3>();
  if (line.arguments() == 3) return system.set_light(toward);
  system.set_light(toward, line.take<double>());
}

void text_style(GraphicsSystem& system, Line& line, const Routine& routine) {
  const std::size_t count = line.arguments();
  if (count < 1 || count > 3) wrong_count(line, routine);
  TextStyle style;
  style.size = line.take<double>();
  style.always = count > 1 && line.argument(count - 1) == "always";
  const std::size_t others = count - (style.always ? 2 : 1);
  if (others > 0) style.alignment = line.take<TextStyle::Alignment>();
  if (others > 1) {
    const std::string_view word = line.argument(2);
    throw ErrorAt(word.data(), "expected always, or nothing, not " + quoted(word));
  }
  system.set_text_style(style);
}

void lines(GraphicsSystem& system, Line& line, const Routine& routine) {
  if (line.arguments() == 0) wrong_count(line, routine);
  LineSelection selection{.kinds = 0};
  for (std::size_t i = 0; i < line.arguments(); ++i) {
    understood(line.argument(i), [&](std::string_view word) { add_line_kind(word, selection); });
  }
  system.set_lines(selection);
}

void axes(GraphicsSystem& system, Line& line, const Routine& routine) {
  const std::size_t count = line.arguments();
  if (count != 6 && count != 9) wrong_count(line, routine);
  Point3 low, high;
  for (int a = 0; a < 3; ++a) {
    low[a] = line.take<double>();
    high[a] = line.take<double>();
  }
  std::array<std::string, 3> names{"x", "y", "z"};
  if (count == 9) {
    for (std::string& name : names) name = line.take<std::string_view>();
  }
  axes_3(system, low, high, {names[0], names[1], names[2]});
}

using G = GraphicsSystem;

/// Every user routine. They are looked up in this order: those that fill programs come first.
constexpr auto kRoutines = std::to_array<Routine>({
    {"polygon-abs-3", "a multiple of 3: x y z ...", kVaries, points<Point3, &G::polygon_abs_3>},
    fixed<&G::line_abs_3>("line-abs-3", "x y z"),
    fixed<&G::move_abs_3>("move-abs-3", "x y z"),
    {"polygon-abs-2", "a multiple of 2: x y ...", kVaries, points<Point2, &G::polygon_abs_2>},
    fixed<&G::line_abs_2>("line-abs-2", "x y"),
    fixed<&G::move_abs_2>("move-abs-2", "x y"),
    {"polygon-rel-3", "a multiple of 3: dx dy dz ...", kVaries, points<Point3, &G::polygon_rel_3>},
    fixed<&G::line_rel_3>("line-rel-3", "dx dy dz"),
    fixed<&G::move_rel_3>("move-rel-3", "dx dy dz"),
    {"polygon-rel-2", "a multiple of 2: dx dy ...", kVaries, points<Point2, &G::polygon_rel_2>},
    fixed<&G::line_rel_2>("line-rel-2", "dx dy"),
    fixed<&G::move_rel_2>("move-rel-2", "dx dy"),
    fixed<&G::set_pick_id>("set-pick-id", "n"),
    fixed<&G::text>("text", "\"characters\""),
    {"axes-3", "6 or 9: x-min x-max y-min y-max z-min z-max [\"x\" \"y\" \"z\"]", kVaries, axes},
    {"set-fill-style", "solid r g b | hollow", kVaries, fill_style},
    {"set-line-style", "solid r g b [width] | dashed r g b [width [dash gap]] | none", kVaries,
     line_style},
    {"set-text-style", "size [left|centre|right] [always]", kVaries, text_style},
    {"set-light", "3 or 4: x y z [ambient]", kVaries, light},
    {"set-vertex-normals", "a multiple of 3: x y z ...", kVaries,
     points<Point3, &G::set_vertex_normals>},
    fixed<&G::set_shading>("set-shading", "flat|gouraud"),
    fixed<&G::set_shadows>("set-shadows", "on|off"),

    fixed<&G::open_segment>("open-segment", "name"),
    fixed<&G::close_segment>("close-segment", ""),
    fixed<&G::delete_segment>("delete-segment", "name"),
    fixed<&G::delete_all_segments>("delete-all-segments", ""),
    fixed<&G::rename_segment>("rename-segment", "name new-name"),
    fixed<&G::set_visibility>("set-visibility", "name on|off"),
    fixed<&G::set_image_translation>("set-image-translation", "name tx ty"),
    fixed<&G::set_image_scale>("set-image-scale", "name sx sy"),
    fixed<&G::set_image_rotation>("set-image-rotation", "name angle"),
    fixed<&G::set_image_centre>("set-image-centre", "name x y"),

    fixed<&G::create_transformation_3>("create-transformation-3", ""),
    fixed<&G::translate_3>("translate-3", "tx ty tz"),
    fixed<&G::scale_3>("scale-3", "sx sy sz"),
    fixed<&G::rotate_x_3>("rotate-x-3", "angle"),
    fixed<&G::rotate_y_3>("rotate-y-3", "angle"),
    fixed<&G::rotate_z_3>("rotate-z-3", "angle"),
    fixed<&G::save_transformation_3>("save-transformation-3", ""),
    fixed<&G::restore_transformation_3>("restore-transformation-3", ""),

    fixed<&G::set_view_reference_point>("set-view-reference-point", "x y z"),
    fixed<&G::set_view_plane_normal>("set-view-plane-normal", "dx dy dz"),
    fixed<&G::set_view_distance>("set-view-distance", "distance"),
    fixed<&G::set_view_up>("set-view-up", "dx dy dz"),
    fixed<&G::set_parallel>("set-parallel", "dx dy dz"),
    fixed<&G::set_perspective>("set-perspective", "x y z"),
    fixed<&G::set_view_depth>("set-view-depth", "front back"),
    fixed<&G::set_front_plane_clipping>("set-front-plane-clipping", "on|off"),
    fixed<&G::set_back_plane_clipping>("set-back-plane-clipping", "on|off"),
    fixed<&G::set_window>("set-window", "x-min x-max y-min y-max"),
    fixed<&G::set_viewport>("set-viewport", "x-min x-max y-min y-max"),
    fixed<&G::set_window_fit>("set-window-fit", "widen|stretch"),
    {"set-background", "r g b | none", kVaries, background},

    fixed<&G::set_hidden_line_removal>("set-hidden-line-removal", "on|off"),
    fixed<&G::set_back_face_removal>("set-back-face-removal", "on|off"),
    fixed<&G::set_hidden_method>("set-hidden-method", "method"),
    fixed<&G::set_hidden_scope>("set-hidden-scope", "segment|all"),
    {"set-lines", "one or more of all outline boundary crease[=DEGREES] material intersection",
     kVaries, lines},
    fixed<&G::set_precision>("set-precision", "exact|roundoff[=EPS]"),
    fixed<&G::set_hidden_lines>("set-hidden-lines", "none|dashed"),
    fixed<&G::set_z_buffer>("set-z-buffer", "on|off"),
});

[[noreturn]] void unknown_routine(std::string_view name) {
  std::array<std::string_view, kRoutines.size()> names;
  std::ranges::transform(kRoutines, names.begin(), &Routine::name);
  std::string message = fmt::format("unknown routine {}:", quoted(name));
  if (const std::string meant = did_you_mean(name, names); !meant.empty()) {
    message += meant + " expected a user routine";
  } else {
    message += " expected a user routine, such as open-segment or polygon-abs-3";
  }
  throw ErrorAt(name.data(), message);
}

void carry_out(Line& line, GraphicsSystem& system) {
  const auto routine = std::ranges::find(kRoutines, line.name(), &Routine::name);
  if (routine == kRoutines.end()) unknown_routine(line.name());
  if (routine->arguments != kVaries && std::cmp_not_equal(routine->arguments, line.arguments())) {
    wrong_count(line, *routine);
  }
  routine->call(system, line, *routine);
}

// ---- The text ----------------------------------------------------------------------------

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

/// "FILE:LINE:COLUMN: message" for a place in the text.
Error error_at(std::string_view file_name, std::string_view text, const char* at,
               std::string_view message) {
  const auto before = text.substr(0, static_cast<std::size_t>(at - text.data()));
  const auto line_start = before.rfind('\n') + 1;  // npos + 1 is 0
  return Error(fmt::format("{}:{}:{}: {}", file_name, 1 + std::ranges::count(before, '\n'),
                           1 + std::ranges::count_if(before.substr(line_start),
                                                     [](char c) { return !is_continuation(c); }),
                           message));
}

/// Printable ASCII, line end, tab.
bool is_plain(char c) { return (c >= ' ' && c <= '~') || c == '\n' || c == '\t' || c == '\r'; }

/// Length in bytes of the character at the text's start, 0 if it is none that a drawing
/// program may hold: a control character or not UTF-8.
std::size_t character_length(std::string_view text) {
  if (is_plain(text[0])) return 1;
  return static_cast<unsigned char>(text[0]) < 0x80 ? 0 : utf8_length(text);
}

constexpr std::size_t kBytesAtOnce = 64;

/// is_plain for a block, in bytes and without branches, so that it runs on vectors.
bool is_plain_block(const char* block) {
  std::uint8_t other = 0;
  for (std::size_t i = 0; i < kBytesAtOnce; ++i) {
    const auto c = static_cast<std::int8_t>(block[i]);  // above 0x7F: negative
    const bool other_control = (c < ' ') & (c != '\n') & (c != '\t') & (c != '\r');
    other |= static_cast<std::uint8_t>(other_control | (c > '~'));
  }
  return other == 0;
}

/// Throws Error if the text is binary.
void require_text(std::string_view text, std::string_view file_name) {
  if (begins_in_utf16(text)) {
    throw error_at(file_name, text, text.data(),
                   "not a drawing program: UTF-16, expected UTF-8 text");
  }
  for (std::size_t i = 0; i < text.size();) {
    if (text.size() - i >= kBytesAtOnce && is_plain_block(&text[i])) {
      i += kBytesAtOnce;
      continue;
    }
    const std::size_t block_end = std::min(i + kBytesAtOnce, text.size());
    while (i < block_end) {
      const std::size_t length = character_length(text.substr(i));
      if (length == 0) {
        throw error_at(file_name, text, &text[i],
                       fmt::format("not a drawing program: byte {:#04x}, expected UTF-8 text",
                                   static_cast<unsigned char>(text[i])));
      }
      i += length;
    }
  }
}

}  // namespace

void replay(std::string_view text, std::string_view file_name, GraphicsSystem& system) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // byte order mark
  require_text(text, file_name);
  const std::optional<int> open_before = system.open_segment_name();
  const std::size_t saved_before = system.transformations_saved();
  Line line;
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t length = std::min(rest.find('\n'), rest.size());
    line.split(rest.substr(0, length));
    rest.remove_prefix(std::min(length + 1, rest.size()));
    if (line.empty()) continue;
    try {
      carry_out(line, system);
    } catch (const ErrorAt& error) {
      throw error_at(file_name, text, error.at, error.what());
    } catch (const Error& error) {
      throw error_at(file_name, text, line.name().data(), error.what());
    }
  }
  const auto at_end = [&](const std::string& message) {
    const std::size_t last = text.find_last_not_of(" \t\r\n") + 1;
    return error_at(file_name, text, text.data() + last, message);
  };
  if (const auto open = system.open_segment_name(); open && open != open_before) {
    throw at_end(fmt::format("segment {} still open at the end: expected close-segment", *open));
  }
  if (const std::size_t saved = system.transformations_saved(); saved > saved_before) {
    throw at_end(
        fmt::format("{} transformation{} still saved at the end: expected restore-transformation-3",
                    saved - saved_before, saved - saved_before == 1 ? "" : "s"));
  }
}

void replay_file(const std::string& path, GraphicsSystem& system) {
  replay(read_text_file(path), input_name(path), system);
}

}  // namespace displayfile
