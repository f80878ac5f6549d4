#pragma once

#include <fstream>
#include <string>

#include "displayfile/unfinished_path.h"

namespace displayfile {

/// A file that appears whole or not at all. What is written goes to a temporary file beside
/// the target, and commit() renames it over the target; without commit() the destructor
/// removes it and the target is what it was; so does UnfinishedPath::remove_all, for a process that
/// is told to stop.
///
///   OutputFile out("picture.svg");
///   out.stream() << ...;          // or hand out.temporary_path() to a library that writes
///   out.commit();
///
/// The path "-" is standard output: what is written goes to a temporary file too, and commit()
/// copies it there.
class OutputFile {
 public:
  /// Creates the temporary file. Throws Error, naming the path, if the folder does not exist
  /// or cannot be written to, or the path is a folder. A target that is not a regular file
  /// (/dev/null, a pipe) is written to directly.
  explicit OutputFile(std::string path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  const std::string& path() const { return path_; }  ///< of the target, as messages name it
  /// What to open for a writer that takes a path; the file exists and is empty. It is in the
  /// target's folder, or for standard output in that for temporary files, and ends in the target's
  /// extension. Do not use stream() then.
  const std::string& temporary_path() const { return temporary_; }
  /// Binary; the first call opens it.
  std::ostream& stream();

  /// Throws Error, naming the path, if anything could not be written (a full disk) or the
  /// rename fails; the temporary file is then gone. To be called once, with every other
  /// writer of temporary_path() closed.
  void commit();

 private:
  [[noreturn]] void fail(const std::string& what) const;
  [[noreturn]] void fail_to_write() const;  // with the reason in errno
  void create_temporary();
  void remove_temporary();
  void copy_to_standard_output();

  std::string path_, target_, temporary_;  // target_: path_ with a symbolic link followed
  bool standard_output_ = false;
  bool direct_ = false;   // the target is written to in place
  bool pending_ = false;  // the temporary file is ours to remove
  UnfinishedPath unfinished_;
  std::ofstream stream_;
};

}  // namespace displayfile
