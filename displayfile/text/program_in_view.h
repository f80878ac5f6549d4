#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "clip/view.h"

namespace displayfile {

/// A drawing program in another view: routines that set the view are removed, and those that set
/// this view precede all others, so that all its segments are drawn in one view. The window is
/// stretched to the picture. Lines that are not understood are kept, for the caller that replays
/// it.
std::string program_in_view(std::string_view program, const View& view);
/// The same with the view of each segment that it opens, by its name.
std::string program_in_views(std::string_view program,
                             const std::function<const View&(int segment)>& view_of);

}  // namespace displayfile
