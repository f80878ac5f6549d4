#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include "clip/base/error.h"
#include "clip/base/work_budget.h"
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/text/dump_compare.h"

namespace displayfile {

/// Replays each line of a program by itself: a refused line leaves the state unchanged, and the
/// next continues from there.
inline void replay_lines(std::string_view program, GraphicsSystem& system) {
  while (!program.empty()) {
    const std::size_t length = std::min(program.find('\n'), program.size());
    try {
      replay(program.substr(0, length), "line", system);
    } catch (const LimitReached&) {
      throw;
    } catch (const Error&) {  // or it opened the segment that is still open at its end
    }
    program.remove_prefix(std::min(length + 1, program.size()));
  }
}

/// Replays a program, which may be wrong, without its wrong lines while recording it; replays the
/// recording, and returns the first difference between the two display files. An Error from the
/// recording is not caught: a recording must replay. Throws LimitReached under a budget.
inline std::optional<std::string> difference_after_record_and_replay(std::string_view program) {
  std::ostringstream recording;
  Recorder recorder(recording);
  GraphicsSystem first, second;
  first.set_recorder(&recorder);
  replay_lines(program, first);
  while (first.counts().solids_open > 0) first.discard_solid();
  if (first.open_segment_name()) first.close_segment();
  while (first.counts().transformations_saved > 0) first.restore_transformation_3();
  replay(recording.str(), "recording", second);
  return first_difference(dump(second.display_file()), dump(first.display_file()));
}

}  // namespace displayfile
