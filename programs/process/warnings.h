#pragma once

#include <iosfwd>
#include <optional>
#include <sstream>
#include <string>

namespace displayfile {

/// The stream for the command's warnings: standard error, or the thread's collector, if it has one,
/// so that warnings of inputs drawn concurrently do not mix.
std::ostream& warnings();

/// Collects the warnings of its thread, and the output of libraries on std::cerr there.
class CollectedWarnings {
 public:
  explicit CollectedWarnings(std::ostream& into);
  ~CollectedWarnings();
  CollectedWarnings(const CollectedWarnings&) = delete;
  CollectedWarnings& operator=(const CollectedWarnings&) = delete;

 private:
  std::ostream* before_;
};

/// Collects a library's messages about a file, which lack its name, and at the end warns of each
/// line, prefixed with the name.
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
