#include "programs/keep_freed_memory.h"

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace displayfile {

void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int kLargest = 32 * 1024 * 1024;  // the most that it takes
  mallopt(M_MMAP_THRESHOLD, kLargest);
  mallopt(M_TRIM_THRESHOLD, 8 * kLargest);
  mallopt(M_TOP_PAD, kLargest / 2);
#endif
}

}  // namespace displayfile
