#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace displayfile {

/// The inputs of a subcommand, which asks for at least one. On the command line "@FILE" stands for
/// the names in that file, one a line, and "@-" for those on standard input; when the line is read
/// they stand in its place. An input whose own name begins so is "./@…".
CLI::Option& add_inputs(CLI::App& command, const char* name, std::vector<std::string>& inputs,
                        const std::string& what);

/// The names that words stand for, in order. Throws Error for a list that cannot be read, is empty,
/// or holds a zero byte, and where standard input would be read twice.
std::vector<std::string> input_names(const std::vector<std::string>& words);

}  // namespace displayfile
