#pragma once

#include <functional>

#include "interp/device/picture.h"

namespace displayfile {

/// Called with rows of a picture from the top, some at a time, each time as a picture of their own
/// that is as wide: whoever takes them so never holds the whole picture.
using TakeRows = std::function<void(const Picture& rows)>;

/// A picture's file that is written as its rows come. It appears whole or not at all: without
/// commit() there is none.
class RowFile {
 public:
  virtual ~RowFile() = default;
  RowFile() = default;
  RowFile(const RowFile&) = delete;
  RowFile& operator=(const RowFile&) = delete;

  /// Appends rows, of what the file is of: the picture's pixels, ids or depth.
  virtual void write(const Picture& rows) = 0;
  /// To be called once, when all rows are written: all but the name is on the disk. Whoever writes
  /// several files finishes all of them before the first is committed.
  virtual void finish() = 0;
  /// To be called once, after finish().
  virtual void commit() = 0;
  // All throw Error, naming the file, if it cannot be written.
};

}  // namespace displayfile
