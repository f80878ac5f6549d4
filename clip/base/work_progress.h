#pragma once

#include <cassert>
#include <cstddef>
#include <mutex>

#include "clip/base/work_budget.h"

namespace displayfile {

/// Counts the progress of several threads in one operation and reports it.
class CountedWork {
 public:
  /// `told` must outlive this; if it is empty, nothing is counted.
  CountedWork(const WorkProgress& told, std::size_t all) : told_(told), all_(all) {}

  /// Adds to the work done. Any thread may call it.
  void add(std::size_t more) {
    if (!told_) return;
    const std::lock_guard lock(mutex_);
    done_ += more;
    assert(done_ <= all_);
    if (stopped_) return;  // by another thread, while this one was at work
    stopped_ = true;
    told_(done_, all_);
    stopped_ = false;
  }

 private:
  const WorkProgress& told_;
  const std::size_t all_;
  std::mutex mutex_;
  std::size_t done_ = 0;
  bool stopped_ = false;
};

}  // namespace displayfile
