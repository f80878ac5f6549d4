#pragma once

#include <pybind11/pybind11.h>

#include "interp/device/output_device.h"

namespace displayfile::python {

/// The members of Pieces, in order, as arrays.
pybind11::tuple arrays_of(DrawnPieces&& pieces);

/// Adds sort, visible_pieces and visible_lines.
void add_polygons(pybind11::module_& module);

}  // namespace displayfile::python
