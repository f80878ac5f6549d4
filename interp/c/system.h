#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstring>
#include <exception>
#include <new>
#include <optional>
#include <string>
#include <type_traits>

#include "clip/base/collected_text.h"
#include "clip/base/error.h"
#include "clip/base/work_budget.h"
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/segments/sorted_display_file.h"
#include "interp/c/displayfile_c.h"
#include "interp/device/output_device.h"
#include "interp/draw/other_eye.h"
#include "interp/draw/renderer.h"

/// Shared by the C API's functions: the system behind the handle, running a call, and versioned
/// structures.

struct df_system {
  displayfile::GraphicsSystem system;
  bool is_new = true;  // no routine was called
  displayfile::CollectedText recorded;
  std::optional<displayfile::Recorder> recorder;  // if retain was called
  std::optional<displayfile::View> eye;           // view of df_look_from
  std::optional<displayfile::OtherEye> other;     // made when it is needed
  displayfile::Renderer renderer;
  displayfile::SortedDisplayFile sorted;
  displayfile::WorkBudget budget;
  std::atomic_flag is_busy;
  std::string error;

  // Memory returned last.
  std::string bytes;
  displayfile::DrawnPieces pieces;
};

namespace displayfile::c {

/// The system that returned DF_BUSY for this thread's last call on it: its own error belongs to the
/// other thread.
extern constinit thread_local const df_system* was_busy;

/// Runs a call within the budget's limits, while no other thread is in one.
template <class Call>
int carried_out(df_system* system, const WorkLimits& limits, Call&& call) noexcept {
  if (system == nullptr) return DF_ERROR;
  if (system->is_busy.test_and_set(std::memory_order_acquire)) {
    was_busy = system;
    return DF_BUSY;
  }
  if (was_busy == system) was_busy = nullptr;
  int result = DF_ERROR;
  const auto fail = [&](const char* what) noexcept {
    try {
      system->error = what;
    } catch (...) {
      system->error.clear();
    }
  };
  try {
    system->error.clear();
    system->budget.start(limits);
    const BudgetInForce in_force(system->budget);
    call();
    result = DF_OK;
  } catch (const std::bad_alloc&) {
    fail("out of memory");
  } catch (const std::exception& error) {
    fail(error.what());
  } catch (...) {
    fail("unknown error");
  }
  system->is_busy.clear(std::memory_order_release);
  return result;
}
template <class Call>
int carried_out(df_system* system, Call&& call) noexcept {
  return carried_out(system, {}, call);
}

/// Runs a call that changes the system.
template <class Call>
int told(df_system* system, Call&& call) noexcept {
  return carried_out(system, [&] {
    system->other.reset();
    call();
    system->is_new = false;
  });
}

template <class Pointer>
void require_given(const Pointer* pointer, const char* what) {
  if (pointer == nullptr) throw Error(fmt::format("{}: expected it, not null", what));
}

/// A file's path. The library does not use standard input and output.
inline const char* path_given(const char* path) {
  require_given(path, "the path");
  if (std::strcmp(path, "-") != 0) return path;
  throw Error(
      "the path: -: expected a file's name, such as ./-; standard input and output are the "
      "command's");
}

/// A structure's stated size. In every version it is a multiple of the alignment: no member is cut
/// in two.
template <class Structure>
std::size_t size_said(const Structure* given, const char* name) {
  std::size_t size = 0;
  std::memcpy(&size, given, sizeof size);
  if (size >= sizeof size && size % alignof(Structure) == 0) return size;
  throw Error(fmt::format("{}: size {}: expected sizeof({})", name, size, name));
}

/// The structure in this version's form: members missing in an earlier version are 0, and those of
/// a later one must be 0.
template <class Structure>
Structure known(const Structure* given, const char* name) {
  static_assert(std::is_trivially_copyable_v<Structure>);
  Structure result{};
  if (given == nullptr) return result;
  const std::size_t size = size_said(given, name);
  const auto* const bytes = reinterpret_cast<const unsigned char*>(given);
  const std::size_t both = std::min(size, sizeof result);
  if (std::any_of(bytes + both, bytes + size, [](unsigned char byte) { return byte != 0; })) {
    throw Error(fmt::format("{}: size {}: larger than version {} of the library supports", name,
                            size, df_version()));
  }
  std::memcpy(static_cast<void*>(&result), bytes, both);
  return result;
}

/// Copies as much of a structure as the caller's size allows.
template <class Structure>
void hand_out(Structure result, Structure* to, const char* name) {
  require_given(to, name);
  const std::size_t size = size_said(to, name);
  result.size = size;
  std::memcpy(static_cast<void*>(to), &result, std::min(size, sizeof result));
}

inline void hand_out_text(const std::string& from, const char** text, std::size_t* length) {
  *text = from.c_str();
  *length = from.size();
}

/// A system's retained scene. Throws Error if there is none.
const RetainedScene& retained(const df_system& system);
/// The system in the view of df_look_from.
const GraphicsSystem& looked_at(df_system& system);
/// The other eye in force; null: the application's view.
OtherEye* eye_in_force(df_system& system);

}  // namespace displayfile::c
