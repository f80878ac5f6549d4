#include "clip/base/shared_library.h"

#include <dlfcn.h>

#include "clip/base/error.h"

namespace displayfile {

SharedLibrary::SharedLibrary(const char* name) : handle_(dlopen(name, RTLD_LAZY | RTLD_LOCAL)) {
  if (handle_ == nullptr) throw Error(dlerror());
}

void* SharedLibrary::address(const char* name) const {
  void* const found = dlsym(handle_, name);
  if (found == nullptr) throw Error(dlerror());
  return found;
}

}  // namespace displayfile
