#include "clip/base/unfinished_path.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <utility>

#include "clip/system/descriptors.h"

namespace displayfile {

namespace {

/// Paths in the table are owned by it, and by the handler alone while the handler has them. The
/// handler frees nothing, since the process ends.
constexpr std::size_t kPlaces = 4096;
std::array<std::atomic<char*>, kPlaces> unfinished{};
static_assert(std::atomic<char*>::is_always_lock_free, "a signal handler reads the table");

std::atomic<int> naming{0};  // threads with a Naming object
std::atomic<bool> ending{false};
thread_local int names_of_thread = 0;  // this thread's Naming objects
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

}  // namespace

UnfinishedPath::UnfinishedPath(std::string path) {
  auto* const text = new char[path.size() + 1];
  std::copy_n(path.c_str(), path.size() + 1, text);
  for (std::size_t i = 0; i < kPlaces; ++i) {
    char* none = nullptr;
    if (unfinished[i].load() != nullptr || !unfinished[i].compare_exchange_strong(none, text)) {
      continue;
    }
    place_ = i + 1;
    return;
  }
  delete[] text;
}

UnfinishedPath::~UnfinishedPath() {
  if (place_ != 0) delete[] unfinished[place_ - 1].exchange(nullptr);
}

UnfinishedPath::UnfinishedPath(UnfinishedPath&& other) noexcept
    : place_(std::exchange(other.place_, 0)) {}

UnfinishedPath& UnfinishedPath::operator=(UnfinishedPath&& other) noexcept {
  std::swap(place_, other.place_);
  return *this;
}

/// A folder can only be removed once it is empty, so removal is repeated as long as anything was
/// removed. Windows removes an open file any number of times, so each path is removed once.
void UnfinishedPath::remove_all() noexcept {
  std::array<bool, kPlaces> went{};
  for (bool any_went = true; any_went;) {
    any_went = false;
    for (std::size_t i = 0; i < kPlaces; ++i) {
      char* const path = went[i] ? nullptr : unfinished[i].exchange(nullptr);
      if (path == nullptr) continue;
      went[i] = remove_path(path);
      any_went = any_went || went[i];
      char* none = nullptr;
      unfinished[i].compare_exchange_strong(none, path);  // its owner frees it, if time is left
    }
  }
}

// ---- Names while the process is stopped ---------------------------------------------------------

UnfinishedPath::Naming::Naming() {
  if (names_of_thread++ > 0) return;
  naming.fetch_add(1);
  if (!ending.load()) return;
  naming.fetch_sub(1);
  wait_for_the_end();  // another thread is ending the process
}

UnfinishedPath::Naming::~Naming() {
  if (--names_of_thread > 0) return;
  naming.fetch_sub(1);
}

/// The wait is limited: a file system that hangs must not keep the process from ending.
void UnfinishedPath::end_naming() noexcept {
  constexpr int kTurns = 2000;
  ending.store(true);
  for (int turn = 0; turn < kTurns && naming.load() > 0; ++turn) wait_a_millisecond();
}

}  // namespace displayfile
