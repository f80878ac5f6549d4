#pragma once

#include <string>

namespace displayfile {

/// Names of units of length, for the help of an option.
inline constexpr const char* kLengthUnits = "mm|cm|m|in";

/// A unit of length in mm: mm, cm, m, and in or inch. Throws Error, which names --unit, for others.
double millimetres_of_unit(const std::string& word);

}  // namespace displayfile
