#include "clip/system/loaded_library.h"

#include <filesystem>
#include <system_error>

#include "clip/system/windows/windows.h"

namespace displayfile {

namespace {

std::string message_of_system() {
  return std::system_category().message(static_cast<int>(::GetLastError()));
}

}  // namespace

void* load_library(const char* name, std::string& why) {
  if (name == nullptr) return ::GetModuleHandleW(nullptr);
  const HMODULE library = ::LoadLibraryW(std::filesystem::path(name).c_str());
  if (library == nullptr) why = std::string(name).append(": ").append(message_of_system());
  return library;
}

void* address_in_library(void* library, const char* function, std::string& why) {
  const FARPROC found = ::GetProcAddress(static_cast<HMODULE>(library), function);
  if (found == nullptr) why = std::string(function).append(": ").append(message_of_system());
  return reinterpret_cast<void*>(found);
}

}  // namespace displayfile
