#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <utility>

namespace displayfile {

/// Where what is written goes: to a file, by its path, or to a stream of the caller's, in memory
/// for example. What goes to a stream is written there at once when all of it is ready, and nothing
/// if it fails; files appear whole or not at all (output_file.h).
class Destination {
 public:
  Destination(std::string path) : path_(std::move(path)) {}
  Destination(const char* path) : path_(path) {}
  Destination(const std::filesystem::path& path) : path_(path.string()) {}
  /// It must live on until all is written.
  Destination(std::ostream& stream) : path_("the stream"), stream_(&stream) {}

  const std::string& name() const { return path_; }  ///< the path, or words for messages
  std::ostream* stream() const { return stream_; }   ///< null: a file
  bool is_file() const { return stream_ == nullptr; }
  /// With its dot; of a stream none.
  std::string extension() const {
    return is_file() ? std::filesystem::path(path_).extension().string() : std::string();
  }

 private:
  std::string path_;
  std::ostream* stream_ = nullptr;
};

}  // namespace displayfile
