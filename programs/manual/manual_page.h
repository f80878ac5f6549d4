#pragma once

#include <CLI/App.hpp>
#include <ostream>

namespace displayfile {

/// The first word of a request for a manual page: the command's own, or that of the subcommand
/// named next.
inline constexpr const char* kManual = "--manual";

/// Prints the page's name, synopsis, description, options and exit status, in the macros of man(7),
/// from the parser; hand-written parts are in a file per page (programs/manual/README.md).
/// `command` is the app itself or one of its subcommands.
void print_manual_page(const CLI::App& app, const CLI::App& command, std::ostream& out);

}  // namespace displayfile
