#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <optional>
#include <string_view>

#include "displayfile/graphics_system.h"

namespace displayfile::python {

/// The parts of a line style that an argument sets.
struct OwnLineStyle {
  std::optional<Colour> colour;
  std::optional<double> width;  // in pixels
};
/// From red, green and blue, and a number; either may be None. Errors name `what`.
OwnLineStyle own_line_style_in(pybind11::handle colour, pybind11::handle width,
                               std::string_view what);

/// Calls enter(), which enters lines, in the line style that the application set, or else in black,
/// with these parts of it replaced. A line style that draws none counts as not set: it is that of
/// polygons' sides. The style in force stays.
void with_line_style(GraphicsSystem& system, const OwnLineStyle& own,
                     const std::function<void()>& enter);

}  // namespace displayfile::python
