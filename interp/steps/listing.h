#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace displayfile {

/// One line of an algorithm's listing, in words. Code refers to lines by name, so that the numbers
/// in steps cannot drift from the text.
struct ListingLine {
  std::string_view name;  ///< for line_named; empty: no step runs the line
  int indent;
  std::string_view text;
};

/// A panel that steps show beside the picture.
struct PanelEntry {
  enum class Kind {
    list,     ///< rows of one cell, in order
    table,    ///< rows of a cell for each column
    tree,     ///< nodes, which are kept once added
    profile,  ///< segments across the picture: x from 0 to 1, and z, which grows to the viewer
    graph,    ///< segments: x from 0 to 1, and a number from 0 up in place of z
    depths,   ///< the depth of the visible fill at each pixel, which follows from the picture
  };
  std::string_view name;  ///< for panel_named
  std::string_view title;
  Kind kind;
  std::string_view columns = {};  ///< of a table, with | between
};

/// The number of the line or panel of that name; an unknown name does not compile.
template <class Entry, std::size_t n>
consteval int number_named(const std::array<Entry, n>& entries, std::string_view name) {
  for (std::size_t k = 0; k < n; ++k) {
    if (entries[k].name == name) return static_cast<int>(k);
  }
  throw "nothing has that name";
}

}  // namespace displayfile
