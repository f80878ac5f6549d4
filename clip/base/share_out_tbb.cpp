#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <new>
#include <stdexcept>
#include <string_view>

#include "clip/base/parallel.h"

// ThreadSanitizer does not see into the library, so the library's guarantee is declared here: each
// call comes after all earlier work, and before all later work. This file is compiled without
// ThreadSanitizer.
#if defined(DISPLAYFILE_SANITIZE_THREADS)
#include <sanitizer/tsan_interface.h>
#endif

namespace displayfile {

namespace {

/// One end of the guarantee: writes before happens_before(at) are visible after happens_after(at).
void happens_before([[maybe_unused]] void* at) {
#if defined(DISPLAYFILE_SANITIZE_THREADS)
  __tsan_release(at);
#endif
}

void happens_after([[maybe_unused]] void* at) {
#if defined(DISPLAYFILE_SANITIZE_THREADS)
  __tsan_acquire(at);
#endif
}

}  // namespace

int most_threads() { return tbb::this_task_arena::max_concurrency(); }

void share_out(int threads, std::size_t count, const std::function<void(std::size_t)>& work) {
  char begun, ended;
  happens_before(&begun);
  try {
    tbb::task_arena(threads).execute([&] {
      tbb::parallel_for(std::size_t{0}, count, [&](std::size_t k) {
        happens_after(&begun);
        work(k);
        happens_before(&ended);
      });
    });
  } catch (const std::runtime_error& failure) {
    // The library's message when there is no memory for a thread.
    if (std::string_view(failure.what()).starts_with("pthread_create")) throw std::bad_alloc();
    throw;
  }
  happens_after(&ended);
}

}  // namespace displayfile
