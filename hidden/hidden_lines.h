#pragma once

#include <string_view>

namespace displayfile {

/// What becomes of lines where they are hidden.
enum class HiddenLines {
  none,    ///< they are not drawn
  dashed,  ///< they are drawn dashed, before the visible ones (hidden/lines/hidden_pieces.md)
};

/// Reads `none` or `dashed`; throws Error for anything else.
HiddenLines hidden_lines(std::string_view text);
std::string_view name_of(HiddenLines lines);

}  // namespace displayfile
