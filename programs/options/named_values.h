#pragma once

#include <span>

#include "programs/manual/value_name.h"

namespace displayfile {

/// What names in capitals stand for among the values of the command's options and inputs.
std::span<const NamedValues> named_values();

}  // namespace displayfile
