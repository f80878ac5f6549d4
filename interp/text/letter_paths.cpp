#include "interp/text/letter_paths.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <set>
#include <string_view>

#include "clip/base/error.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/text/characters.h"
#include "interp/annotation/annotation_marks.h"
#include "interp/text/hershey_font.h"

namespace displayfile {

bool Lettering::is_of_strokes() const {
  return font == kHershey || (font.starts_with(kHershey) && font[kHershey.size()] == ':');
}

const HersheyFont& hershey_font_of(const Lettering& lettering) {
  constexpr std::size_t kPrefix = Lettering::kHershey.size();
  return hershey_font(lettering.font.size() == kPrefix ? std::string(HersheyFont::kUsual)
                                                       : lettering.font.substr(kPrefix + 1));
}

void require_lettering(const Lettering& lettering) {
  if (lettering.is_of_strokes()) {
    hershey_font_of(lettering);
    if (!lettering.outlines) return;
    throw Error(
        fmt::format("font {} is strokes, which have no outlines: expected text as text, or "
                    "another font",
                    lettering.font));
  }
  constexpr std::size_t kLongest = 100;
  const std::string font = lettering.family();
  const bool is_name = !font.empty() && font.size() <= kLongest && font.front() != ' ' &&
                       font.back() != ' ' && drawable_length(font) == font.size() &&
                       font.find_first_of("'\"\\<>&;:{}(),/") == std::string::npos;
  if (is_name) return;
  throw Error(
      fmt::format("font '{}': expected the name of a font of the system, such as DejaVu Serif, "
                  "hershey, or hershey:NAME",
                  drawable(font.substr(0, kLongest))));
}

Lettering lettering_of(std::optional<std::string_view> font, std::optional<std::string_view> text) {
  Lettering lettering;
  if (font) {
    lettering.font = *font;
    if (font->empty()) {
      throw Error(
          "font '': expected the name of a font of the system, such as DejaVu Serif, "
          "hershey, or hershey:NAME");
    }
  }
  lettering.outlines = text == "outlines";
  if (text && *text != "text" && !lettering.outlines) {
    throw Error(fmt::format("text '{}': expected text or outlines", drawable(*text)));
  }
  require_lettering(lettering);
  return lettering;
}

double part_before_anchor(TextStyle::Alignment alignment) {
  switch (alignment) {
    case TextStyle::Alignment::left: return 0.0;
    case TextStyle::Alignment::centre: return 0.5;
    case TextStyle::Alignment::right: break;
  }
  return 1.0;
}

Rectangle LetterPaths::around() const {
  Rectangle box = Rectangle::nothing();
  for (const Letter& letter : letters) {
    for (const auto& path : letter) {
      for (const Point2& p : path) box.include(p);
    }
  }
  return box;
}

namespace {

/// Turns paths about a point, counterclockwise, y down.
void turn_about(const Point2& centre, double degrees, LetterPaths& paths) {
  const double angle = degrees * std::numbers::pi / 180.0;
  const double cosine = std::cos(angle), sine = std::sin(angle);
  for (LetterPaths::Letter& letter : paths.letters) {
    for (auto& points : letter) {
      for (Point2& p : points) {
        const Point2 from = p - centre;
        p = centre + Point2(cosine * from.x + sine * from.y, cosine * from.y - sine * from.x);
      }
    }
  }
}

}  // namespace

std::optional<LetterPaths> letter_paths(const Lettering& lettering, const DeviceText& text,
                                        const Point2& anchor, double size) {
  if (text.turn != 0.0) {
    DeviceText level = text;
    level.turn = 0.0;
    auto turned = letter_paths(lettering, level, anchor, size);
    if (turned) turn_about(anchor, text.turn, *turned);
    return turned;
  }
  LetterPaths paths;
  if (lettering.outlines) {
    paths.are_outlines = true;
    paths.stroke.colour = text.line.colour;
    paths.stroke.width = text.line.width;
    paths.letters = letter_outlines(lettering.family(), text, anchor, size);
    return paths;
  }
  if (!lettering.is_of_strokes()) return std::nullopt;
  const HersheyFont& font = hershey_font_of(lettering);
  const double before = part_before_anchor(text.style.alignment);
  const Point2 start(anchor.x - before * font.width(text.characters) * size, anchor.y);
  paths.stroke.colour = text.line.colour;
  paths.stroke.width = text.line.width;
  paths.letters.push_back(font.strokes(text.characters, start, size, size));
  return paths;
}

Lettering lettering_of_pens(const Lettering& lettering) {
  if (lettering.is_of_paths()) return lettering;
  Lettering of_strokes;
  of_strokes.font = Lettering::kHershey;
  return of_strokes;
}

namespace {

void add_lacking_of_texts(const DisplayFile& display_file, const HersheyFont& font,
                          std::set<std::string>& lacking) {
  for (const Segment* segment : display_file.visible_segments()) {
    font.add_lacking(segment->entered()->characters(), lacking);
  }
}

void add_lacking_of_annotation(const DisplayFile& display_file, const HersheyFont& font,
                               std::set<std::string>& lacking) {
  constexpr AnnotationPage kAnyPage{1000, 1000, 1.0};
  for (const AnnotationMark& mark : annotation_marks(display_file, kAnyPage)) {
    if (mark.kind != AnnotationMark::Kind::text) continue;
    font.add_lacking(mark.text.characters, lacking);
  }
}

/// Warnings of a font used in place of the one set.
std::vector<std::string> warnings_of_other_font(const Lettering& lettering) {
  const std::string other = font_in_place_of(lettering.font);
  if (other.empty()) return {};
  return {fmt::format("this system has no font {}: {} stands in its place", lettering.font, other)};
}

}  // namespace

std::vector<std::string> lettering_warnings(const Lettering& lettering,
                                            const DisplayFile& display_file, bool by_pens) {
  const bool has_annotation = display_file.has_annotations();
  if (!display_file.has_texts() && !has_annotation) return {};
  std::vector<std::string> all;
  if (!lettering.is_of_strokes() && !lettering.font.empty()) {
    all = warnings_of_other_font(lettering);
  }
  const Lettering of_annotation = by_pens ? lettering_of_pens(lettering) : lettering;
  const bool in_strokes = of_annotation.is_of_strokes() && has_annotation;
  if (!lettering.is_of_strokes() && !in_strokes) return all;
  const HersheyFont& font = hershey_font_of(of_annotation);
  std::set<std::string> lacking;
  if (lettering.is_of_strokes()) add_lacking_of_texts(display_file, font, lacking);
  if (in_strokes) add_lacking_of_annotation(display_file, font, lacking);
  if (!lacking.empty()) {
    all.push_back(fmt::format("the Hershey font {} lacks {}: left out", font.name(),
                              fmt::join(lacking, " ")));
  }
  return all;
}

}  // namespace displayfile
