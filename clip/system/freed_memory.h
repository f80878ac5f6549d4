#pragma once

#include <cstddef>

namespace displayfile {

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
