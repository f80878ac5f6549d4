#pragma once

#include <CLI/App.hpp>
#include <string>

namespace displayfile {

/// `displayfile compare`: two pictures, two arrays or two dumps.
struct CompareCommand {
  std::string a, b;
  std::string marks;  ///< picture of the wrong pixels; not written if empty

  CLI::App& add_to(CLI::App& app);
  int run() const;
};

}  // namespace displayfile
