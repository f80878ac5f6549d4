#pragma once

#include <iosfwd>
#include <optional>
#include <sstream>
#include <string>

namespace displayfile {

/// Where the command writes warnings: standard error, or, in a thread that has one, what collects
/// them, so that those of several inputs that are drawn at a time do not mix.
std::ostream& warnings();

/// Collects the warnings of its thread, and what libraries write to std::cerr there.
class CollectedWarnings {
 public:
  explicit CollectedWarnings(std::ostream& into);
  ~CollectedWarnings();
  CollectedWarnings(const CollectedWarnings&) = delete;
  CollectedWarnings& operator=(const CollectedWarnings&) = delete;

 private:
  std::ostream* before_;
};

/// Collects what a library says of a file, without its name, and warns of each line with the name
/// before it in the end.
class NamedWarnings {
 public:
  explicit NamedWarnings(std::string name);
  ~NamedWarnings();
  NamedWarnings(const NamedWarnings&) = delete;
  NamedWarnings& operator=(const NamedWarnings&) = delete;

 private:
  std::string name_;
  std::stringstream made_;
  std::optional<CollectedWarnings> collected_;
};

}  // namespace displayfile
