#pragma once

#include <cstddef>

// What this process and the import program (programs/import_program) say to each other. Both are of
// one build: numbers go as they stand in memory.

namespace displayfile {

/// The program's first argument: a program of another build is refused, and refuses.
inline constexpr const char* kImportProtocol =
    sizeof(void*) == 8 ? "displayfile-import-1-64" : "displayfile-import-1-32";

/// Its arguments: the protocol, the process that waits for it, bytes, seconds, 1 for normals, the
/// path.
inline constexpr int kImportArguments = 6;

/// The descriptor on which it answers.
inline constexpr int kReplyDescriptor = 3;

// How it ends where it does not answer.
inline constexpr int kOutOfMemoryStatus = 3;
inline constexpr int kOtherProtocolStatus = 4;

/// Bytes of a message at most.
inline constexpr std::size_t kMostOfMessage = std::size_t{1} << 16;

// A sanitizer's shadow of the memory is larger than any limit of the address space: sanitized
// processes are watched instead, by what of them is resident.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kWatchesResidentMemory = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || \
    __has_feature(memory_sanitizer)
inline constexpr bool kWatchesResidentMemory = true;
#else
inline constexpr bool kWatchesResidentMemory = false;
#endif
#else
inline constexpr bool kWatchesResidentMemory = false;
#endif

}  // namespace displayfile
