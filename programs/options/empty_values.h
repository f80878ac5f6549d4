#pragma once

#include <CLI/App.hpp>

namespace displayfile {

/// Makes the parser refuse empty values of options and inputs, as from unset shell variables; texts
/// that are drawn may be empty.
void refuse_empty_values(CLI::App& command);

}  // namespace displayfile
