#pragma once

namespace displayfile {

/// A library that is loaded on first use and stays loaded, so that pictures without it need no time
/// or memory for it.
class SharedLibrary {
 public:
  /// Loads the library by the system's loader; a null pointer stands for the program itself. Throws
  /// Error, with the loader's message, if there is none.
  explicit SharedLibrary(const char* name);

  /// A function of C linkage. Throws Error if the library has none of that name.
  template <class Function>
  Function function(const char* name) const {
    return reinterpret_cast<Function>(address(name));
  }

 private:
  void* address(const char* name) const;

  void* handle_ = nullptr;
};

/// Declares a member for a library's function, with its type and its name without the prefix that
/// all functions of the library have.
#define DISPLAYFILE_LIBRARY_FUNCTION(library, prefix, name) \
  decltype(&::prefix##name) name = library.function<decltype(&::prefix##name)>(#prefix #name)

}  // namespace displayfile
