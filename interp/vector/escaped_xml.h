#pragma once

#include <string>
#include <string_view>

namespace displayfile {

/// Characters as XML has them, between tags.
inline void append_escaped(std::string& out, std::string_view characters) {
  for (const char c : characters) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      default: out.push_back(c);
    }
  }
}

}  // namespace displayfile
