#pragma once

#include <CLI/App.hpp>
#include <span>
#include <string_view>

#include "programs/manual/value_name.h"

namespace displayfile {

/// Requests about the command itself on a command line: a shell's completion (completion.h), or a
/// manual page (manual_page.h).
class AskedOfItself {
 public:
  AskedOfItself(int argc, char** argv);

  bool anything() const { return completion_ || manual_; }
  /// A page of the manual holds for any machine.
  bool for_any_machine() const { return manual_; }
  /// The subcommand of the command line, for any request; empty if there is none.
  std::string_view subcommand() const;
  /// True if the request is about that subcommand's arguments.
  bool of_subcommand(const CLI::App& subcommand) const;

  /// Prints the requested text on standard output; nothing for an unknown subcommand. Requires a
  /// request.
  void tell(const CLI::App& app, std::span<const NamedValues> named) const;

 private:
  std::span<char* const> words_;  ///< after the command's name and the word of the request
  bool completion_ = false, manual_ = false;
};

}  // namespace displayfile
