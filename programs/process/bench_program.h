#pragma once

#include <CLI/CLI.hpp>

namespace displayfile {

/// The subcommand `bench` for the command's own --help. What follows it on the command line is for
/// the program beside the command, displayfile-bench, which carries the peers that it measures and
/// counts memory: the command need not load them, nor have its memory counted.
/// In the --help of the command and of the program.
inline constexpr const char* kBenchDescription =
    "Speed against error of every method: a table, JSON, and a page with plots";

CLI::App& add_bench(CLI::App& app);

/// That program in this one's place, in the same process, with the same command line; it stands
/// beside this one, as built, or where it was installed. Throws Error if it cannot be started.
[[noreturn]] void start_bench(char** argv);

}  // namespace displayfile
