#pragma once

#include <functional>

#include "interp/device/picture.h"

namespace displayfile {

/// Called with successive rows of a picture from the top, as pictures of the same width, so that
/// the receiver never holds the whole picture.
using TakeRows = std::function<void(const Picture& rows)>;

/// A picture's file, written row by row. It is written completely or not at all: without commit()
/// there is none.
class RowFile {
 public:
  virtual ~RowFile() = default;
  RowFile() = default;
  RowFile(const RowFile&) = delete;
  RowFile& operator=(const RowFile&) = delete;

  /// Appends rows of the file's data: the picture's pixels, ids or depth.
  virtual void write(const Picture& rows) = 0;
  /// Must be called once, after all rows: puts all data, except the name, on the disk. For several
  /// files, all are finished before the first is committed.
  virtual void finish() = 0;
  /// Must be called once, after finish().
  virtual void commit() = 0;
  // All throw Error, naming the file, if it cannot be written.
};

}  // namespace displayfile
