#pragma once

namespace displayfile {

/// A library that is loaded when it is first asked for, and stays: one that most pictures do
/// without costs them no time to start and no memory.
class SharedLibrary {
 public:
  /// Loads the library as the system's loader finds it; a null pointer is what the program is
  /// linked with. Throws Error, in the loader's words, if there is none.
  explicit SharedLibrary(const char* name);

  /// A function of C linkage. Throws Error if the library has none of that name.
  template <class Function>
  Function function(const char* name) const {
    return reinterpret_cast<Function>(address(name));
  }

 private:
  void* address(const char* name) const;

  void* handle_;
};

/// Declares a member that is a library's function, of its type: named without the prefix that all
/// functions of the library have.
#define DISPLAYFILE_LIBRARY_FUNCTION(library, prefix, name) \
  decltype(&::prefix##name) name = library.function<decltype(&::prefix##name)>(#prefix #name)

}  // namespace displayfile
