#pragma once

#include <CLI/App.hpp>
#include <CLI/Formatter.hpp>
#include <string>

namespace displayfile {

/// How --help lists options: as the manual page does, in lines of at most kColumns columns.
class HelpFormat : public CLI::Formatter {
 public:
  static constexpr std::size_t kColumns = 100;

  HelpFormat();
  std::string make_option(const CLI::Option* option, bool is_positional) const override;
  std::string make_subcommand(const CLI::App* command) const override;
};

}  // namespace displayfile
