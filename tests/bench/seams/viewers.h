#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "interp/device/picture.h"

namespace displayfile::bench {

/// A program that draws vectors into pixels.
struct Viewer {
  std::string name, program;
  std::string format;  ///< the extension of what it draws
  bool is_browser = false;
  std::vector<std::string> (*command)(const std::filesystem::path& file, double scale, int side,
                                      const std::filesystem::path& png);
};

/// Those that are installed.
std::vector<Viewer> installed_viewers();

/// The picture of `side` x `side` pixels at scale 1 as the viewer shows it. Throws Error if it
/// fails.
Picture seen_in(const Viewer& viewer, const std::filesystem::path& file, double scale, int side);

}  // namespace displayfile::bench
