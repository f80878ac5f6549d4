#pragma once

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

  /// Removes every unfinished file, and folder with nothing in it, the ones entered last first.
  /// Calls nothing that a signal handler may not.
  static void remove_all() noexcept;

 private:
  std::size_t place_ = 0;  // in the table, from 1; 0 if in none
};

}  // namespace displayfile
