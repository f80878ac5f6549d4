#include "programs/command/drawn_again.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <random>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "interp/files/npy_file.h"
#include "interp/files/picture_compare.h"
#include "programs/options/picture_tolerance.h"

namespace displayfile {

namespace fs = std::filesystem;

namespace {

fs::path new_folder() {
  std::error_code error;
  const fs::path above = fs::temp_directory_path(error);
  if (error) throw Error("--check: there is no folder for temporary files: expected TMPDIR");
  std::random_device random;
  for (;;) {
    fs::path folder = above / fmt::format("displayfile-check-{:08x}{:08x}", random(), random());
    if (!fs::exists(folder)) return folder;
  }
}

std::string in_pixels(const PictureDifference& difference) {
  if (!difference.same_size) return "another size";
  if (!difference.differs()) return "";
  return fmt::format("{} of {} pixels", difference.wrong_pixels, difference.pixels);
}

/// The first line, or byte in files that are not text, in which two texts differ.
std::string in_bytes(const std::string& there, const std::string& drawn, bool is_text) {
  const auto [at, other] = std::ranges::mismatch(there, drawn);
  if (at == there.end() && other == drawn.end()) return "";
  if (!is_text) return fmt::format("byte {}", at - there.begin() + 1);
  return fmt::format("line {}", std::count(there.begin(), at, '\n') + 1);
}

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) throw Error(fmt::format("{}: cannot be read", file.string()));
  return bytes;
}

std::string compared(const std::string& file, const std::string& drawn) {
  const std::string extension = extension_of(file);
  if (extension == ".npy") return in_pixels(compare(read_npy(file), read_npy(drawn)));
  if (is_picture_file(file)) return in_pixels(compare(read_picture(file), read_picture(drawn)));
  return in_bytes(bytes_of(file), bytes_of(drawn), extension == ".svg");
}

}  // namespace

DrawnAgain::DrawnAgain() : folder_(new_folder()) { made_.make_for(folder_ / "file"); }

DrawnAgain::~DrawnAgain() {
  // Files of pictures that could not be drawn to their end.
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_, error)) fs::remove(entry.path(), error);
}

fs::path DrawnAgain::place(std::size_t k, const fs::path& file) const {
  return file.empty() ? fs::path() : folder_ / fmt::format("{}-{}", k, file.filename().string());
}

std::string DrawnAgain::difference(const fs::path& file, const fs::path& drawn) const {
  std::string how = "it is missing";
  if (fs::exists(file)) how = compared(file.string(), drawn.string());
  std::error_code error;
  fs::remove(drawn, error);
  return how.empty() ? "" : fmt::format("{}: differs: {}", file.string(), how);
}

}  // namespace displayfile
