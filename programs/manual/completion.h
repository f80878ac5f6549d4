#pragma once

#include <CLI/App.hpp>
#include <ostream>
#include <span>
#include <string>

#include "programs/manual/value_name.h"

namespace displayfile {

/// The first word of a shell's completion request; the words typed so far follow, the last of which
/// is being typed and may be empty.
inline constexpr const char* kComplete = "--complete";

/// Prints the candidates for the last word, one a line, each with a description after a tab. Lines
/// that begin with a colon tell the shell which names to find by itself, or more of the candidates:
///   :files [EXT...]  files, of these extensions, or any
///   :folders         folders
///   :more            a candidate is not the end of its word
void print_completions(const CLI::App& app, std::span<const std::string> words,
                       std::span<const NamedValues> named, std::ostream& out);

}  // namespace displayfile
