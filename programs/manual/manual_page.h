#pragma once

#include <CLI/App.hpp>
#include <ostream>

namespace displayfile {

/// The first word of a command line that asks for a manual page: the command's own, or that of the
/// subcommand whose name follows.
inline constexpr const char* kManual = "--manual";

/// The page's name, synopsis, description, options and exit status, in the macros of man(7), as the
/// parser has them; what people write stands in a file for each page (programs/manual/README.md).
/// `command` is the app itself or one of its subcommands.
void print_manual_page(const CLI::App& app, const CLI::App& command, std::ostream& out);

}  // namespace displayfile
