#pragma once

#include <cstddef>
#include <string>

#include "clip/base/work_progress.h"

namespace displayfile {

/// Shows the current long work on standard error, if that is a terminal and no other work is shown.
/// The line is cleared when the work is done.
class Progress {
 public:
  static void show_none();  ///< from now on

  explicit Progress(const std::string& what);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// How much of the work is done, of all: shown in per cent.
  void update(std::size_t done, std::size_t all);
  /// A callback for the work; this object must outlive it.
  WorkProgress told() {
    return [this](std::size_t done, std::size_t all) { update(done, all); };
  }

 private:
  std::string what_;
  bool shown_;
  std::size_t percent_ = 0;
};

}  // namespace displayfile
