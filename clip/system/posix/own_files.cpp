#include "clip/system/own_files.h"

#include <dlfcn.h>
#include <unistd.h>
#ifdef __APPLE__
#include <mach-o/dyld.h>

#include <array>
#endif

namespace displayfile {

std::filesystem::path file_of_program(std::error_code& error) {
#ifdef __APPLE__
  std::array<char, 4096> name{};
  std::uint32_t size = name.size();
  if (::_NSGetExecutablePath(name.data(), &size) == 0) {
    return std::filesystem::canonical(name.data(), error);
  }
#endif
  return std::filesystem::read_symlink("/proc/self/exe", error);
}

void replace_program(const std::filesystem::path& program, char** arguments) {
  ::execv(program.c_str(), arguments);
}

unsigned number_of_process() { return static_cast<unsigned>(::getpid()); }

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
