#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>

#include "interp/draw/draw.h"
#include "interp/python/system.h"

namespace displayfile::python {

/// The options of a picture: its size as one or two numbers of pixels or a word in mm, and the
/// other members of DrawOptions by their Python names. None stands for a missing argument.
DrawOptions draw_options_in(pybind11::handle size, const pybind11::kwargs& keywords);

/// Width over height of such a picture; none if its size is not valid.
std::optional<double> aspect_of(const DrawOptions& options);

/// The picture's pixels, and its ids and depth or None, as arrays over its own memory. The pixels'
/// memory is reused for the next picture when their array is destroyed.
pybind11::tuple arrays_of(Picture&& picture, const DrawOptions& options,
                          std::shared_ptr<SparePictures> spare);

}  // namespace displayfile::python
