#pragma once

#include <exception>
#include <iostream>
#include <new>

#include "clip/memory.h"

namespace displayfile {

/// What main returns: what `run` does, or, if it throws, 2 after one line on standard error.
inline int exit_status(int (*run)(int, char**), int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::cerr << "displayfile: " << out_of_memory_message() << '\n';
  } catch (const std::exception& e) {
    std::cerr << "displayfile: " << e.what() << '\n';
  }
  return 2;
}

}  // namespace displayfile
