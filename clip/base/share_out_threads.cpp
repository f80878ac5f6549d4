#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

#include "clip/base/parallel.h"

namespace displayfile {

namespace {

/// True while this thread does a share of work: its nested calls then run on it alone.
thread_local bool shares = false;

/// Calls shared by several threads; each thread takes the next remaining one.
class SharedWork {
 public:
  SharedWork(std::size_t count, const std::function<void(std::size_t)>& work)
      : count_(count), work_(work) {}

  /// Makes calls until none is left or one has failed.
  void do_share() {
    shares = true;
    try {
      for (std::size_t k = next_++; k < count_; k = next_++) work_(k);
    } catch (...) {
      next_ = count_;
      const std::lock_guard lock(guard_);
      if (!failure_) failure_ = std::current_exception();
    }
    shares = false;
  }

  void throw_failure() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::size_t count_;
  const std::function<void(std::size_t)>& work_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex guard_;
  std::exception_ptr failure_;  // the first exception thrown
};

}  // namespace

int most_threads() {
  return shares ? 1 : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void share_out(int threads, std::size_t count, const std::function<void(std::size_t)>& work) {
  SharedWork shared(count, work);
  const std::size_t helpers = std::min(static_cast<std::size_t>(threads), count) - 1;
  try {
    std::vector<std::jthread> threads_of_helpers;
    threads_of_helpers.reserve(helpers);
    while (threads_of_helpers.size() < helpers) {
      threads_of_helpers.emplace_back([&] { shared.do_share(); });
    }
    shared.do_share();
  } catch (const std::system_error&) {
    throw std::bad_alloc();  // no memory for a thread
  }
  shared.throw_failure();
}

}  // namespace displayfile
