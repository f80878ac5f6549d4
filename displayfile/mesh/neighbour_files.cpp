#include "displayfile/mesh/neighbour_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <system_error>

#include "clip/base/error.h"

namespace displayfile {

NeighbourFiles::NeighbourFiles(const std::string& mesh) {
  std::error_code failure;
  mesh_ = std::filesystem::canonical(mesh, failure);
  if (!failure) {
    const auto folder = std::filesystem::path(mesh).parent_path();
    folder_ = std::filesystem::canonical(folder.empty() ? "." : folder, failure);
  }
  if (failure) throw Error(fmt::format("{}: no such file: expected a mesh", mesh));
}

bool NeighbourFiles::allows(const std::string& path) const {
  std::error_code failure;
  const auto file = std::filesystem::canonical(path, failure);
  if (failure || !std::filesystem::is_regular_file(file, failure)) return false;
  return file == mesh_ ||
         std::mismatch(folder_.begin(), folder_.end(), file.begin(), file.end()).first ==
             folder_.end();
}

std::optional<std::string> percent_decoded(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      decoded += text[i];
      continue;
    }
    const std::string_view digits = text.substr(i + 1, 2);
    unsigned value = 0;
    const char* const end = digits.data() + digits.size();
    const auto [parsed, failure] = std::from_chars(digits.data(), end, value, 16);
    const bool is_whole = digits.size() == 2 && failure == std::errc() && parsed == end;
    if (!is_whole || value == 0) return std::nullopt;
    decoded += static_cast<char>(value);
    i += digits.size();
  }
  return decoded;
}

}  // namespace displayfile
