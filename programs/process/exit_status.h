#pragma once

#include <exception>
#include <iostream>
#include <new>

#include "clip/base/error.h"
#include "clip/base/memory.h"

namespace displayfile {

/// The result of main: that of `run`, or, if it throws or its output could not be written, 2 after
/// one line on standard error.
inline int exit_status(int (*run)(int, char**), int argc, char** argv) {
  try {
    const int status = run(argc, argv);
    if (!std::cout.flush()) throw Error("standard output: not all could be written");
    return status;
  } catch (const std::bad_alloc&) {
    std::cerr << "displayfile: " << out_of_memory_message() << '\n';
  } catch (const std::exception& e) {
    std::cerr << "displayfile: " << e.what() << '\n';
  }
  return 2;
}

}  // namespace displayfile
