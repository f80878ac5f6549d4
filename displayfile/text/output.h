#pragma once

#include <memory>
#include <ostream>
#include <string>

#include "displayfile/files.h"

namespace displayfile {

/// Output that is written to its destination completely at commit(), or not at all. All members
/// throw Error, with the destination's name, if it cannot be written.
class Output {
 public:
  virtual ~Output() = default;
  Output() = default;
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  virtual const std::string& name() const = 0;  ///< for messages
  virtual std::ostream& stream() = 0;           ///< binary
  /// Completes writing, for a file to the disk; called for several outputs before the first is
  /// committed.
  virtual void finish() = 0;
  /// Calls finish() if necessary and publishes the output. Must be called only once.
  virtual void commit() = 0;
};

/// A file (output_file.h), or a buffer written to the stream at commit().
std::unique_ptr<Output> output_to(const Destination& to);

}  // namespace displayfile
