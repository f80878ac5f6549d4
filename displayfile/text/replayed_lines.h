#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

#include "displayfile/graphics_system.h"

namespace displayfile {

/// Called after a line of a drawing program, counted from 1, with the routine that it called.
using AfterLine = std::function<void(std::size_t line, std::string_view routine)>;

/// As replay (displayfile/files.h), with a call after each line that calls a routine.
void replay_lines(std::string_view text, std::string_view file_name, GraphicsSystem& system,
                  const AfterLine& after_line);

}  // namespace displayfile
