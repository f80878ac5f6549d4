#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace displayfile::bench {

/// A function of the work, as callgrind counts it.
struct FunctionCount {
  std::string name;                ///< with its parameters
  std::string object;              ///< the file of the program or library that it is in
  std::uint64_t instructions = 0;  ///< without those of the functions that it calls
  std::uint64_t allocations = 0;   ///< its own calls of operator new

  /// True if one of the parts is in the name, without its parameters, or in the object's name.
  bool is_of(std::span<const std::string_view> parts) const;
};

/// One call of the function that is counted.
struct WorkCount {
  std::vector<FunctionCount> functions;
  std::uint64_t instructions() const;
  std::uint64_t instructions_of(std::span<const std::string_view> parts) const;
  std::uint64_t allocations_of(std::span<const std::string_view> parts) const;
};

/// Runs this program by `valgrind --tool=callgrind` with the arguments, which must make it call a
/// function `calls` times, and returns what each call executed. The function has C linkage; no
/// measured work is done between its calls. Throws Error with the reason if nothing can be counted.
std::vector<WorkCount> counted_calls(const std::vector<std::string>& arguments,
                                     const std::string& function, std::size_t calls);

/// Runs a command by callgrind and returns what it executed from start to end. Its output is
/// discarded. Throws Error with the reason if nothing can be counted or the command fails.
WorkCount counted_run(const std::vector<std::string>& command);

}  // namespace displayfile::bench
