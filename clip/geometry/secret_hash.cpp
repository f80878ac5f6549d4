#include "clip/geometry/secret_hash.h"

#include <chrono>

namespace displayfile {

namespace {

/// The finisher of splitmix64 (Steele, Lea and Flood 2014): each bit changes about half of all.
std::uint64_t scrambled(std::uint64_t h) {
  h = (h ^ (h >> 30)) * 0xBF58476D1CE4E5B9u;
  h = (h ^ (h >> 27)) * 0x94D049BB133111EBu;
  return h ^ (h >> 31);
}

/// A seed from the time of the first call, in nanoseconds, and from the addresses of the stack and
/// of static data.
std::uint64_t drawn() {
  static const char here = 0;
  const char there = 0;
  const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
  std::uint64_t h = scrambled(static_cast<std::uint64_t>(now));
  for (const char* const place : {&here, &there}) {
    h = scrambled(h ^ reinterpret_cast<std::uintptr_t>(place));
  }
  return h;
}

bool is_known = false;

std::uint64_t secret() {
  static const std::uint64_t of_process = is_known ? 1 : drawn();
  return of_process;
}

}  // namespace

void SecretHash::use_known_numbers() noexcept { is_known = true; }

SecretHash::SecretHash() noexcept : secret_(secret()), odd_(scrambled(secret_ + 1) | 1u) {}

}  // namespace displayfile
