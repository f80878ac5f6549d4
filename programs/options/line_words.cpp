#include "programs/options/line_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "clip/base/error.h"
#include "clip/base/words.h"
#include "programs/options/colour_word.h"

namespace displayfile {

namespace {

using Unit = LineLength::Unit;

constexpr double kMillimetresOfPoint = 25.4 / 72.0;

std::string_view part_before(std::string_view& rest, char separator) {
  const std::size_t length = std::min(rest.find(separator), rest.size());
  const std::string_view part = rest.substr(0, length);
  rest.remove_prefix(std::min(length + 1, rest.size()));
  return part;
}

[[noreturn]] void refuse_style(std::string_view item) {
  throw Error(fmt::format(
      "--lines {}: expected KIND=WIDTH, and after it, optional and after blanks, solid or dashed "
      "[DASH GAP], and a colour, #rrggbb, black or white, such as hidden=0.13 dashed; lengths are "
      "in pixels, in mm with --paper, or have a unit: px, mm or pt",
      item));
}

/// Refuses what is no kind that --lines knows, with all that it knows.
void require_known(std::string_view name, std::string_view word, LineWords::Takes takes) {
  std::vector<std::string_view> known;
  for (const LineKindEntry& kind : line_kinds()) known.push_back(kind.name);
  if (std::ranges::find(known, name) != known.end()) return;
  if (takes == LineWords::Takes::styles) {
    known.push_back(name_of(StyledLines::hidden));
    known.emplace_back("hatch=WIDTH");
  }
  refuse_word(word, known, "--lines: expected");
}

/// True if the value after crease= is an angle: a number without a unit, unless it can only be a
/// width.
bool is_angle(std::string_view value) {
  const auto length = line_length_of(value);
  if (!length) return value.ends_with("deg");
  const bool is_width = length->value > 0.0 && length->value < LineWords::kLeastDegrees;
  return length->unit == Unit::unset && !is_width;
}

}  // namespace

std::optional<LineLength> line_length_of(std::string_view word) {
  LineLength length{};
  const char* const end = word.data() + word.size();
  const auto [stop, failure] = std::from_chars(word.data(), end, length.value);
  if (failure != std::errc{} || !std::isfinite(length.value)) return std::nullopt;
  const std::string_view unit(stop, static_cast<std::size_t>(end - stop));
  if (unit.empty()) {
    length.unit = Unit::unset;
  } else if (unit == "px") {
    length.unit = Unit::pixels;
  } else if (unit == "mm") {
    length.unit = Unit::millimetres;
  } else if (unit == "pt") {
    length.unit = Unit::points;
  } else {
    return std::nullopt;
  }
  return length;
}

double LineLength::in_pixels(const PixelSize& pixel, std::string_view what) const {
  const Unit in =
      unit != Unit::unset ? unit : (pixel.is_on_paper ? Unit::millimetres : Unit::pixels);
  double pixels = value;
  if (in != Unit::pixels) {
    if (!pixel.millimetres) {
      throw Error(
          fmt::format("{}: a length in {} needs a picture whose size in mm is known: expected "
                      "--paper, --size in mm, --dpi with .png, or pixels",
                      what, in == Unit::points ? "pt" : "mm"));
    }
    const double millimetres = in == Unit::points ? value * kMillimetresOfPoint : value;
    pixels = millimetres / *pixel.millimetres;
  }
  if (pixels > 0.0 && pixels <= 1e6) return pixels;
  throw Error(fmt::format("{}: expected lengths above 0 and at most 1e6 pixels", what));
}

double length_of_option(std::string_view option, const std::string& word, const PixelSize& pixel) {
  const std::string what = fmt::format("{} {}", option, word);
  const auto length = line_length_of(word);
  if (length) return length->in_pixels(pixel, what);
  throw Error(what +
              ": expected a length, in pixels, in mm with --paper or --pens, or with a unit: "
              "0.35mm, 1pt or 2px");
}

double halo_of_option(const std::string& word, const PixelSize& pixel) {
  const auto length = line_length_of(word);
  const bool is_none = length && length->value == 0.0;
  return is_none ? 0.0 : length_of_option("--halo", word, pixel);
}

LineWords::LineWords(std::string_view text, Takes takes) : takes_(takes), text_(text) {
  if (text.empty() || text.ends_with(',')) select(text.empty() ? text : "");
  for (std::string_view rest = text; !rest.empty();) read(part_before(rest, ','));
}

void LineWords::select(std::string_view word) {
  require_known(word.substr(0, word.find('=')), word, takes_);
  try {
    LineSelection selection = selection_.value_or(LineSelection{.kinds = 0});
    add_line_kind(word, selection);
    selection_ = selection;
  } catch (const Error& error) {
    throw Error("--lines: " + std::string(error.what()));
  }
}

void LineWords::read(std::string_view item) {
  std::string_view rest = item;
  const std::string_view name = part_before(rest, '=');
  const bool has_style = name.size() < item.size();
  const bool is_hidden = name == name_of(StyledLines::hidden);
  const bool is_hatching = name == name_of(StyledLines::hatch);
  if (is_hatching && !has_style) {
    throw Error(
        "--lines hatch: hatching is drawn by set-cut-faces hatched of a program: expected "
        "hatch=WIDTH, its style");
  }
  if (name == name_of(StyledLines::crease) && has_style && is_angle(rest)) {
    const bool has_unit = rest.ends_with("deg");
    return select(item.substr(0, item.size() - (has_unit ? 3 : 0)));
  }
  if (is_hidden) {
    draws_hidden_ = true;
  } else if (!is_hatching) {
    select(name);
  }
  if (!has_style) return;
  Style style{std::string(item), styled_lines(name), {}};
  if (rest.empty()) refuse_style(item);
  while (!rest.empty()) {
    const std::string_view word = part_before(rest, ' ');
    const bool is_dashed = style.style.kind == LineStyle::Kind::dashed;
    if (word.empty()) continue;
    if ((word == "solid" || word == "dashed") && !style.style.kind) {
      style.style.kind = word == "solid" ? LineStyle::Kind::solid : LineStyle::Kind::dashed;
    } else if (const auto length = line_length_of(word)) {
      std::optional<LineLength>& next =
          is_dashed ? (style.dash ? style.gap : style.dash) : style.width;
      if (next) refuse_style(item);
      next = length;
    } else if (const auto colour = colour_of(word); colour && !style.style.colour) {
      style.style.colour = colour;
    } else {
      refuse_style(item);
    }
  }
  if (style.dash.has_value() != style.gap.has_value()) refuse_style(item);
  styles_.push_back(std::move(style));
}

std::vector<StyleOfKind> LineWords::styles(const PixelSize& pixel) const {
  std::vector<StyleOfKind> all;
  for (const Style& written : styles_) {
    StyleOfKind of_kind{written.lines, written.style};
    const auto pixels = [&](const std::optional<LineLength>& length) {
      return length ? std::optional(length->in_pixels(pixel, "--lines " + written.item))
                    : std::nullopt;
    };
    of_kind.style.width = pixels(written.width);
    of_kind.style.dash = pixels(written.dash);
    of_kind.style.gap = pixels(written.gap);
    all.push_back(of_kind);
  }
  return all;
}

}  // namespace displayfile
