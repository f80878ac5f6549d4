#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace displayfile::fuzz {

/// An invariant does not hold: prints what, and ends the target, which keeps the input.
[[noreturn]] inline void failed(const std::string& what) {
  std::fprintf(stderr, "%s\n", what.c_str());
  std::abort();
}

}  // namespace displayfile::fuzz
