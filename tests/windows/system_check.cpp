// The guarantees of clip/system, and files written by it, on Windows. Prints those that fail; exit
// status 1 if any does. The last check ends the process: the exit status is 2 if all holds.

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/memory.h"
#include "clip/base/unfinished_path.h"
#include "clip/system/descriptors.h"
#include "clip/system/own_files.h"
#include "clip/system/process_memory.h"
#include "clip/system/stopping.h"
#include "displayfile/text/output_file.h"

namespace displayfile {
namespace {

namespace fs = std::filesystem;

int failures = 0;

void expect(bool is_so, const char* what) {
  if (is_so) return;
  std::cerr << "not so: " << what << '\n';
  ++failures;
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::ptrdiff_t files_in(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

void check_descriptors(const fs::path& folder) {
  const std::string one = (folder / "one").string(), other = (folder / "other").string();
  const int descriptor = create_file(one);
  expect(descriptor >= 0, "a file is created");
  expect(create_file(one) < 0 && errno == EEXIST, "a file that exists is not created");
  expect(create_file((folder / "none" / "one").string()) < 0 && errno == ENOENT,
         "nor in no folder");
  expect(write_all(descriptor, "a\nb\r\n", 5), "it is written");
  expect(put_on_disk(descriptor), "it is put on the disk");
  rewind_file(descriptor);
  std::array<char, 8> read{};
  expect(read_some(descriptor, read.data(), read.size()) == 5, "its bytes are read as they are");
  expect(can_write(descriptor), "it can be written to");
  expect(!can_write(77) && errno == EBADF, "a closed descriptor cannot");
  std::ofstream(other) << "before";
  close_file(descriptor);
  expect(rename_file(one, other), "it replaces another file");
  expect(text_of(other) == "a\nb\r\n" && !fs::exists(one), "which has its bytes then");
  expect(may_write(other), "that may be written to");
  expect(remove_path(other.c_str()) && !fs::exists(other), "and removed");
  const int open = create_file(one);
  expect(remove_path(one.c_str()), "as may an open file, by the handler of a stopped process");
  close_file(open);
  expect(!fs::exists(one), "which is gone when it is closed");
}

void check_folders(const fs::path& folder) {
  fs::create_directory(folder / "full");
  std::ofstream(folder / "full" / "file") << "text";
  remove_empty_folder(kNotHeld, folder / "full");
  expect(fs::exists(folder / "full"), "a folder with a file in it stays");
  fs::remove(folder / "full" / "file");
  remove_empty_folder(kNotHeld, folder / "full");
  expect(!fs::exists(folder / "full"), "an empty one is removed");
}

void check_outputs(const fs::path& folder) {
  const std::string path = (folder / "picture.svg").string();
  std::ofstream(path) << "before";
  {
    OutputFile left(path);
    left.stream() << "after\n";
    left.finish();
  }
  expect(text_of(path) == "before" && files_in(folder) == 1, "without commit() nothing changes");
  {
    OutputFile written(path);
    written.stream() << "after\n";
    written.commit();
  }
  expect(text_of(path) == "after\n" && files_in(folder) == 1, "with it the file is replaced");
  {
    OutputFile unfinished(path);
    unfinished.stream() << "never";
    UnfinishedPath::remove_all();
    expect(files_in(folder) == 1 || files_in(folder) == 2, "an unfinished one is removed");
  }
  expect(text_of(path) == "after\n" && files_in(folder) == 1, "when the process is stopped");
  try {
    OutputFile none((folder / "none" / "a.svg").string());
    expect(false, "a missing folder is an error");
  } catch (const Error& error) {
    expect(std::string(error.what()).find("there is no folder") != std::string::npos,
           "a missing folder is named");
  }
}

void check_process() {
  std::error_code unknown;
  expect(file_of_program(unknown).filename() == "system_check.exe", "the program has its file");
  expect(file_of_this_code() == file_of_program(unknown), "so has this code");
  std::string why;
  void* const library = load_library("kernel32.dll", why);
  expect(library != nullptr, "a library is loaded");
  expect(address_in_library(library, "Sleep", why) != nullptr, "its function is found");
  expect(address_in_library(library, "NoSuch", why) == nullptr && !why.empty(), "another is not");
  expect(load_library("no-such.dll", why) == nullptr && !why.empty(), "nor another library");
  expect(data_of_process() > 0, "the memory of the process is known");
  expect(memory_of_groups() > 0, "and that of the machine");
  constexpr std::size_t kMore = std::size_t{256} << 20;
  expect(has_memory(kMore), "there is memory");
  set_limit_of_data(data_of_process() + kMore / 2);
  expect(!has_memory(kMore), "but not over a limit");
  expect(has_memory(kMore / 8), "only below it");
}

void say_nothing() noexcept {}

}  // namespace
}  // namespace displayfile

int main() {
  using namespace displayfile;
  keep_standard_descriptors();
  const fs::path folder =
      fs::temp_directory_path() / ("check-" + std::to_string(number_of_process()));
  fs::create_directory(folder);
  check_descriptors(folder);
  check_folders(folder);
  check_outputs(folder);
  fs::remove_all(folder);
  check_process();
  call_when_stopped(say_nothing);
  if (failures > 0) return 1;
  OutputFile output("-");
  output.stream() << "a line\n";
  output.commit();
  end_process_after(0.2, "time is over\n", say_nothing);
  wait_for_the_end();
}
