#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace displayfile {

/// The inputs of one picture, entered in this order. It has the name of the last.
using Figure = std::vector<std::string>;

/// Adds the inputs of a subcommand, at least one, as words: "@FILE" reads names from a file, a
/// figure per line, and "@-" from standard input. An input whose own name begins with @ is "./@…".
CLI::Option& add_inputs(CLI::App& command, const char* name, std::vector<std::string>& inputs,
                        const std::string& what);

/// The files of the lists among the words, which a command reads too; "-" is standard input.
std::vector<std::string> input_lists(const std::vector<std::string>& words);

/// Adds --with, a program that is entered before each figure.
void add_with(CLI::App& command, std::string& with);

/// The inputs of each figure. A word is one figure, and so is a line of a list. A line is one name,
/// including its blanks; or several names separated by blanks, if the whole line is not a file and
/// one of those names is. A name with blanks is then in quotation marks. Throws Error as
/// input_names does.
std::vector<Figure> input_figures(const std::vector<std::string>& words);

/// The figures with the program of --with before each; unchanged if it is empty. Throws Error if it
/// is standard input.
std::vector<Figure> with_common(const std::string& with, std::vector<Figure> figures);

/// The names of figures: of the last input of each.
std::vector<std::string> figure_names(const std::vector<Figure>& figures);

/// The inputs of all figures, in order.
std::vector<std::string> inputs_of(const std::vector<Figure>& figures);

/// The names of the inputs, in order. It reads lists, which may be long or wait for a pipe: a
/// command calls it when its limits are in force. Throws Error for a list that cannot be read, is
/// empty, or holds a zero byte, and if standard input would be read twice.
std::vector<std::string> input_names(const std::vector<std::string>& words);

}  // namespace displayfile
