#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "displayfile/graphics_system.h"

// A square, among and behind which texts are written.

namespace displayfile::test {

inline constexpr std::string_view kScene =
    "set-window 0 1 0 1\n"
    "set-hidden-line-removal on\n"
    "open-segment 1\n"
    "set-line-style solid 0 .2 1\n"
    "set-fill-style solid .9 .9 .6\n"
    "polygon-abs-3 .125 .125 0  .875 .125 0  .875 .875 0  .125 .875 0\n";

/// The square with texts in its segment, after the text in `before`.
inline std::string scene_with(std::string_view texts, std::string_view before = "") {
  return fmt::format("{}{}{}close-segment\n", before, kScene, texts);
}

/// By which a text is hidden.
inline std::vector<HiddenMethod> methods_that_remove() {
  using enum HiddenMethod;
  return {automatic, z_buffer, scan_line,  scan_line_z,   ray_cast,
          warnock,   bsp,      depth_sort, plain_z_buffer};
}

}  // namespace displayfile::test
