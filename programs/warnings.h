#pragma once

#include <iosfwd>

namespace displayfile {

/// Where the command writes warnings: standard error, or, in a thread that has one, what collects
/// them, so that those of several inputs that are drawn at a time do not mix.
std::ostream& warnings();

class CollectedWarnings {
 public:
  explicit CollectedWarnings(std::ostream& into);
  ~CollectedWarnings();
  CollectedWarnings(const CollectedWarnings&) = delete;
  CollectedWarnings& operator=(const CollectedWarnings&) = delete;

 private:
  std::ostream* before_;
};

}  // namespace displayfile
