#pragma once

#include <memory>
#include <ostream>
#include <string>

#include "clip/base/block_buffer.h"
#include "clip/base/unfinished_path.h"
#include "displayfile/text/output.h"

namespace displayfile {

/// A file that appears whole or not at all. What is written goes to a temporary file in the
/// target's folder, which has no name where the file system can do that: commit() puts it on the
/// disk and renames it over the target. Without commit() the destructor removes it and the target
/// is what it was; so does UnfinishedPath::remove_all, for a process that is told to stop. A
/// process that is killed leaves at most one file beside the target, whose name begins with a dot,
/// and where temporary files have no name only if it was killed while they get one.
///
///   OutputFile out("picture.svg");
///   out.stream() << ...;          // or hand out.temporary_path() to a library that writes
///   out.commit();
///
/// The path "-" is standard output, and so are /dev/stdout and its other names: what is written
/// goes to a temporary file too, and commit() copies it there.
class OutputFile : public Output {
 public:
  /// Creates the temporary file. Throws Error, naming the path, if the folder does not exist
  /// or cannot be written to, or the path is a folder. A target that is not a regular file
  /// (/dev/null, a pipe) is written to directly.
  explicit OutputFile(std::string path);
  ~OutputFile() override;

  const std::string& name() const override { return path_; }  ///< the target's path
  /// What to open for a writer that takes a path; the file exists and is empty. It is in the
  /// target's folder, or in that for temporary files if it is to be copied to standard output, a
  /// device or a pipe; and ends in the target's extension. Do not use stream() then.
  const std::string& temporary_path();
  /// Binary; the first call opens it.
  std::ostream& stream() override;

  /// What several files need before the first of them is committed: all is written and on the disk,
  /// with every other writer of temporary_path() closed. Throws Error, naming the path, if anything
  /// could not be written (a full disk); the temporary file is then gone.
  void finish() override;

  /// finish(), if that has not been called, and the file has its name. Throws Error too if the
  /// rename fails, and the temporary file is then gone; or if it has its name, but that may not be
  /// on the disk. To be called once.
  void commit() override;

 private:
  [[noreturn]] void fail(const std::string& what) const;
  [[noreturn]] void fail_to_write() const;  // with the reason in errno
  [[noreturn]] void fail_at_the_end(const std::string& what, int reason);
  void create_temporary();
  bool create_nameless();
  template <class Create>
  void create_named(const Create& create);
  void name_temporary();
  void create_to_be_copied();
  void replace_target();
  bool link_to_target() const;
  void remove_temporary();
  void copy_to_target();

  std::string path_, target_, temporary_;  // target_: path_ with a symbolic link followed
  bool standard_output_ = false;
  bool copied_ = false;    // standard output, a device or a pipe takes what is in a temporary file
  bool direct_ = false;    // the target is written to in place
  bool pending_ = false;   // the temporary file has a name that is ours to remove
  bool finished_ = false;  // and on the disk
  int descriptor_ = -1;    // of the temporary file, or of the target that is written to in place
  UnfinishedPath unfinished_;
  std::unique_ptr<BlockBuffer> blocks_;
  std::ostream stream_{nullptr};
};

/// True for "-" and for the system's names of standard output.
bool is_standard_output(const std::string& path);

}  // namespace displayfile
