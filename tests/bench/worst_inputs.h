#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace displayfile::bench {

/// What one run took and made.
struct Cost {
  double seconds;  ///< of the processor
  double output;   ///< what was made, in units of the operation: pieces, lines, bytes, ...
};

/// An operation with the input that makes it grow worst.
struct WorstCase {
  std::string_view operation, input;  ///< what is done; to what, of which n there are
  std::size_t smallest;               ///< n, which is doubled
  std::string_view output;            ///< what is counted
  std::string_view bound;             ///< what bounds its growth
  Cost (*run)(std::size_t n);
};

std::span<const WorstCase> worst_of_files();     ///< reading and writing, segments, styles
std::span<const WorstCase> worst_of_pictures();  ///< viewing, sorts, lines, methods

}  // namespace displayfile::bench
