#pragma once

#include <regex>
#include <string>

// SVG files whose names do not end in the file's key (interp/vector/file_key.h).

namespace displayfile::test {

inline std::string without_keys(std::string svg) {
  std::smatch found;
  if (!std::regex_search(svg, found, std::regex(" (?:id|class)=\"[^\" ]*(-[0-9a-z]{7})[\" ]"))) {
    return svg;
  }
  const std::string key = found[1];
  for (std::size_t at = svg.find(key); at != svg.npos; at = svg.find(key, at)) {
    svg.erase(at, key.size());
  }
  return svg;
}

}  // namespace displayfile::test
