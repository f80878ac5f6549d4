#pragma once

#include <cstddef>

// The protocol between this process and an import program (programs/import_program). Both are of
// one build: numbers are sent as in memory.

namespace displayfile {

/// The program's first argument; programs of another build are refused, and refuse.
inline constexpr const char* kImportProtocol =
    sizeof(void*) == 8 ? "displayfile-import-2-64" : "displayfile-import-2-32";

/// The program's arguments: the protocol, the waiting process, bytes, seconds, 1 for normals, the
/// deflection, the path.
inline constexpr int kImportArguments = 7;

/// The descriptor for the program's reply.
inline constexpr int kReplyDescriptor = 3;

// Exit statuses without a reply.
inline constexpr int kOutOfMemoryStatus = 3;
inline constexpr int kOtherProtocolStatus = 4;

/// Maximum length of a message in bytes.
inline constexpr std::size_t kMostOfMessage = std::size_t{1} << 16;

// A sanitizer's shadow memory exceeds any limit of the address space: sanitized processes are
// limited by their resident memory instead.
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
