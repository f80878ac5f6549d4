#pragma once

#include <new>
#include <sstream>
#include <string>
#include <utility>

namespace displayfile {

/// Text, or bytes, that a stream collects in memory. What there is no memory for is lost: a
/// std::ostringstream would hand out what it has as if that were all, and this throws
/// std::bad_alloc when it is asked for the text.
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
