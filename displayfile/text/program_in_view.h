#pragma once

#include <string>
#include <string_view>

#include "clip/view.h"

namespace displayfile {

/// A drawing program in another view: its user routines that set the view are left out, and those
/// that set this one come before all others. So all its segments are drawn in one view. The window
/// is taken as it is (stretch), whatever the picture's shape. Lines that are not understood stay,
/// for whoever replays it.
std::string program_in_view(std::string_view program, const View& view);

}  // namespace displayfile
