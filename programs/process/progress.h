#pragma once

#include <cstddef>
#include <string>

#include "clip/base/work_progress.h"

namespace displayfile {

/// Says on standard error what long work is being done, if that is a terminal and no other is being
/// said to be done; nothing otherwise. The line is wiped when the work is done.
class Progress {
 public:
  static void show_none();  ///< from now on

  explicit Progress(const std::string& what);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// How much of the work is done, of all: shown in per cent.
  void update(std::size_t done, std::size_t all);
  /// That, for who does the work; this object must live on.
  WorkProgress told() {
    return [this](std::size_t done, std::size_t all) { update(done, all); };
  }

 private:
  std::string what_;
  bool shown_;
  std::size_t percent_ = 0;
};

}  // namespace displayfile
