#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace displayfile {

/// The places to look for a file of this build that a program starts or loads when it needs it, in
/// order: beside this program, where an installation has it, beside the shared library that has
/// this code, where it was built, and where it was to be installed. `named`, if not null, is the
/// only place: the user has set it.
std::vector<std::filesystem::path> places_of_companion(const char* name, const char* named);

/// A module: a library of this build that is loaded when it is first needed, because it is under
/// another licence than the rest or because few need it. Its file is `name`.so.VERSION. It has one
/// function of C linkage, without arguments, `displayfile_module`, which returns a pointer to its
/// Interface; the first member of that is `const char* version`, DISPLAYFILE_MODULE_VERSION of its
/// build.
///
/// Returns that pointer. `purpose` begins the message. Throws Error if the module is not found in
/// any place (places_of_companion; the environment's DISPLAYFILE_MODULES names its folder), cannot
/// be loaded, or is of another version.
const void* load_module(std::string_view name, std::string_view purpose);

template <class Interface>
const Interface& module_interface(std::string_view name, std::string_view purpose) {
  return *static_cast<const Interface*>(load_module(name, purpose));
}

}  // namespace displayfile
