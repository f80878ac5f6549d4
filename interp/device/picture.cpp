#include "interp/device/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/nearest_word.h"
#include "clip/base/words.h"

namespace displayfile {

namespace {

struct SheetSize {
  std::string_view name;
  double width, height;
};
constexpr std::array kSheetSizes{
    SheetSize{"a0", 841.0, 1189.0},   SheetSize{"a1", 594.0, 841.0},
    SheetSize{"a2", 420.0, 594.0},    SheetSize{"a3", 297.0, 420.0},
    SheetSize{"a4", 210.0, 297.0},    SheetSize{"a5", 148.0, 210.0},
    SheetSize{"a6", 105.0, 148.0},    SheetSize{"letter", 215.9, 279.4},
    SheetSize{"legal", 215.9, 355.6}, SheetSize{"tabloid", 279.4, 431.8},
};
constexpr std::string_view kSheetWords = "A0 to A6, letter, legal, tabloid, or WIDTHxHEIGHT in mm";

std::string in_lower_case(std::string_view word) {
  std::string lower(word);
  std::ranges::transform(lower, lower.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return lower;
}

bool is_side_of_sheet(double side) { return side >= 1.0 && side <= kLargestSheet; }

void require_sheet(double width, double height) {
  if (is_side_of_sheet(width) && is_side_of_sheet(height)) return;
  throw Error(
      fmt::format("paper of {}x{} mm: expected sides of 1 to {} mm", width, height, kLargestSheet));
}

/// The width and height of a word of the form WxH; none for another word.
std::optional<std::pair<double, double>> sides_of(std::string_view word) {
  double width = 0.0, height = 0.0;
  const char *const begin = word.data(), *const end = begin + word.size();
  const auto w = std::from_chars(begin, end, width);
  if (w.ec != std::errc{} || w.ptr == end || *w.ptr != 'x') return std::nullopt;
  const auto h = std::from_chars(w.ptr + 1, end, height);
  if (h.ec != std::errc{} || h.ptr != end) return std::nullopt;
  return std::pair(width, height);
}

}  // namespace

std::vector<std::string> sheet_names() {
  std::vector<std::string> names;
  names.reserve(std::size(kSheetSizes));
  for (const SheetSize& sheet : kSheetSizes) names.emplace_back(sheet.name);
  return names;
}

Paper paper_of(std::string_view word) {
  const std::string lower = in_lower_case(word);
  std::string_view size = lower;
  Paper paper;
  const auto is_turned = [&](std::string_view suffix) {
    if (!size.ends_with(suffix)) return false;
    size.remove_suffix(suffix.size());
    return true;
  };
  const bool portrait = is_turned("-portrait"), landscape = !portrait && is_turned("-landscape");
  if (portrait) paper.turned = Paper::Turned::portrait;
  if (landscape) paper.turned = Paper::Turned::landscape;
  const auto* const sheet = std::ranges::find(kSheetSizes, size, &SheetSize::name);
  if (sheet != kSheetSizes.end()) {
    paper.width = sheet->width;
    paper.height = sheet->height;
    return paper;
  }
  const auto sides = sides_of(size);
  if (!sides) {
    std::vector<std::string_view> names;
    names.reserve(kSheetSizes.size());
    for (const SheetSize& s : kSheetSizes) names.push_back(s.name);
    const bool is_other_a = size.size() > 1 && size[0] == 'a' && size[1] >= '0' && size[1] <= '9';
    throw Error(fmt::format(
        "unknown paper '{}':{} expected {}, with -portrait or -landscape after it or without", word,
        is_other_a ? "" : did_you_mean(size, names), kSheetWords));
  }
  std::tie(paper.width, paper.height) = *sides;
  require_sheet(paper.width, paper.height);
  if (!portrait && !landscape) {
    paper.turned = paper.width > paper.height ? Paper::Turned::landscape : Paper::Turned::portrait;
  }
  return paper;
}

namespace {

/// Throws Error unless a picture fits, up to rounding. Millimetres.
void require_room(const Point2& room, const Point2& picture) {
  if (!(picture.x > 0.0 && picture.y > 0.0)) {
    throw Error("pixels on paper: expected a side of more than 0 mm");
  }
  const Point2 over = picture - room;
  if (over.x <= kOverMargins && over.y <= kOverMargins) return;
  const bool is_wide = over.x > over.y;
  throw Error(fmt::format(
      "a picture of {:.6g}x{:.6g} mm does not fit on the paper, which has {:.6g}x{:.6g} mm between "
      "its margins: it is {:.6g} mm too {}",
      picture.x, picture.y, room.x, room.y, is_wide ? over.x : over.y, is_wide ? "wide" : "high"));
}

}  // namespace

PaperFit fit_on_paper(const Paper& paper, int picture_width, int picture_height) {
  require_sheet(paper.width, paper.height);
  const bool landscape = paper.turned == Paper::Turned::automatic
                             ? picture_width > picture_height
                             : paper.turned == Paper::Turned::landscape;
  const auto [shorter, longer] = std::minmax(paper.width, paper.height);
  PaperFit fit{};
  fit.width = landscape ? longer : shorter;
  fit.height = landscape ? shorter : longer;
  const double across = fit.width - 2.0 * paper.margin, down = fit.height - 2.0 * paper.margin;
  if (!(paper.margin >= 0.0) || !(across >= 1.0) || !(down >= 1.0)) {
    throw Error(
        fmt::format("margins of {} mm on paper of {}x{} mm: expected 0 or more, with 1 mm "
                    "or more between them",
                    paper.margin, fit.width, fit.height));
  }
  fit.pixel = std::min(across / picture_width, down / picture_height);
  if (paper.pixel) {
    require_room({across, down}, {*paper.pixel * picture_width, *paper.pixel * picture_height});
    fit.pixel = *paper.pixel;
  }
  fit.left = (fit.width - fit.pixel * picture_width) / 2.0;
  fit.top = (fit.height - fit.pixel * picture_height) / 2.0;
  return fit;
}

PenOrder pen_order(std::string_view text) {
  constexpr Word<PenOrder> kOrders[] = {{PenOrder::travel, "travel"}, {PenOrder::cut, "cut"}};
  return value_of(kOrders, text, "the order of pens is");
}

void require_pens(const Pens& pens) {
  for (std::size_t k = 0; k < pens.layers.size(); ++k) {
    for (std::size_t i = 0; i < k; ++i) {
      if (pixel_of(pens.layers[i]) != pixel_of(pens.layers[k])) continue;
      throw Error(fmt::format("layers {} and {} of pens have one colour: expected each colour once",
                              i + 1, k + 1));
    }
  }
  if (!pens.hatching) return;
  const Hatching& hatching = *pens.hatching;
  if (!(hatching.spacing >= kClosestHatching && hatching.spacing <= kLargestSheet)) {
    throw Error(fmt::format("hatching {} mm apart: expected {} to {} mm", hatching.spacing,
                            kClosestHatching, kLargestSheet));
  }
  if (!std::isfinite(hatching.angle)) throw Error("hatching at an angle that is no number");
  if (!(hatching.width > 0.0 && hatching.width <= kLargestSheet)) {
    throw Error(fmt::format("hatching by a pen of {} mm: expected more than 0", hatching.width));
  }
}

void require_picture_size(long long width, long long height) {
  if (width >= 1 && height >= 1 && width <= kLargestSide && height <= kLargestSide) return;
  throw Error(fmt::format("picture size {}x{}: expected 1x1 to {}x{} pixels", width, height,
                          kLargestSide, kLargestSide));
}

namespace {

bool is_prefix_of_ids(std::string_view word) {
  const auto begins = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  return begins(word.front()) && std::ranges::all_of(word, [&](char c) {
           return begins(c) || (c >= '0' && c <= '9') || c == '-';
         });
}

}  // namespace

void require_vector_options(const VectorOptions& options) {
  constexpr double kFinest = VectorOptions::kFinestPrecision;
  constexpr double kCoarsest = VectorOptions::kCoarsestPrecision;
  if (!(options.precision >= kFinest && options.precision <= kCoarsest)) {
    throw Error("precision of vectors " + std::to_string(options.precision) +
                ": expected 0.001 to 1 pixels");
  }
  if (options.id_prefix.empty() || is_prefix_of_ids(options.id_prefix)) return;
  throw Error(fmt::format(
      "prefix of ids '{}': expected letters a-z and A-Z, digits, - and _, the first a letter or _",
      options.id_prefix));
}

}  // namespace displayfile
