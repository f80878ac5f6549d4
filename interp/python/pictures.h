#pragma once

#include <pybind11/pybind11.h>

#include "interp/draw.h"

namespace displayfile::python {

/// How a picture is drawn: its size as a number of pixels, or two, and by their names in Python
/// what else DrawOptions has. None stands for what is not said.
DrawOptions draw_options_in(pybind11::handle size, const pybind11::kwargs& said);

}  // namespace displayfile::python
