#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace displayfile {

/// The result for one of several inputs.
struct InputResult {
  std::string text;      ///< for standard output
  std::string error;     ///< a message that names the input; empty if there was none
  std::string warnings;  ///< lines for standard error, to stand before the error
};

/// Calls work(k) once for each input, on several threads: it returns a report. An exception of one,
/// whose message gets the input's name as prefix unless it starts with it, does not stop the
/// others. `take` is called in the order of the inputs, one at a time, as early as possible. `what`
/// is shown on a terminal meanwhile.
void for_each_input(std::span<const std::string> inputs, int threads, const std::string& what,
                    const std::function<std::string(std::size_t k)>& work,
                    const std::function<void(std::size_t k, const InputResult&)>& take);

}  // namespace displayfile
