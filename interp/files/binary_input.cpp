#include "interp/files/binary_input.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "clip/base/error.h"

namespace displayfile {

BinaryInput::BinaryInput(const std::filesystem::path& path) : name_(path.string()) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) fail("no such file");
  if (!std::filesystem::is_regular_file(status)) fail("not a regular file");
  stream_.open(path, std::ios::binary);
  if (!stream_) fail(fmt::format("cannot be read: {}", std::strerror(errno)));
  bytes_ = std::filesystem::file_size(path, error);
  if (error) fail("cannot be read: " + error.message());
}

std::uint64_t BinaryInput::bytes_left() {
  const auto position = stream_.tellg();
  if (position < 0) return 0;
  const auto at = static_cast<std::uint64_t>(position);
  return at < bytes_ ? bytes_ - at : 0;
}

void BinaryInput::read(char* to, std::size_t bytes) {
  if (!stream_.read(to, static_cast<std::streamsize>(bytes))) fail("truncated");
}

void BinaryInput::fail(std::string_view what) const {
  throw Error(fmt::format("{}: {}", name_, what));
}

}  // namespace displayfile
