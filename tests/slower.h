#pragma once

// A sanitized test is slower: it makes do with fewer and smaller scenes.

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

}  // namespace displayfile::test
