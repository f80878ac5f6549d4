#include "programs/bench/partial_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "clip/error.h"
#include "programs/bench/json_report.h"

namespace displayfile::bench {

namespace {

Json header(const std::string& identity) { return {{"displayfile_bench", 1}, {"of", identity}}; }

Json line_of(const std::string& scene_key, const Cell& cell) {
  return {{"scene_key", scene_key}, {"cell", to_json(cell)}};
}

Json line_of(const std::string& task, const std::vector<Beside>& all) {
  Json json{{"task", task}, {"beside", Json::array()}};
  for (const Beside& beside : all) json["beside"].push_back(to_json(beside));
  return json;
}

std::vector<Beside> beside_from_line(const Json& json) {
  std::vector<Beside> all;
  for (const Json& beside : json.at("beside")) all.push_back(beside_from_json(beside));
  return all;
}

}  // namespace

PartialFile::PartialFile(std::string path, const std::string& identity) : path_(std::move(path)) {
  std::ifstream in(path_, std::ios::binary);
  std::string line;
  bool same = false;
  for (bool first = true; std::getline(in, line); first = false) {
    // A line that an interruption cut off has no end, or cannot be parsed.
    const Json json = Json::parse(line, nullptr, false);
    if (first) {
      same = json == header(identity);
    } else if (same && !json.is_discarded() && !in.eof()) {
      try {
        if (json.contains("task")) {
          beside_[json.at("task")] = beside_from_line(json);
        } else {
          finished_.push_back({json.at("scene_key"), cell_from_json(json.at("cell"))});
        }
      } catch (const Json::exception&) {
      }
    }
  }
  in.close();
  out_.open(path_, std::ios::binary | std::ios::trunc);
  write_line(header(identity).dump());
  for (const Finished& f : finished_) write_line(line_of(f.scene_key, f.cell).dump());
  for (const auto& [task, all] : beside_) write_line(line_of(task, all).dump());
}

const Cell* PartialFile::find(const std::string& scene_key, const CellKey& key) const {
  const auto found = std::ranges::find_if(
      finished_, [&](const Finished& f) { return f.cell.key == key && f.scene_key == scene_key; });
  return found == finished_.end() ? nullptr : &found->cell;
}

const std::vector<Beside>* PartialFile::find_beside(const std::string& task) const {
  const auto found = beside_.find(task);
  return found == beside_.end() ? nullptr : &found->second;
}

void PartialFile::add(const std::string& task, const std::vector<Beside>& beside) {
  write_line(line_of(task, beside).dump());
}

void PartialFile::add(const std::string& scene_key, const Cell& cell) {
  write_line(line_of(scene_key, cell).dump());
}

void PartialFile::write_line(const std::string& line) {
  out_ << line << '\n' << std::flush;
  if (!out_) throw Error(path_ + ": cannot be written: " + std::strerror(errno));
}

void PartialFile::remove() {
  out_.close();
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

}  // namespace displayfile::bench
