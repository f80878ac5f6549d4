#include "displayfile/text/program_in_view.h"

#include <algorithm>
#include <charconv>
#include <functional>
#include <optional>
#include <system_error>

#include "clip/base/collected_text.h"
#include "clip/base/round_to_nearest.h"
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/views/scene_in_one_view.h"

namespace displayfile {

namespace {

constexpr std::string_view kSpaces = " \t\r";

/// Removes the first word and returns it.
std::string_view take_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(kSpaces), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(kSpaces));
  line.remove_prefix(word.size());
  return word;
}

bool sets_view(std::string_view line) {
  const std::string_view name = take_word(line);
  const auto all = user_routines();
  const auto routine = std::ranges::find(all, name, &UserRoutine::name);
  return routine != all.end() && routine->section == "View";
}

/// The user routines that set the view.
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

/// The name of the segment that the line opens.
std::optional<int> segment_opened(std::string_view line) {
  if (take_word(line) != "open-segment") return std::nullopt;
  const std::string_view word = take_word(line);
  int name = 0;
  const auto read = std::from_chars(word.data(), word.data() + word.size(), name);
  return read.ec == std::errc() ? std::optional(name) : std::nullopt;
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

std::string program_in_views(std::string_view program,
                             const std::function<const View&(int segment)>& view_of) {
  const RoundToNearest nearest;
  std::string result;
  std::optional<View> in_force;
  while (!program.empty()) {
    const std::size_t end = std::min(program.find('\n'), program.size());
    const std::string_view line = program.substr(0, end);
    if (const auto segment = segment_opened(line); segment && in_force != view_of(*segment)) {
      in_force = view_of(*segment);
      result.append(lines_of(*in_force));
    }
    if (!sets_view(line)) result.append(line).append("\n");
    program.remove_prefix(std::min(end + 1, program.size()));
  }
  return result;
}

}  // namespace displayfile
