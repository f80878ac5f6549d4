#pragma once

#include <string>

namespace displayfile {

/// Says on standard error what long work is being done, if that is a terminal; nothing
/// otherwise. The line is wiped when the work is done.
class Progress {
 public:
  explicit Progress(const std::string& what);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

 private:
  bool terminal_;
};

}  // namespace displayfile
