#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "interp/draw/draw.h"
#include "interp/python/system.h"

namespace displayfile::python {

/// How a picture is drawn: its size as a number of pixels, or two, and by their names in Python
/// what else DrawOptions has. None stands for an argument that is not given.
DrawOptions draw_options_in(pybind11::handle size, const pybind11::kwargs& keywords);

/// The picture's pixels, and its ids and depth or None, as arrays over its own memory. That of the
/// pixels is for the next picture when their array is gone.
pybind11::tuple arrays_of(Picture&& picture, const DrawOptions& options,
                          std::shared_ptr<SparePictures> spare);

}  // namespace displayfile::python
