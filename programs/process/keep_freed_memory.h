#pragma once

#include <cstddef>

namespace displayfile {

/// Has the C library keep what is freed for what is asked for next, up to arrays of 32 MiB, where
/// it can be told so: otherwise a large array is a piece of memory that the kernel hands out and
/// clears anew. What a step of a picture has freed then serves the next.
void keep_freed_memory();

/// After keep_freed_memory: has so much memory handed out at once, for what is asked for next. That
/// takes a kernel that can less time than to hand it out page by page when it is first written.
/// Does nothing for little, and no more than 256 MiB.
void ask_for_memory(std::size_t bytes);

/// After this about so many bytes are handed out in pages as large as the system has
/// (clip/base/large_pages.h), however small the pieces asked for: to be given thirty thousand small
/// pages takes a third of the time in which a surface of 500 x 500 points is drawn. From then on
/// the program gives no memory back.
void hand_out_large_pages(std::size_t bytes);

}  // namespace displayfile
