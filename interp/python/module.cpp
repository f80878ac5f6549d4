#include <pybind11/pybind11.h>

#include "clip/surfaces.h"
#include "displayfile/files.h"
#include "interp/python/errors.h"
#include "interp/python/limits.h"
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

/// The name, arguments, meaning and section of each routine, in Python's form.
py::list table_of_routines() {
  py::list table;
  for (const UserRoutine& routine : user_routines()) {
    table.append(py::make_tuple(python_name(routine.name), std::string(routine.expected),
                                in_python(routine.meaning), std::string(routine.section)));
  }
  return table;
}

py::list names_of_methods() {
  py::list names;
  for (const HiddenMethodEntry& entry : hidden_methods()) {
    names.append(std::string(entry.name));
  }
  return names;
}

}  // namespace

PYBIND11_MODULE(_displayfile, module) {
  module.doc() = "The C++ part of displayfile.";
  module.attr("__version__") = DISPLAYFILE_VERSION;
  // Docstrings begin with "name(arguments)\n--\n\n", from which Python knows the arguments, and not
  // with types of C++.
  py::options options;
  options.disable_function_signatures();
  add_errors(module);
  SystemClass system = add_system(module);
  add_pictures(system);
  add_turntable(module, system);
  add_views(module, system);
  add_surfaces(system);
  add_lines(system);
  add_beside(system);
  add_scalars(module);
  add_polygons(module);
  add_limits(module);
  module.def("user_routines", names_of_routines,
             "user_routines()\n--\n\nReturns the names of all user routines, which are methods of "
             "System.");
  module.def("methods", names_of_methods,
             "methods()\n--\n\nReturns the names of the hidden-surface and hidden-line methods, "
             "for set_hidden_method and the option hidden.");
  module.def("_table_of_routines", table_of_routines);
}

}  // namespace displayfile::python
