#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "programs/scenes/scene.h"

namespace displayfile {

/// Where the truth begins by which a family is judged.
enum class JudgedFrom {
  display_file,  ///< interp/truth/truth.h
  entered,       ///< interp/truth/entered_truth.h: polygons that touch as entered touch, whatever
                 ///< viewing rounds
};

/// A family of scenes that break published implementations.
struct HardCase {
  std::string_view name, what;
  std::string_view severity_means;
  std::size_t size;                ///< the n of the table
  std::vector<double> severities;  ///< those of the table
  /// The same scene, bit for bit, for the same arguments on every machine.
  Scene (*make)(std::size_t n, double severity, std::uint64_t seed);
  std::string_view hard;  ///< the difficulty, for the document
  JudgedFrom judged_from = JudgedFrom::display_file;

  /// True for those with a gap that shrinks in powers of ten: the sweep shows where each method
  /// breaks.
  bool has_gap() const { return severity_means == "gap 10^-s"; }
};

std::span<const HardCase> hard_cases();

/// Throws Error for an unknown name.
const HardCase& hard_case(std::string_view name);

}  // namespace displayfile
