#include "displayfile/text/program_in_view.h"

#include <algorithm>

#include "clip/base/collected_text.h"
#include "clip/base/round_to_nearest.h"
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/views/set_view.h"

namespace displayfile {

namespace {

bool sets_view(std::string_view line) {
  constexpr std::string_view kSpaces = " \t\r";
  line.remove_prefix(std::min(line.find_first_not_of(kSpaces), line.size()));
  const std::string_view name = line.substr(0, line.find_first_of(kSpaces));
  const auto all = user_routines();
  const auto routine = std::ranges::find(all, name, &UserRoutine::name);
  return routine != all.end() && routine->section == "View";
}

/// The user routines that set it.
std::string lines_of(const View& view) {
  CollectedText lines;
  Recorder recorder(lines);
  GraphicsSystem system;
  system.set_recorder(&recorder);
  system.set_window_fit(WindowFit::stretch);
  set_view(view, system);
  system.set_viewport(view.viewport.x_min, view.viewport.x_max, view.viewport.y_min,
                      view.viewport.y_max);
  return lines.str();
}

}  // namespace

std::string program_in_view(std::string_view program, const View& view) {
  const RoundToNearest nearest;
  std::string result = lines_of(view);
  result.reserve(result.size() + program.size() + 1);
  while (!program.empty()) {
    const std::size_t end = std::min(program.find('\n'), program.size());
    if (const std::string_view line = program.substr(0, end); !sets_view(line)) {
      result.append(line).append("\n");
    }
    program.remove_prefix(std::min(end + 1, program.size()));
  }
  return result;
}

}  // namespace displayfile
