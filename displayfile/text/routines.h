#pragma once

#include "displayfile/graphics_system.h"
#include "displayfile/text/program_line.h"

namespace displayfile {

/// Calls the user routine named by the line, with its arguments. The line must not be empty. Throws
/// ErrorAt for an unknown routine or invalid arguments, and what the routine throws.
void call_routine(ProgramLine& line, GraphicsSystem& system);

}  // namespace displayfile
