#include "clip/base/parallel.h"

namespace displayfile {

// For systems without threads, such as a browser whose page requests none.

int most_threads() { return 1; }

void share_out(int /*threads*/, std::size_t count, const std::function<void(std::size_t)>& work) {
  for (std::size_t k = 0; k < count; ++k) work(k);
}

}  // namespace displayfile
