#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "clip/surfaces.h"
#include "displayfile/looks/style.h"

namespace displayfile {

/// The sizes in which lengths of lines are converted to pixels.
struct PixelSize {
  /// A pixel's side in millimetres; none: unknown, and lengths in mm or pt are refused.
  std::optional<double> millimetres{};
  bool is_on_paper = false;  ///< numbers without a unit are millimetres, not pixels
};

/// A length as a number, or a number and its unit: px, mm or pt. None for any other word.
struct LineLength {
  enum class Unit { unset, pixels, millimetres, points };
  double value;
  Unit unit;

  /// In pixels. Throws Error, beginning with `what`, for a unit that needs a pixel's size.
  double in_pixels(const PixelSize& pixel, std::string_view what) const;
};
std::optional<LineLength> line_length_of(std::string_view word);
/// The value of an option such as --line-width, in pixels. Throws Error, naming the option, for
/// another word, and as in_pixels.
double length_of_option(std::string_view option, const std::string& word, const PixelSize& pixel);
/// The value of --halo, likewise; it may be 0.
double halo_of_option(const std::string& word, const PixelSize& pixel);

/// The style of lines of one kind.
struct StyleOfKind {
  StyledLines lines;
  LineKindStyle style;
};

/// The value of --lines: which kinds of lines are drawn, and in which styles.
class LineWords {
 public:
  /// Reads KIND, KIND=STYLE or crease=DEGREES, one or more, separated by commas; `hatch`, that of
  /// cut faces, only with a style. A number after
  /// crease= is a width if it is above 0 and below kLeastDegrees, or has a unit of length. Throws
  /// Error, naming the option, for anything else.
  ///
  /// Where styles are not taken, they are refused by selection_of (hidden_surface_words.h); the
  /// message of an unknown kind lists those that are taken.
  enum class Takes { kinds, styles };
  explicit LineWords(std::string_view text, Takes takes = Takes::kinds);

  static constexpr double kLeastDegrees = 5.0;

  /// None: no kind is named, except hidden and hatch.
  const std::optional<LineSelection>& selection() const { return selection_; }
  const std::string& text() const { return text_; }
  bool has_styles() const { return !styles_.empty(); }
  bool draws_hidden() const { return draws_hidden_; }
  /// With lengths in pixels. Throws Error for a unit that needs a pixel's size, a length that is
  /// not above 0, or one above 1e6 pixels.
  std::vector<StyleOfKind> styles(const PixelSize& pixel) const;

 private:
  struct Style {
    std::string item;  ///< as written
    StyledLines lines;
    LineKindStyle style;  ///< without lengths
    std::optional<LineLength> width{}, dash{}, gap{};
  };
  void read(std::string_view item);
  void select(std::string_view word);

  Takes takes_;
  std::string text_;
  std::optional<LineSelection> selection_;
  std::vector<Style> styles_;
  bool draws_hidden_ = false;
};

}  // namespace displayfile
