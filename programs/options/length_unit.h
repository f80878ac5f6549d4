#pragma once

#include <span>
#include <string>

namespace displayfile {

/// Names of units of length, for the help of an option.
inline constexpr const char* kLengthUnits = "mm|cm|m|in";

/// A unit of length in mm: mm, cm, m, and in or inch. Throws Error, which names --unit, for others.
double millimetres_of_unit(const std::string& word);

/// Warns of inputs in glTF, whose lengths are metres by its specification, where a length on paper
/// counts and no unit is set: they are drawn in millimetres, as many such files are.
void warn_of_metres(std::span<const std::string> inputs);

}  // namespace displayfile
