#include "programs/command/drawn_again.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <random>
#include <string_view>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "interp/files/npy_file.h"
#include "interp/files/picture_compare.h"
#include "interp/files/png_file.h"
#include "interp/files/ppm_file.h"

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

/// Formats by the bytes with which their files begin: a file's name may have another ending.
enum class FileKind { png, ppm, npy, svg, other };
FileKind kind_of(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG")) return FileKind::png;
  if (bytes.starts_with("P6")) return FileKind::ppm;
  if (bytes.starts_with("\x93NUMPY")) return FileKind::npy;
  return bytes.starts_with('<') ? FileKind::svg : FileKind::other;
}

/// The pixels per length that a PNG file states; empty if none.
std::string_view density_of(std::string_view png) {
  constexpr std::size_t kLength = 9;
  const std::size_t at = png.substr(0, png.find("IDAT")).find("pHYs");
  return at == std::string_view::npos ? std::string_view() : png.substr(at + 4, kLength);
}

std::string compared(const std::string& file, const std::string& drawn) {
  const std::string there = bytes_of(file), anew = bytes_of(drawn);
  const FileKind kind = kind_of(anew);
  if (kind_of(there) != kind) return "another format";
  switch (kind) {
    case FileKind::npy: return in_pixels(compare(read_npy(file), read_npy(drawn)));
    case FileKind::ppm: return in_pixels(compare(read_ppm(file), read_ppm(drawn)));
    case FileKind::png: {
      const std::string how =
          in_pixels(compare(read_png(file, Alpha::stored), read_png(drawn, Alpha::stored)));
      const bool is_as_dense = density_of(there) == density_of(anew);
      return how.empty() && !is_as_dense ? "another dpi" : how;
    }
    default: return in_bytes(there, anew, kind == FileKind::svg);
  }
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
