#pragma once

// A sanitized test is slower: it makes do with fewer and smaller scenes.

#include <cstdint>

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define DISPLAYFILE_TESTS_ARE_SANITIZED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define DISPLAYFILE_TESTS_ARE_SANITIZED
#endif

namespace displayfile::test {

#if defined(DISPLAYFILE_TESTS_ARE_SANITIZED)
inline constexpr int kSlower = 10;
#else
inline constexpr int kSlower = 1;
#endif

/// Tests of many scenes by many methods take all combinations; sanitized ones take one of `kShare`:
/// nearly all code that a combination runs is the method's or the scene's, and runs in others too.
inline constexpr int kShare = kSlower > 1 ? 3 : 1;

/// Which combinations a test takes: always the same, and spread over scenes and methods.
class Share {
 public:
  bool takes_next() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return (state_ >> 33) % kShare == 0;
  }

 private:
  std::uint64_t state_ = 1;
};

}  // namespace displayfile::test
