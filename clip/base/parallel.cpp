#include "clip/base/parallel.h"

#include <algorithm>

#include "clip/base/budgeted_work.h"
#include "clip/base/work_budget.h"

namespace displayfile {

int useful_threads(int threads) {
  if (threads <= 1) return 1;  // without calling the thread library
  return std::clamp(threads, 1, std::max(1, most_threads()));
}

namespace {

void share_out_if_useful(int threads, std::size_t count,
                         const std::function<void(std::size_t)>& work) {
  threads = useful_threads(threads);
  if (threads > 1 && count > 1) return share_out(threads, count, work);
  for (std::size_t k = 0; k < count; ++k) work(k);
}

}  // namespace

/// Helping threads work under this thread's budget, which is checked before each call, and round to
/// nearest: each thread has its own rounding mode.
void in_parallel(int threads, std::size_t count, const std::function<void(std::size_t)>& work) {
  const WorkInForce ours = work_in_force();
  share_out_if_useful(threads, count, [&](std::size_t k) {
    const BudgetInForce in_force(ours);
    if (ours.budget != nullptr) ours.budget->ask();
    work(k);
  });
}

}  // namespace displayfile
