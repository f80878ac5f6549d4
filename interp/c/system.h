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

/// What the C API's functions have in common: the system behind the handle, how a call is carried
/// out, and structures that say their own size.

struct df_system {
  displayfile::GraphicsSystem system;
  bool is_new = true;  // no routine was called
  displayfile::CollectedText recorded;
  std::optional<displayfile::Recorder> recorder;  // if it retains
  std::optional<displayfile::View> eye;           // that is looked from
  std::optional<displayfile::OtherEye> other;     // made when it is needed
  displayfile::Renderer renderer;
  displayfile::SortedDisplayFile sorted;
  displayfile::WorkBudget budget;
  std::atomic_flag is_busy;
  std::string error;

  // What was handed out last.
  std::string bytes;
  displayfile::DrawnPieces pieces;
};

namespace displayfile::c {

/// The system that refused this thread's last call on it by DF_BUSY: its error is the other
/// thread's meanwhile.
extern constinit thread_local const df_system* was_busy;

/// Carries a call out, by the budget's limits, while no other thread is in one.
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

/// Carries a call out that tells the system something.
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

/// A file's path. Standard input and output are not the library's to read or write.
inline const char* path_given(const char* path) {
  require_given(path, "the path");
  if (std::strcmp(path, "-") != 0) return path;
  throw Error(
      "the path: -: expected a file's name, such as ./-; standard input and output are the "
      "command's");
}

/// The size that a structure says. That of any version is a multiple of its alignment: no member is
/// cut in two.
template <class Structure>
std::size_t size_said(const Structure* given, const char* name) {
  std::size_t size = 0;
  std::memcpy(&size, given, sizeof size);
  if (size >= sizeof size && size % alignof(Structure) == 0) return size;
  throw Error(fmt::format("{}: size {}: expected sizeof({})", name, size, name));
}

/// The structure as this version knows it: members that an earlier caller does not know are 0, and
/// those that a later one knows must be.
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

/// Hands out as much of a structure as the caller has room for.
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

/// The scene that a system retains. Throws Error if it does not.
const RetainedScene& retained(const df_system& system);
/// The system as it is looked at.
const GraphicsSystem& looked_at(df_system& system);
/// What it is looked at with, if that is another eye; null: as the application set the view.
OtherEye* eye_in_force(df_system& system);

}  // namespace displayfile::c
