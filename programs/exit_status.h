#pragma once

#include <exception>
#include <iostream>
#include <new>

namespace displayfile {

/// What main returns: what `run` does, or, if it throws, 2 after one line on standard error.
inline int exit_status(int (*run)(int, char**), int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::cerr << "displayfile: out of memory\n";
  } catch (const std::exception& e) {
    std::cerr << "displayfile: " << e.what() << '\n';
  }
  return 2;
}

}  // namespace displayfile
