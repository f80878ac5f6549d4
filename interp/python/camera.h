#pragma once

#include <pybind11/pybind11.h>

#include "displayfile/mesh/mesh.h"

namespace displayfile::python {

/// The camera of an imported mesh, from keyword arguments: eye, look_at, up, fov, parallel, fit and
/// turning. None stands for a missing argument, for which `otherwise` has the value. Throws Error
/// for another value.
Camera camera_in(const pybind11::kwargs& keywords, const Camera& otherwise = {});

}  // namespace displayfile::python
