#include "clip/system/loaded_library.h"

#include <dlfcn.h>

namespace displayfile {

void* load_library(const char* name, std::string& why) {
  void* const library = ::dlopen(name, RTLD_LAZY | RTLD_LOCAL);
  if (library == nullptr) why = ::dlerror();
  return library;
}

void* address_in_library(void* library, const char* function, std::string& why) {
  void* const found = ::dlsym(library, function);
  if (found == nullptr) why = ::dlerror();
  return found;
}

}  // namespace displayfile
