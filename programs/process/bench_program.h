#pragma once

#include <CLI/CLI.hpp>

namespace displayfile {

/// The subcommand `bench` in the command's own --help. Its arguments are passed to the separate
/// program displayfile-bench, which contains the peers that it measures and counts memory: the
/// command need not load them, nor have its memory counted. Used in the --help of both.
inline constexpr const char* kBenchDescription =
    "Speed against error of every method: a table, JSON, and a page with plots";

CLI::App& add_bench(CLI::App& app);

/// Replaces this process by that program, with the same command line; it is searched for beside
/// this one, as built, or where it was installed. Throws Error if it cannot be started.
[[noreturn]] void start_bench(char** argv);

}  // namespace displayfile
