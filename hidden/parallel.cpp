#include "hidden/parallel.h"

#include <algorithm>

#include "clip/work_budget.h"
#include "hidden/share_out.h"

namespace displayfile {

int useful_threads(int threads) {
  if (threads <= 1) return 1;  // the thread library is not asked
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

/// Whoever helps this thread has its budget, which is asked before each call.
void in_parallel(int threads, std::size_t count, const std::function<void(std::size_t)>& work) {
  const WorkInForce ours = work_in_force();
  if (ours.budget == nullptr) return share_out_if_useful(threads, count, work);
  share_out_if_useful(threads, count, [&](std::size_t k) {
    const BudgetInForce in_force(ours);
    ours.budget->ask();
    work(k);
  });
}

}  // namespace displayfile
