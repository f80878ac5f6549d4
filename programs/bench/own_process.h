#pragma once

#include <string>
#include <vector>

namespace displayfile::bench {

/// What a command prints; its messages go where ours go. `variable`, NAME=VALUE, is added to its
/// environment. Throws Error if it cannot be started, or does not end with 0.
std::string output_of(std::vector<std::string> command, const std::string& variable);

}  // namespace displayfile::bench
