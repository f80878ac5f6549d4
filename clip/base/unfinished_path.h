#pragma once

#include <cstddef>
#include <string>

#include "clip/system/stopping.h"

namespace displayfile {

/// A file or folder to be removed if a signal ends the process during the object's lifetime. It is
/// kept in a table that signal handlers may read.
class UnfinishedPath {
 public:
  UnfinishedPath() = default;
  /// Paths beyond the table's 4096 entries are ignored.
  explicit UnfinishedPath(std::string path);
  ~UnfinishedPath();
  UnfinishedPath(UnfinishedPath&& other) noexcept;
  UnfinishedPath& operator=(UnfinishedPath&& other) noexcept;

  /// Removes every unfinished file, and each folder that is then empty, in any order of entry.
  /// Async-signal-safe.
  static void remove_all() noexcept;

  /// Held while a thread creates or removes a path: between its entry in the table and its
  /// creation, or between its completion and its removal from the table. Signals do not interrupt
  /// the thread there.
  class Naming {
   public:
    Naming();
    ~Naming();
    Naming(const Naming&) = delete;
    Naming& operator=(const Naming&) = delete;

   private:
    HeldSignals held_;
  };
  /// For the handler of a signal that ends the process: blocks threads that begin Naming from now
  /// on, and returns when no thread is in it, so that remove_all then removes everything.
  static void end_naming() noexcept;
  /// Calls end_naming, then remove_all: the last action of a process stopped from outside.
  static void end_with_none() noexcept {
    end_naming();
    remove_all();
  }

 private:
  std::size_t place_ = 0;  // in the table, from 1; 0 if in none
};

}  // namespace displayfile
