#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

namespace displayfile {

inline constexpr std::uint64_t kNoMemoryLimit = std::numeric_limits<std::uint64_t>::max();

// Bytes, as the system reports them.

/// Free memory, or memory that can be freed without writing to a disk; the maximum if unknown.
std::size_t memory_free_for_all();
/// This process's data; 0 if unknown.
std::size_t data_of_process();
/// The machine's, or that of the groups of processes that this one is in; 0 if unknown.
std::size_t memory_of_groups();
/// The limit of this process's data; kNoMemoryLimit if there is none.
std::uint64_t limit_of_data();
/// The same, or the limit of its addresses if that is lower.
std::uint64_t limit_of_process();
/// Lowers the limit of this process's data, where the system has one; a lower one stays.
void set_limit_of_data(std::uint64_t bytes);
/// True if `bytes` bytes in new pages can be allocated now. They are released again.
bool can_have_pages(std::size_t bytes);

inline constexpr std::size_t kLeastInLargePages = std::size_t{16} << 20;
/// Advises the system, where supported, to back untouched memory with large pages; not worth it
/// below kLeastInLargePages.
void ask_for_large_pages(void* begin, std::size_t bytes);

/// Makes the C library keep freed memory for later allocations, up to arrays of 32 MiB, where
/// supported: otherwise the kernel maps and clears each large array anew. Memory freed by one step
/// of a picture is then reused by the next.
void keep_freed_memory();

/// After keep_freed_memory: allocates this much memory at once for later use, where the kernel does
/// that faster than page by page on first write. No effect for small amounts; at most 256 MiB.
void ask_for_memory(std::size_t bytes);

/// From now on about this many bytes are allocated in the system's largest pages
/// (clip/system/process_memory.h), however small the allocations: mapping thirty thousand small
/// pages takes a third of the time of drawing a surface of 500 x 500 points. The program then
/// returns no memory.
void hand_out_large_pages(std::size_t bytes);

}  // namespace displayfile
