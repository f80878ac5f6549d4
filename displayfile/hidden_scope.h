#pragma once

#include <string_view>

namespace displayfile {

/// Among which polygons hidden surfaces are sorted.
enum class HiddenScope {
  segment,  ///< the textbook's: those of one segment; segments are drawn in order of creation
  all,      ///< those of all visible segments together
};

/// Reads `segment` or `all`; throws Error for anything else.
HiddenScope hidden_scope(std::string_view text);
std::string_view name_of(HiddenScope scope);

}  // namespace displayfile
