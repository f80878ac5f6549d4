#include <array>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include "clip/system/own_files.h"
#include "clip/system/windows/windows.h"

namespace displayfile {

namespace {

/// A null module is the program itself. Empty if the name is longer than Windows allows.
std::filesystem::path file_of(HMODULE module) {
  constexpr DWORD kLongest = 32768;
  static thread_local std::array<wchar_t, kLongest> name;
  const DWORD length = ::GetModuleFileNameW(module, name.data(), kLongest);
  if (length == 0 || length >= kLongest) return {};
  return std::filesystem::path(name.data(), name.data() + length);
}

}  // namespace

std::filesystem::path file_of_program(std::error_code& error) {
  std::filesystem::path file = file_of(nullptr);
  error = file.empty() ? std::make_error_code(std::errc::filename_too_long) : std::error_code();
  return file;
}

std::filesystem::path file_of_this_code() {
  static const char here = 0;
  HMODULE module = nullptr;
  constexpr DWORD kByAddress =
      GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS | GET_MODULE_HANDLE_EX_FLAG_UNCHANGED_REFCOUNT;
  if (::GetModuleHandleExA(kByAddress, &here, &module) == 0) return {};
  return file_of(module);
}

/// On Windows a program can only be started in addition to this one.
void replace_program(const std::filesystem::path& /*program*/, char** /*arguments*/) {
  errno = ENOSYS;
}

unsigned number_of_process() { return ::GetCurrentProcessId(); }

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
