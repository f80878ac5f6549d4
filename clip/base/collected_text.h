#pragma once

#include <new>
#include <sstream>
#include <string>
#include <utility>

namespace displayfile {

/// Text or bytes collected in memory by a stream. If memory runs out, reading the text throws
/// std::bad_alloc; a std::ostringstream would return the truncated text.
class CollectedText : public std::ostringstream {
 public:
  void require_whole() const {
    if (fail()) throw std::bad_alloc();
  }
  std::string str() const& {
    require_whole();
    return std::ostringstream::str();
  }
  std::string str() && {
    require_whole();
    return static_cast<std::ostringstream&&>(*this).str();
  }
};

}  // namespace displayfile
