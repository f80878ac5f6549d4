#pragma once

namespace displayfile {

/// Has the C library keep what is freed for what is asked for next, up to arrays of 32 MiB, where
/// it can be told so: otherwise a large array is a piece of memory that the kernel hands out and
/// clears anew. What a step of a picture has freed then serves the next.
void keep_freed_memory();

}  // namespace displayfile
