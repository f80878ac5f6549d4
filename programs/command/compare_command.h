#pragma once

#include <CLI/App.hpp>
#include <string>

#include "programs/options/picture_tolerance.h"

namespace displayfile {

/// `displayfile compare`: two pictures, two arrays or two dumps.
struct CompareCommand {
  std::string a, b;
  std::string marks;  ///< picture of the wrong pixels; not written if empty

  PictureTolerance tolerance;

  CLI::App& add_to(CLI::App& app);
  int run() const;
};

}  // namespace displayfile
