#include "displayfile/mesh/compressed_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "clip/base/budgeted_work.h"
#include "clip/base/error.h"
#include "clip/base/files.h"
#include "clip/base/work_budget.h"

namespace displayfile {

namespace {

constexpr std::string_view kGzip = "\x1F\x8B", kZstd = "\x28\xB5\x2F\xFD";

}  // namespace

bool begins_compressed(std::string_view beginning) {
  return beginning.starts_with(kGzip) || beginning.starts_with(kZstd);
}

std::filesystem::path name_uncompressed(const std::filesystem::path& path) {
  const std::string extension = extension_of(path);
  if (extension != ".gz" && extension != ".zst") return path;
  return path.parent_path() / path.stem();
}

std::string uncompressed(const std::string& path, std::string_view data) {
  return data.starts_with(kGzip) ? uncompressed_gzip(path, data) : uncompressed_zstd(path, data);
}

ExpandedData::ExpandedData(const std::string& path, std::size_t compressed_bytes) : path_(path) {
  constexpr std::size_t kMostTimes = 256, kAlways = std::size_t{64} << 20;
  most_ = std::max(kAlways, kMostTimes * compressed_bytes);
  content_.resize(std::min(most_, 4 * compressed_bytes + 1));
}

ExpandedData::Room ExpandedData::room() {
  ask_budget();
  if (kept_ == content_.size()) {
    if (kept_ >= most_) {
      throw Error(fmt::format(
          "{}: it expands to more than 256 times its size: expected a compressed mesh", path_));
    }
    content_.resize(std::min(most_, 2 * kept_));
  }
  return {content_.data() + kept_, content_.size() - kept_};
}

std::string ExpandedData::take() && {
  content_.resize(kept_);
  return std::move(content_);
}

void ExpandedData::fail(std::string_view library, std::string_view what) const {
  throw Error(fmt::format("{}: its compressed data are {} ({})", path_, what, library));
}

}  // namespace displayfile
