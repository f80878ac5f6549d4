#pragma once

#include <cstdlib>

namespace displayfile::test {

/// A number from the environment by which a test is made longer by hand, and its default.
inline int from_environment(const char* name, int usual) {
  const char* const set = std::getenv(name);
  return set == nullptr ? usual : std::atoi(set);
}

}  // namespace displayfile::test
