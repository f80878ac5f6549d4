#pragma once

#include <memory>
#include <ostream>
#include <string>

#include "displayfile/files.h"

namespace displayfile {

/// What is written, and appears at its destination whole or not at all: without commit() nothing
/// does. All throw Error, with the destination's name, if it cannot be written.
class Output {
 public:
  virtual ~Output() = default;
  Output() = default;
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  virtual const std::string& name() const = 0;  ///< for messages
  virtual std::ostream& stream() = 0;           ///< binary
  /// What several outputs need before the first of them is committed: all is written, a file's on
  /// the disk.
  virtual void finish() = 0;
  /// finish(), if that has not been called, and it is there. To be called once.
  virtual void commit() = 0;
};

/// A file (output_file.h), or what goes to the stream at commit().
std::unique_ptr<Output> output_to(const Destination& to);

}  // namespace displayfile
