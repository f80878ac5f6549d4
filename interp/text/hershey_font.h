#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "clip/point.h"

namespace displayfile {

/// A Hershey font: letters as strokes for pens (A. V. Hershey, "Calligraphy for computers", U. S.
/// Naval Weapons Laboratory, 1967), read from a file in James Hurt's format, one of Debian's
/// package hershey-fonts-data. It has the characters of ASCII, or others in their places; minus
/// signs, dashes, quotation marks and blanks of other kinds are drawn as those of ASCII; the signs
/// of diameters and degrees, and plus-minus, are made of its strokes.
class HersheyFont {
 public:
  /// The font used by the name `hershey` alone.
  static constexpr std::string_view kUsual = "futural";
  /// Letters are as high as in other fonts: capitals, 21 units, are this part of the size.
  static constexpr double kCapitalsOfSize = 0.72;

  /// Reads a font by its name, such as futural. Throws Error for an unknown name, listing the known
  /// ones; without the package, naming it; and for a damaged file.
  explicit HersheyFont(const std::string& name);

  const std::string& name() const { return name_; }
  /// The width of a text, as a part of the size.
  double width(std::string_view text) const;
  /// The strokes of a text whose base line begins at `start`; y down. `across` is the size of the
  /// letters in x, `down` in y. Each stroke has two points or more. Characters that the font lacks
  /// are left out.
  std::vector<std::vector<Point2>> strokes(std::string_view text, const Point2& start,
                                           double across, double down) const;
  /// Adds the characters of a text that the font lacks.
  void add_lacking(std::string_view text, std::set<std::string>& lacking) const;

 private:
  struct Glyph {
    int left = 0, right = 0;
    std::vector<std::vector<Point2>> strokes;  // y down, from the base line
  };
  void read(std::string_view text, const std::string& path);
  void add_signs();
  const Glyph* glyph(std::string_view character) const;

  std::string name_;
  std::vector<Glyph> glyphs_;  // from the blank on
  std::vector<std::pair<std::string_view, Glyph>> signs_;
};

/// The font of that name, read once in a process. Throws Error as the constructor.
const HersheyFont& hershey_font(const std::string& name);

}  // namespace displayfile
