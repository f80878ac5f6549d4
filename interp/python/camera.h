#pragma once

#include <pybind11/pybind11.h>

#include "displayfile/mesh/mesh.h"

namespace displayfile::python {

/// How an imported mesh is looked at, from keyword arguments: eye, look_at, up,
/// fov, parallel, fit and turning. None stands for an argument that is not given. Throws Error for
/// another value.
Camera camera_in(const pybind11::kwargs& keywords);

}  // namespace displayfile::python
