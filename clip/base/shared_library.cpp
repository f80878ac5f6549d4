#include "clip/base/shared_library.h"

#include <string>

#include "clip/base/error.h"
#include "clip/system/own_files.h"

namespace displayfile {

SharedLibrary::SharedLibrary(const char* name) {
  std::string why;
  handle_ = load_library(name, why);
  if (handle_ == nullptr) throw Error(why);
}

void* SharedLibrary::address(const char* name) const {
  std::string why;
  void* const found = address_in_library(handle_, name, why);
  if (found == nullptr) throw Error(why);
  return found;
}

}  // namespace displayfile
