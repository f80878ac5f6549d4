#pragma once

#include <string>

namespace displayfile {

/// Loads a shared library by the system's loader; a null pointer stands for the program itself.
/// Null, with the loader's message in `why`, if there is none. It stays loaded.
void* load_library(const char* name, std::string& why);
/// The address of a function of C linkage; null, with the loader's message, if there is none.
void* address_in_library(void* library, const char* function, std::string& why);

}  // namespace displayfile
