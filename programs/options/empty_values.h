#pragma once

#include <CLI/App.hpp>

namespace displayfile {

/// Whoever parses the command line is told of any option or input of the command whose value is
/// empty, as of a variable of a shell that is not set; texts that are drawn may be.
void refuse_empty_values(CLI::App& command);

}  // namespace displayfile
