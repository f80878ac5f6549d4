#pragma once

#include <string>
#include <vector>

#include "clip/geometry/rectangle.h"
#include "clip/point.h"
#include "displayfile/segments/viewed_scene.h"
#include "interp/device/cairo.h"
#include "interp/text/letter_paths.h"

namespace displayfile {

/// A text on a Cairo context, in a font of the system, whose shapes and widths are the same at any
/// size and place. Coordinates are the context's, y down.
class CairoText {
 public:
  /// Sets the context's font. `size` is of the letters. Throws Error if Cairo fails.
  CairoText(cairo_t* context, const std::string& font, const DeviceText& text, const Point2& anchor,
            double size);

  Rectangle ink() const;  ///< what the letters cover
  void show() const;      ///< in the context's source colour; throws Error if Cairo fails
  /// The outlines, letter by letter. Throws Error if Cairo fails.
  std::vector<LetterPaths::Letter> outlines() const;

 private:
  cairo_t* context_;
  const DeviceText& text_;
  Point2 start_;
  Point2 along_{1.0, 0.0};  // the direction in which it runs
  cairo_text_extents_t extents_;
};

}  // namespace displayfile
