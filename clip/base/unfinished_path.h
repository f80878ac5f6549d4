#pragma once

#include <csignal>
#include <cstddef>
#include <string>

namespace displayfile {

/// A file or folder that is to be gone if the process is told to stop before this object is: it
/// stands in a table that a signal handler may read.
class UnfinishedPath {
 public:
  UnfinishedPath() = default;
  /// Where more paths are unfinished than the table has places, 4096, this one is left out.
  explicit UnfinishedPath(std::string path);
  ~UnfinishedPath();
  UnfinishedPath(UnfinishedPath&& other) noexcept;
  UnfinishedPath& operator=(UnfinishedPath&& other) noexcept;

  /// Removes every unfinished file, and each folder with nothing else in it, in whatever order they
  /// were entered. Calls nothing that a signal handler may not.
  static void remove_all() noexcept;

  /// A thread gives something a name, or takes one away, while it has one of these: from where it
  /// stands in the table to where it is there, or from where it is whole to where it does not stand
  /// in the table any more. No signal interrupts the thread there.
  class Naming {
   public:
    Naming();
    ~Naming();
    Naming(const Naming&) = delete;
    Naming& operator=(const Naming&) = delete;

   private:
    sigset_t before_;
  };
  /// For the handler of a signal that ends the process: no thread begins to name anything from now
  /// on, but waits for the end; returns when none is about it, so that remove_all then leaves
  /// nothing, whatever the threads do.
  static void end_naming() noexcept;

 private:
  std::size_t place_ = 0;  // in the table, from 1; 0 if in none
};

}  // namespace displayfile
