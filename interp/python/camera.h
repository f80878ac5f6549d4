#pragma once

#include <pybind11/pybind11.h>

#include "displayfile/mesh/mesh.h"

namespace displayfile::python {

/// How an imported mesh is looked at, from the names and values of what is said: eye, look_at, up,
/// fov, parallel, fit and turning. None stands for what is not said. Throws Error for another
/// value.
Camera camera_in(const pybind11::kwargs& said);

}  // namespace displayfile::python
