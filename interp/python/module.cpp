#include <pybind11/pybind11.h>

#include "displayfile/text/user_routine.h"
#include "hidden/hidden_method.h"
#include "interp/python/errors.h"
#include "interp/python/interrupts.h"
#include "interp/python/pieces.h"
#include "interp/python/system.h"

namespace py = pybind11;

namespace displayfile::python {

namespace {

py::list names_of_routines() {
  py::list names;
  for (const UserRoutine& routine : user_routines()) names.append(python_name(routine.name));
  return names;
}

py::list names_of_methods() {
  py::list names;
  for (const HiddenMethodEntry& entry : hidden_methods()) {
    if (entry.available) names.append(std::string(entry.name));
  }
  return names;
}

}  // namespace

PYBIND11_MODULE(_displayfile, module) {
  module.doc() = "The C++ part of displayfile.";
  module.attr("__version__") = DISPLAYFILE_VERSION;
  remember_main_thread();
  add_errors(module);
  SystemClass system = add_system(module);
  add_pictures(system);
  add_polygons(module);
  module.def("user_routines", names_of_routines);
  module.def("methods", names_of_methods);
}

}  // namespace displayfile::python
