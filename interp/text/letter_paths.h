#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "clip/geometry/rectangle.h"
#include "clip/point.h"
#include "displayfile/segments/viewed_scene.h"
#include "interp/device/picture.h"

namespace displayfile {

/// The letters of a text as paths on a page, y down.
struct LetterPaths {
  /// Strokes, to be drawn in `stroke`; or outlines, each closed, and filled even-odd a letter at a
  /// time.
  bool are_outlines = false;
  LineStyle stroke;  ///< solid, in the text's colour and the width of its line style
  using Letter = std::vector<std::vector<Point2>>;
  std::vector<Letter> letters;  ///< strokes: all as one

  Rectangle around() const;  ///< the box of all points
};

/// The paths of a text, rotated as set, with size and anchor in the page's unit. None if the
/// lettering uses a font. Throws Error as require_lettering.
std::optional<LetterPaths> letter_paths(const Lettering& lettering, const DeviceText& text,
                                        const Point2& anchor, double size);

/// The lettering by which pens draw the texts of annotation: this one if it is of paths, otherwise
/// the usual Hershey font.
Lettering lettering_of_pens(const Lettering& lettering);

class HersheyFont;
/// The font of a lettering of strokes (interp/text/hershey_font.h). Throws Error as its
/// constructor.
const HersheyFont& hershey_font_of(const Lettering& lettering);

/// The outlines of a text in a font of the system, to a hundredth of the page's unit. Throws Error
/// without Cairo.
std::vector<LetterPaths::Letter> letter_outlines(const std::string& font, const DeviceText& text,
                                                 const Point2& anchor, double size);

/// The fraction of a text's width that stands left of its anchor.
double part_before_anchor(TextStyle::Alignment alignment);

/// The font that Fontconfig substitutes for a family; empty if the family is available, or if that
/// is unknown.
std::string font_in_place_of(const std::string& family);

/// Sentences about texts of visible segments that a lettering does not draw as set: characters that
/// a Hershey font lacks, and a font that the system does not have. By pens annotation has the
/// lettering of lettering_of_pens.
std::vector<std::string> lettering_warnings(const Lettering& lettering,
                                            const DisplayFile& display_file, bool by_pens);

}  // namespace displayfile
