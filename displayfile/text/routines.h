#pragma once

#include "displayfile/graphics_system.h"
#include "displayfile/text/program_line.h"

namespace displayfile {

/// Calls the user routine that the line names, with its arguments. The line must not be empty.
/// Throws ErrorAt if there is no such routine or its arguments are wrong, and what it throws
/// itself.
void call_routine(ProgramLine& line, GraphicsSystem& system);

}  // namespace displayfile
