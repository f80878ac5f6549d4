#include "displayfile/text/output_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "clip/base/error.h"
#include "tests/error_of.h"
#include "tests/temporary_folder.h"

namespace displayfile {
namespace {

namespace fs = std::filesystem;

using test::content;

class OutputFileTest : public test::TemporaryFolder {
 protected:
  static void write(const std::string& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
  }
  static std::string error_of(const std::string& path) {
    return test::error_of([&] {
      OutputFile file(path);
      file.stream() << "text";
      file.commit();
    });
  }
  std::ptrdiff_t files() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }

  const std::string target_ = file("picture.png").string();
};

TEST_F(OutputFileTest, AppearsAtCommitAndNotBefore) {
  OutputFile file(target_);
  file.stream() << "one\r\n" << '\0';
  file.stream().flush();
  EXPECT_FALSE(fs::exists(target_));
  file.commit();
  EXPECT_EQ(content(target_), std::string("one\r\n\0", 6));
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, PiecesOfAnyLengthAreWrittenInOrder) {
  std::string all;
  OutputFile file(target_);
  for (std::size_t n = 1, k = 0; all.size() < 5 * BlockBuffer::kBlock; ++k) {
    const std::string piece(n, static_cast<char>('a' + k % 26));
    file.stream().write(piece.data(), static_cast<std::streamsize>(piece.size()));
    file.stream().put('|');
    if (k % 50 == 49) file.stream().flush();
    all += piece + '|';
    n = n * 7 % 300007;
  }
  const std::string block(BlockBuffer::kBlock, '#');
  file.stream() << block << block;
  file.commit();
  EXPECT_TRUE(content(target_) == all + block + block);
}

TEST_F(OutputFileTest, WithoutCommitTheOldFileStays) {
  write(target_, "old");
  {
    OutputFile file(target_);
    file.stream() << "new";
  }
  EXPECT_EQ(content(target_), "old");
  EXPECT_EQ(files(), 1);
  {
    OutputFile file(target_);
    file.stream() << "new";
    file.commit();
  }
  EXPECT_EQ(content(target_), "new");
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, TemporaryPathIsForWritersThatTakeAPath) {
  OutputFile file(target_);
  EXPECT_EQ(fs::path(file.temporary_path()).parent_path(), folder_);
  EXPECT_EQ(fs::path(file.temporary_path()).extension(), ".png");
  write(file.temporary_path(), "written elsewhere");
  file.commit();
  EXPECT_EQ(content(target_), "written elsewhere");
  EXPECT_EQ(files(), 1);
}

/// A process that is killed leaves nothing, where the file system has files without names.
TEST_F(OutputFileTest, HasNoNameUntilItIsWhole) {
  const int nameless = ::open(folder_.c_str(), O_RDWR | O_TMPFILE, 0600);
  if (nameless < 0) GTEST_SKIP() << "no files without names here";
  ::close(nameless);
  write(target_, "old");
  OutputFile file(target_), other((folder_ / "other.png").string());
  file.stream() << "new" << std::flush;
  other.stream() << "other" << std::flush;
  EXPECT_EQ(files(), 1);
  file.finish();
  other.finish();
  EXPECT_EQ(files(), 1);
  EXPECT_EQ(content(target_), "old");
  file.commit();
  other.commit();
  EXPECT_EQ(content(target_), "new");
  EXPECT_EQ(content(folder_ / "other.png"), "other");
  EXPECT_EQ(files(), 2);
}

TEST_F(OutputFileTest, FolderThatWentAwayIsAnErrorAtCommit) {
  const fs::path gone = folder_ / "gone";
  for (const bool named : {false, true}) {
    fs::create_directories(gone);
    OutputFile file((gone / "p.png").string());
    if (named) file.temporary_path();
    file.stream() << "text";
    fs::rename(gone, folder_ / "elsewhere");
    EXPECT_EQ(
        test::error_of([&] { file.commit(); }),
        (gone / "p.png").string() + ": cannot be written: there is no folder " + gone.string());
    fs::remove_all(folder_ / "elsewhere");
  }
}

/// A process may have a limit of file size: a longer file is an error, and the old file stays.
TEST_F(OutputFileTest, FileThatMayNotBeSoLongIsAnError) {
  write(target_, "old");
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  ::signal(SIGXFSZ, SIG_IGN);
  for (const bool named : {false, true}) {
    OutputFile file(target_);
    if (named) file.temporary_path();
    const rlimit short_files{50000, before.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &short_files);
    file.stream() << std::string(400000, 'x') << std::flush << "more";
    const std::string error = test::error_of([&] { file.commit(); });
    ::setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_EQ(error, target_ + ": not all could be written: File too large");
    EXPECT_EQ(files(), 1);
  }
  ::signal(SIGXFSZ, SIG_DFL);
  EXPECT_EQ(content(target_), "old");
}

TEST_F(OutputFileTest, TwoFilesOfOneNameDoNotMix) {
  OutputFile first(target_), second(target_);
  first.stream() << "first";
  second.stream() << "second";
  second.commit();
  first.commit();
  EXPECT_EQ(content(target_), "first");
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, PermissionsAreKept) {
  write(target_, "old");
  fs::permissions(target_, fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(error_of(target_), "");
  EXPECT_EQ(fs::status(target_).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(OutputFileTest, SymbolicLinkIsFollowed) {
  const std::string link = (folder_ / "link.png").string();
  write(target_, "old");
  fs::create_symlink("picture.png", link);
  EXPECT_EQ(error_of(link), "");
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(content(target_), "text");
}

/// Whether its target exists or not.
TEST_F(OutputFileTest, SymbolicLinkToWhatIsNotThereIsFollowed) {
  const std::string link = (folder_ / "link.png").string();
  fs::create_directory(folder_ / "real");
  fs::create_symlink("second.png", link);
  fs::create_symlink("real/picture.png", folder_ / "second.png");
  EXPECT_EQ(error_of(link), "");
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_TRUE(fs::is_symlink(folder_ / "second.png"));
  EXPECT_EQ(content(folder_ / "real/picture.png"), "text");
  fs::create_symlink("nowhere/picture.png", folder_ / "lost.png");
  const std::string lost = (folder_ / "lost.png").string();
  EXPECT_EQ(error_of(lost), lost + ": cannot be written: there is no folder " +
                                (fs::canonical(folder_) / "nowhere").string());
}

TEST_F(OutputFileTest, SymbolicLinksThatLeadAroundAreAnError) {
  const std::string link = (folder_ / "link.png").string();
  fs::create_symlink("other.png", link);
  fs::create_symlink("link.png", folder_ / "other.png");
  EXPECT_EQ(error_of(link), link + ": cannot be written: Too many levels of symbolic links");
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(files(), 2);
}

TEST_F(OutputFileTest, LongNameIsFine) {
  const std::string path = folder_.string() + '/' + std::string(250, 'x') + ".svg";
  EXPECT_EQ(error_of(path), "");
  EXPECT_EQ(content(path), "text");
}

TEST_F(OutputFileTest, FolderOrMissingFolderOrNoNameIsAnError) {
  EXPECT_EQ(error_of(folder_.string()), folder_.string() + ": is a folder: expected a file name");
  const std::string nowhere = (folder_ / "missing" / "p.png").string();
  EXPECT_EQ(error_of(nowhere),
            nowhere + ": cannot be written: there is no folder " + (folder_ / "missing").string());
  EXPECT_EQ(error_of(""), "the output file has no name");
  EXPECT_EQ(files(), 0);
}

/// Root may write everywhere: for the length of a test it is somebody else.
class NotRoot {
 public:
  NotRoot() { EXPECT_EQ(::geteuid() == 0 ? ::seteuid(65534) : 0, 0); }
  ~NotRoot() { EXPECT_EQ(::getuid() == 0 ? ::seteuid(0) : 0, 0); }
};

TEST_F(OutputFileTest, UnwritableFolderOrFileIsAnError) {
  write(target_, "old");
  const std::string other = (folder_ / "other.png").string();
  {
    fs::permissions(folder_, fs::perms::all);
    const NotRoot not_root;
    EXPECT_EQ(error_of(other), "");
  }
  fs::permissions(target_, static_cast<fs::perms>(0444));
  fs::permissions(folder_, static_cast<fs::perms>(0555));
  const std::string third = (folder_ / "third.png").string();
  {
    const NotRoot not_root;
    EXPECT_EQ(error_of(target_), target_ + ": cannot be written: Permission denied");
    EXPECT_EQ(error_of(third), third + ": cannot be written: Permission denied");
  }
  EXPECT_EQ(files(), 2);
}

/// Devices are written to in place; one that is full is noticed at commit at the latest.
TEST_F(OutputFileTest, FullDiskIsNoticed) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  EXPECT_EQ(error_of("/dev/full"), "/dev/full: not all could be written: No space left on device");
  EXPECT_EQ(error_of("/dev/null"), "");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

/// The cleanup of a process that receives a signal to end; a file that is whole stays.
TEST_F(OutputFileTest, IsGoneIfAllThatIsUnfinishedIsRemoved) {
  write(target_, "old");
  OutputFile file(target_), other((folder_ / "other.png").string());
  write(file.temporary_path(), "text");
  write(other.temporary_path(), "text");
  OutputFile whole((folder_ / "whole.png").string());
  whole.stream() << "text";
  whole.commit();
  EXPECT_EQ(files(), 4);
  UnfinishedPath::remove_all();
  EXPECT_EQ(files(), 2);
  EXPECT_EQ(content(target_), "old");
  EXPECT_TRUE(fs::exists(folder_ / "whole.png"));
}

/// A folder registered before its contents is removed too, whatever places in the table are free.
TEST_F(OutputFileTest, UnfinishedFoldersAreGoneWithWhatIsInThem) {
  const fs::path outer = folder_ / "outer", inner = outer / "inner";
  UnfinishedPath free_later(file("other.png").string());
  const UnfinishedPath of_outer(outer.string());
  free_later = {};
  const UnfinishedPath of_inner(inner.string());
  const UnfinishedPath of_file((inner / "picture.png").string());
  fs::create_directories(inner);
  write((inner / "picture.png").string(), "text");
  UnfinishedPath::remove_all();
  EXPECT_FALSE(fs::exists(outer));
}

TEST_F(OutputFileTest, TargetThatBecameAFolderIsAnErrorAtCommit) {
  OutputFile file(target_);
  file.stream() << "text";
  fs::create_directories(fs::path(target_) / "inside");
  EXPECT_THROW(file.commit(), Error);
  EXPECT_EQ(files(), 1);  // the temporary file is gone
}

/// By its name it would be replaced, and other output to it lost.
TEST_F(OutputFileTest, StandardOutputHasSeveralNames) {
  for (const char* name : {"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"}) {
    EXPECT_TRUE(is_standard_output(name)) << name;
  }
  EXPECT_FALSE(is_standard_output("stdout"));
}

/// A library that writes by itself may read back its output.
TEST_F(OutputFileTest, APipeTakesWhatATemporaryFileHas) {
  const std::string pipe = file("pipe").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  OutputFile output(pipe);
  write(output.temporary_path(), "first\n");
  EXPECT_EQ(content(output.temporary_path()), "first\n");
  output.commit();
  char read_there[16] = {};
  EXPECT_EQ(::read(reader, read_there, sizeof read_there), 6);
  EXPECT_EQ(std::string(read_there), "first\n");
  ::close(reader);
  EXPECT_EQ(files(), 1);
}

}  // namespace
}  // namespace displayfile
