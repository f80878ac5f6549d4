#include "interp/text/cairo_text.h"

#include <fontconfig/fontconfig.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <memory>
#include <numbers>
#include <string_view>

#include "clip/base/shared_library.h"
#include "displayfile/text/characters.h"

namespace displayfile {

namespace {

void require_success(cairo_t* context) {
  require_cairo_success(cairo().status(context), "Cairo cannot draw a text");
}

/// Sets the font without hinting, by which Cairo would fit letters to pixels.
void set_font(cairo_t* context, const std::string& font, double size) {
  cairo().select_font_face(context, font.c_str(), CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
  cairo().set_font_size(context, size);
  cairo_font_options_t* const options = cairo().font_options_create();
  cairo().font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo().font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo().font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo().set_font_options(context, options);
  cairo().font_options_destroy(options);
}

}  // namespace

CairoText::CairoText(cairo_t* context, const std::string& font, const DeviceText& text,
                     const Point2& anchor, double size)
    : context_(context), text_(text) {
  if (text.turn != 0.0) {
    const double angle = text.turn * std::numbers::pi / 180.0;
    along_ = {std::cos(angle), -std::sin(angle)};
  }
  set_font(context, font, size);
  cairo().text_extents(context, text.characters.c_str(), &extents_);
  require_success(context);
  const double before = part_before_anchor(text.style.alignment) * extents_.x_advance;
  start_ = {anchor.x - before * along_.x, anchor.y - before * along_.y};
}

Rectangle CairoText::ink() const {
  const Point2 down(-along_.y, along_.x);
  Rectangle all = Rectangle::nothing();
  for (const double right : {0.0, extents_.width}) {
    for (const double below : {0.0, extents_.height}) {
      all.include(start_ + (extents_.x_bearing + right) * along_ +
                  (extents_.y_bearing + below) * down);
    }
  }
  return all;
}

void CairoText::show() const {
  if (text_.turn == 0.0) {
    cairo().move_to(context_, start_.x, start_.y);
    cairo().show_text(context_, text_.characters.c_str());
    return require_success(context_);
  }
  cairo().save(context_);
  cairo().translate(context_, start_.x, start_.y);
  cairo().rotate(context_, std::atan2(along_.y, along_.x));
  cairo().move_to(context_, 0.0, 0.0);
  cairo().show_text(context_, text_.characters.c_str());
  cairo().restore(context_);
  require_success(context_);
}

namespace {

/// The closed paths of a flattened Cairo path, translated.
LetterPaths::Letter closed_paths(const cairo_path_t& path, const Point2& move) {
  LetterPaths::Letter paths;
  for (int i = 0; i < path.num_data; i += path.data[i].header.length) {
    const cairo_path_data_t& entry = path.data[i];
    if (entry.header.type == CAIRO_PATH_CLOSE_PATH) continue;
    if (entry.header.type == CAIRO_PATH_MOVE_TO || paths.empty()) paths.emplace_back();
    const auto& point = path.data[i + 1].point;
    paths.back().push_back(Point2(point.x, point.y) + move);
  }
  for (auto& points : paths) {
    if (points.size() > 1 && points.front() == points.back()) points.pop_back();
  }
  std::erase_if(paths, [](const auto& points) { return points.size() < 3; });
  return paths;
}

}  // namespace

/// Each letter is placed at the end of its predecessors' advances, as in show(). It is outlined at
/// the origin: Cairo omits letters that are far from a context's surface.
std::vector<LetterPaths::Letter> CairoText::outlines() const {
  constexpr double kTolerance = 0.01;
  const auto destroy = [](cairo_path_t* path) { cairo().path_destroy(path); };
  cairo().set_tolerance(context_, kTolerance);
  std::vector<LetterPaths::Letter> letters;
  double x = start_.x;
  for (std::string_view rest = text_.characters; !rest.empty();) {
    const std::size_t length = std::max<std::size_t>(utf8_length(rest), 1);
    const std::string letter(rest.substr(0, length));
    rest.remove_prefix(length);
    cairo().new_path(context_);
    cairo().move_to(context_, 0.0, 0.0);
    cairo().text_path(context_, letter.c_str());
    const std::unique_ptr<cairo_path_t, decltype(destroy)> path(cairo().copy_path_flat(context_));
    require_success(context_);
    require_cairo_success(path->status, "Cairo cannot outline a text");
    letters.push_back(closed_paths(*path, {x, start_.y}));
    cairo_text_extents_t extents;
    cairo().text_extents(context_, letter.c_str(), &extents);
    x += extents.x_advance;
  }
  return letters;
}

std::vector<LetterPaths::Letter> letter_outlines(const std::string& font, const DeviceText& text,
                                                 const Point2& anchor, double size) {
  const auto destroy_surface = [](cairo_surface_t* s) { cairo().surface_destroy(s); };
  const auto destroy = [](cairo_t* c) { cairo().destroy(c); };
  const std::unique_ptr<cairo_surface_t, decltype(destroy_surface)> surface(
      cairo().image_surface_create(CAIRO_FORMAT_A8, 1, 1));
  const std::unique_ptr<cairo_t, decltype(destroy)> context(cairo().create(surface.get()));
  return CairoText(context.get(), font, text, anchor, size).outlines();
}

namespace {

/// Fontconfig, by which Cairo finds fonts.
struct Fontconfig {
  SharedLibrary library{"libfontconfig.so.1"};
  DISPLAYFILE_LIBRARY_FUNCTION(library, Fc, PatternCreate);
  DISPLAYFILE_LIBRARY_FUNCTION(library, Fc, PatternAddString);
  DISPLAYFILE_LIBRARY_FUNCTION(library, Fc, PatternGetString);
  DISPLAYFILE_LIBRARY_FUNCTION(library, Fc, PatternDestroy);
  DISPLAYFILE_LIBRARY_FUNCTION(library, Fc, ConfigSubstitute);
  DISPLAYFILE_LIBRARY_FUNCTION(library, Fc, DefaultSubstitute);
  DISPLAYFILE_LIBRARY_FUNCTION(library, Fc, FontMatch);
};

std::string in_small_letters(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

/// True if one of the pattern's family names, which may be in several languages, is `family`.
bool has_family(const Fontconfig& fc, FcPattern* pattern, const std::string& family) {
  FcChar8* name = nullptr;
  for (int i = 0; fc.PatternGetString(pattern, FC_FAMILY, i, &name) == FcResultMatch; ++i) {
    const std::string found = reinterpret_cast<const char*>(name);
    if (in_small_letters(found) == in_small_letters(family)) return true;
  }
  return false;
}

bool is_kind_of_font(const std::string& family) {
  constexpr std::string_view kKinds[] = {"sans-serif", "sans",    "serif",
                                         "monospace",  "cursive", "fantasy"};
  return std::ranges::find(kKinds, family) != std::end(kKinds);
}

}  // namespace

std::string font_in_place_of(const std::string& family) try {
  if (is_kind_of_font(family)) return {};
  static const Fontconfig fc;
  const auto destroy = [](FcPattern* pattern) { fc.PatternDestroy(pattern); };
  using Pattern = std::unique_ptr<FcPattern, decltype(destroy)>;
  const Pattern wanted(fc.PatternCreate());
  if (wanted == nullptr) return {};
  fc.PatternAddString(wanted.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(family.c_str()));
  fc.ConfigSubstitute(nullptr, wanted.get(), FcMatchPattern);
  fc.DefaultSubstitute(wanted.get());
  FcResult result = FcResultNoMatch;
  const Pattern found(fc.FontMatch(nullptr, wanted.get(), &result));
  if (found == nullptr || has_family(fc, found.get(), family)) return {};
  FcChar8* name = nullptr;
  if (fc.PatternGetString(found.get(), FC_FAMILY, 0, &name) != FcResultMatch) return {};
  return reinterpret_cast<const char*>(name);
} catch (const Error&) {  // there is no Fontconfig
  return {};
}

}  // namespace displayfile
