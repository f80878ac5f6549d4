#include "tests/bench/command/partial_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "clip/base/error.h"

namespace displayfile::bench {

PartialFile::PartialFile(std::string path, const std::string& identity) : path_(std::move(path)) {
  const Json header{{"displayfile_bench", 2}, {"of", identity}};
  std::ifstream in(path_, std::ios::binary);
  std::string line;
  if (std::getline(in, line) && Json::parse(line, nullptr, false) == header) {
    while (std::getline(in, line) && !in.eof()) {  // one that was cut off has no end
      const Json json = Json::parse(line, nullptr, false);
      if (json.contains("key") && json.contains("figures")) {
        finished_[json["key"]] = json["figures"];
      }
    }
  }
  in.close();
  out_.open(path_, std::ios::binary | std::ios::trunc);
  write_line(header);
  for (const auto& [key, figures] : finished_) add(key, figures);
}

const Json* PartialFile::find(const std::string& key) const {
  const auto found = finished_.find(key);
  return found == finished_.end() ? nullptr : &found->second;
}

void PartialFile::add(const std::string& key, const Json& figures) {
  write_line({{"key", key}, {"figures", figures}});
}

void PartialFile::write_line(const Json& line) {
  out_ << line.dump() << '\n' << std::flush;
  if (!out_) throw Error(path_ + ": cannot be written: " + std::strerror(errno));
}

void PartialFile::remove() {
  out_.close();
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

}  // namespace displayfile::bench
