#pragma once

#include <span>

#include "programs/manual/value_name.h"

namespace displayfile {

/// The meanings of names in capitals among the values of the command's options and inputs.
std::span<const NamedValues> named_values();

}  // namespace displayfile
