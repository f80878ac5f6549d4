#pragma once

#include <memory>
#include <ostream>
#include <string>

#include "clip/base/block_buffer.h"
#include "clip/base/unfinished_path.h"
#include "displayfile/text/output.h"

namespace displayfile {

/// A file that is written completely or not at all. Data goes to a temporary file in the target's
/// folder, without a name where the file system supports that: commit() puts it on the disk and
/// renames it over the target. Without commit() the destructor removes it and the target is
/// unchanged; UnfinishedPath::remove_all does so for a process ended by a signal. A killed process
/// leaves at most one file beside the target, whose name begins with a dot; where temporary files
/// have no name, only if it was killed while naming it.
///
///   OutputFile out("picture.svg");
///   out.stream() << ...;          // or pass out.temporary_path() to a library that writes
///   out.commit();
///
/// The path "-" is standard output, and so are /dev/stdout and its other names: data goes to a
/// temporary file too, which commit() copies there.
class OutputFile : public Output {
 public:
  /// Creates the temporary file. Throws Error, naming the path, if the folder does not exist
  /// or cannot be written to, or the path is a folder. A target that is not a regular file
  /// (/dev/null, a pipe) is written to directly.
  explicit OutputFile(std::string path);
  ~OutputFile() override;

  const std::string& name() const override { return path_; }  ///< the target's path
  /// The path for a writer that opens files itself; the file exists and is empty. It is in the
  /// target's folder, or in that for temporary files if it is to be copied to standard output, a
  /// device or a pipe, and has the target's extension. stream() must not be used then.
  const std::string& temporary_path();
  /// Binary; the first call opens it.
  std::ostream& stream() override;

  /// Called for several files before the first is committed: writes all data to the disk; every
  /// other writer of temporary_path() must be closed. Throws Error, naming the path, if anything
  /// could not be written (a full disk), and removes the temporary file.
  void finish() override;

  /// Calls finish() if necessary and names the file. Throws Error too if the rename fails, after
  /// removing the temporary file; or if the file is named, but the name may not be on the disk. To
  /// be called once.
  void commit() override;

 private:
  [[noreturn]] void fail(const std::string& what) const;
  [[noreturn]] void fail_to_write() const;  // by errno
  [[noreturn]] void fail_at_the_end(const std::string& what, int reason);
  void create_temporary();
  template <class Create>
  void create_named(const Create& create);
  void name_temporary();
  void create_to_be_copied();
  void replace_target();
  bool link_to_target() const;
  void close();
  void remove_temporary();
  void copy_to_target();

  std::string path_, target_, temporary_;  // target_: path_ with a symbolic link followed
  bool standard_output_ = false;
  bool copied_ = false;    // the temporary file is copied to standard output, a device or a pipe
  bool direct_ = false;    // the target is written to in place
  bool pending_ = false;   // the temporary file has a name and must be removed
  bool finished_ = false;  // and on the disk
  int descriptor_ = -1;    // of the temporary file, or of the target that is written to in place
  UnfinishedPath unfinished_;
  std::unique_ptr<BlockBuffer> blocks_;
  std::ostream stream_{nullptr};
};

/// True for "-" and for the system's names of standard output.
bool is_standard_output(const std::string& path);

}  // namespace displayfile
