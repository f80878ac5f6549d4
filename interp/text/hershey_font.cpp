#include "interp/text/hershey_font.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <memory>
#include <mutex>
#include <numbers>
#include <optional>
#include <system_error>
#include <utility>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "clip/base/nearest_word.h"
#include "displayfile/text/characters.h"

namespace displayfile {

namespace {

constexpr std::string_view kFontFolder = DISPLAYFILE_HERSHEY_FONTS;
constexpr std::string_view kFontExtension = ".jhf";
constexpr int kBaseLine = 9;            // y of the base line in the file; capitals begin at -12
constexpr double kCapitalUnits = 21.0;  // their height
constexpr char kFirstCharacter = ' ';   // of the first glyph
constexpr double kUnitOfSize = HersheyFont::kCapitalsOfSize / kCapitalUnits;

/// Characters drawn as a similar one of ASCII, such as the minus signs of axes.
constexpr std::pair<std::string_view, char> kStandIns[] = {
    {"\u2212", '-'}, {"\u2010", '-'},  {"\u2011", '-'},  {"\u2012", '-'}, {"\u2013", '-'},
    {"\u2014", '-'}, {"\u2018", '\''}, {"\u2019", '\''}, {"\u201c", '"'}, {"\u201d", '"'},
    {"\u00d7", 'x'}, {"\u00a0", ' '},  {"\u2009", ' '},  {"\u202f", ' '}};

/// The ASCII byte drawn for a character; none if there is none.
std::optional<char> in_ascii(std::string_view character) {
  if (character.size() == 1) return character[0];
  const auto* const found =
      std::ranges::find(kStandIns, character, &std::pair<std::string_view, char>::first);
  if (found == std::end(kStandIns)) return std::nullopt;
  return found->second;
}

std::vector<std::string> hershey_fonts() {
  std::vector<std::string> names;
  std::error_code unknown;
  for (const auto& file : std::filesystem::directory_iterator(kFontFolder, unknown)) {
    if (file.path().extension() == kFontExtension) names.push_back(file.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

/// The file of a font.
std::string file_of(const std::string& name) {
  const std::vector<std::string> names = hershey_fonts();
  if (names.empty()) {
    throw Error(
        fmt::format("font hershey: no Hershey fonts in {}: expected Debian's package "
                    "hershey-fonts-data to be installed",
                    kFontFolder));
  }
  if (std::ranges::find(names, name) == names.end()) {
    const std::vector<std::string_view> known(names.begin(), names.end());
    throw Error(fmt::format("font hershey:{}: unknown Hershey font:{} expected one of {}", name,
                            did_you_mean(name, known), fmt::join(names, " ")));
  }
  return fmt::format("{}/{}{}", kFontFolder, name, kFontExtension);
}

/// The length of the character at the start of a text; 1 for invalid UTF-8.
std::size_t length_of_first(std::string_view text) {
  return std::max<std::size_t>(utf8_length(text), 1);
}

template <class Visit>
void for_each_character(std::string_view text, const Visit& visit) {
  while (!text.empty()) {
    const std::size_t length = length_of_first(text);
    visit(text.substr(0, length));
    text.remove_prefix(length);
  }
}

}  // namespace

HersheyFont::HersheyFont(const std::string& name) : name_(name) {
  const std::string path = file_of(name);
  read(read_text_file(path), path);
  add_signs();
}

/// A glyph is five characters of its number, three of the number of pairs that follow, and the
/// pairs: its left and right side, and points, each coordinate as the distance from R. A pair ` R`
/// lifts the pen. Line breaks mean nothing.
void HersheyFont::read(std::string_view text, const std::string& path) {
  constexpr std::size_t kNumber = 5, kCount = 3;
  std::string joined;
  for (const char c : text) {
    if (c != '\n' && c != '\r') joined.push_back(c);
  }
  const auto require = [&](bool is_as_expected) {
    if (!is_as_expected) {
      throw Error(fmt::format("{}: glyph {} is damaged: expected a Hershey font", path,
                              glyphs_.size() + 1));
    }
  };
  for (std::string_view rest = joined; !rest.empty();) {
    require(rest.size() >= kNumber + kCount);
    std::string_view digits = rest.substr(kNumber, kCount);
    digits.remove_prefix(std::min(digits.find_first_not_of(' '), digits.size()));
    std::size_t pairs = 0;
    const char* const end = digits.data() + digits.size();
    const auto [stop, failure] = std::from_chars(digits.data(), end, pairs);
    rest.remove_prefix(kNumber + kCount);
    require(failure == std::errc{} && stop == end && pairs > 0 && rest.size() >= 2 * pairs);
    Glyph& glyph = glyphs_.emplace_back();
    glyph.left = rest[0] - 'R';
    glyph.right = rest[1] - 'R';
    bool is_up = true;
    for (std::size_t k = 1; k < pairs; ++k) {
      const char x = rest[2 * k], y = rest[2 * k + 1];
      if (x == ' ' && y == 'R') {
        is_up = true;
        continue;
      }
      if (is_up) glyph.strokes.emplace_back();
      is_up = false;
      glyph.strokes.back().emplace_back(x - 'R', y - 'R' - kBaseLine);
    }
    for (auto& stroke : glyph.strokes) {
      if (stroke.size() == 1) stroke.push_back(stroke.front());  // a dot
    }
    rest.remove_prefix(2 * pairs);
  }
}

/// The signs of dimensions, which no Hershey font has: a circle struck through for diameters, a
/// small one for degrees, and a plus over a minus.
void HersheyFont::add_signs() {
  const auto circle = [](const Point2& centre, double radius) {
    constexpr int kSides = 24;
    std::vector<Point2> points;
    for (int k = 0; k <= kSides; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / kSides;
      points.push_back(centre + radius * Point2(std::cos(angle), std::sin(angle)));
    }
    return points;
  };
  constexpr double kMiddle = -0.5 * kCapitalUnits;
  Glyph diameter{-12, 12, {circle({0.0, kMiddle}, 8.0), {{-7.0, 0.0}, {7.0, -kCapitalUnits}}}};
  signs_.emplace_back("\u2300", diameter);
  signs_.emplace_back("\u00d8", std::move(diameter));
  signs_.emplace_back("\u00b0", Glyph{-6, 6, {circle({0.0, 4.0 - kCapitalUnits}, 3.5)}});
  signs_.emplace_back("\u00b1", Glyph{-13,
                                      13,
                                      {{{0.0, -18.0}, {0.0, -4.0}},
                                       {{-8.0, -11.0}, {8.0, -11.0}},
                                       {{-8.0, 0.0}, {8.0, 0.0}}}});
}

const HersheyFont::Glyph* HersheyFont::glyph(std::string_view character) const {
  for (const auto& [sign, drawn] : signs_) {
    if (sign == character) return &drawn;
  }
  const std::optional<char> byte = in_ascii(character);
  if (!byte || *byte < kFirstCharacter) return nullptr;
  const auto place = static_cast<std::size_t>(*byte - kFirstCharacter);
  return place < glyphs_.size() ? &glyphs_[place] : nullptr;
}

double HersheyFont::width(std::string_view text) const {
  int units = 0;
  for_each_character(text, [&](std::string_view character) {
    if (const Glyph* const one = glyph(character)) units += one->right - one->left;
  });
  return units * kUnitOfSize;
}

std::vector<std::vector<Point2>> HersheyFont::strokes(std::string_view text, const Point2& start,
                                                      double across, double down) const {
  std::vector<std::vector<Point2>> all;
  const Point2 unit(across * kUnitOfSize, down * kUnitOfSize);
  int pen = 0;  // in units
  for_each_character(text, [&](std::string_view character) {
    const Glyph* const one = glyph(character);
    if (one == nullptr) return;
    for (const auto& stroke : one->strokes) {
      auto& placed = all.emplace_back();
      for (const Point2& p : stroke) {
        placed.push_back(start + Point2((pen + p.x - one->left) * unit.x, p.y * unit.y));
      }
    }
    pen += one->right - one->left;
  });
  return all;
}

void HersheyFont::add_lacking(std::string_view text, std::set<std::string>& lacking) const {
  for_each_character(text, [&](std::string_view character) {
    if (glyph(character) == nullptr) lacking.emplace(character);
  });
}

const HersheyFont& hershey_font(const std::string& name) {
  static std::mutex reading;
  static std::map<std::string, std::unique_ptr<const HersheyFont>> fonts;
  const std::lock_guard lock(reading);
  auto& font = fonts[name];
  if (font == nullptr) font = std::make_unique<const HersheyFont>(name);
  return *font;
}

}  // namespace displayfile
