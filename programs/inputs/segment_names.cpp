#include "programs/inputs/segment_names.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <system_error>

#include "displayfile/files.h"
#include "displayfile/segments/display_file.h"

namespace displayfile {

namespace {

/// Names of segments that stand after a routine's, and where they do for the first time.
std::map<int, std::size_t> names_after(std::string_view program, std::string_view routine) {
  std::map<int, std::size_t> names;
  for (auto at = program.find(routine); at != program.npos; at = program.find(routine, at)) {
    at += routine.size();
    const auto number = std::min(program.find_first_not_of(" \t", at), program.size());
    const char* const end = program.data() + program.size();
    if (int name = 0; std::from_chars(program.data() + number, end, name).ec == std::errc{}) {
      names.emplace(name, at);
    }
  }
  return names;
}

/// Names of the segments that a program opens, except those that it deletes or renames before.
std::vector<int> names_opened(std::string_view program) {
  const auto deleted = names_after(program, "delete-segment");
  const auto renamed = names_after(program, "rename-segment");
  const auto is_before = [](const auto& others, int name, std::size_t place) {
    const auto other = others.find(name);
    return other != others.end() && other->second < place;
  };
  std::vector<int> names;
  for (const auto& [name, place] : names_after(program, "open-segment")) {
    if (is_before(deleted, name, place) || is_before(renamed, name, place)) continue;
    names.push_back(name);
  }
  return names;
}

}  // namespace

std::vector<std::pair<int, int>> make_room_for_names(std::string_view program,
                                                     GraphicsSystem& system) {
  std::vector<std::pair<int, int>> renamed;
  const DisplayFile& display_file = system.display_file();
  if (display_file.segments().empty()) return renamed;
  const std::vector<int> names = names_opened(program);
  std::int64_t last = 0;
  for (const int name : names) last = std::max<std::int64_t>(last, name);
  for (const Segment& segment : display_file.segments()) {
    last = std::max<std::int64_t>(last, segment.name());
  }
  for (const int name : names) {
    const bool is_open = system.open_segment_name() == name;
    if (!display_file.contains(name) || is_open || last == std::numeric_limits<int>::max())
      continue;
    renamed.emplace_back(name, static_cast<int>(++last));
    system.rename_segment(name, renamed.back().second);
  }
  return renamed;
}

void replay_beside(std::string_view program, std::string_view file_name, GraphicsSystem& system) {
  make_room_for_names(program, system);
  replay(program, file_name, system);
}

}  // namespace displayfile
