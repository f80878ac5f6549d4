#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "displayfile/graphics_system.h"

namespace displayfile {

/// Makes the names of a drawing program's segments its own, before it is replayed after other
/// inputs: segments of these that have the name of one that it opens get the next name after all
/// names in use. Those that it deletes or renames itself before it opens their name keep it.
/// Returns old and new names.
std::vector<std::pair<int, int>> make_room_for_names(std::string_view program,
                                                     GraphicsSystem& system);

/// Replays a drawing program after other inputs, with segment names of its own. Throws as replay
/// does.
void replay_beside(std::string_view program, std::string_view file_name, GraphicsSystem& system);

}  // namespace displayfile
