#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace displayfile {

/// Adds the inputs of a subcommand, at least one, as words: "@FILE" reads names from a file, one
/// per line, and "@-" from standard input. An input whose own name begins with @ is "./@…".
CLI::Option& add_inputs(CLI::App& command, const char* name, std::vector<std::string>& inputs,
                        const std::string& what);

/// The files of the lists among the words, which a command reads too; "-" is standard input.
std::vector<std::string> input_lists(const std::vector<std::string>& words);

/// The names of the inputs, in order. It reads lists, which may be long or wait for a pipe: a
/// command calls it when its limits are in force. Throws Error for a list that cannot be read, is
/// empty, or holds a zero byte, and if standard input would be read twice.
std::vector<std::string> input_names(const std::vector<std::string>& words);

}  // namespace displayfile
