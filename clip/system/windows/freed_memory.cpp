#include "clip/system/freed_memory.h"

namespace displayfile {

// This C library has no such settings.

void keep_freed_memory() {}

void ask_for_memory(std::size_t /*bytes*/) {}

void hand_out_large_pages(std::size_t /*bytes*/) {}

}  // namespace displayfile
