#pragma once

#include <stdexcept>
#include <string>

namespace displayfile {

/// Thrown by every routine for an invalid call; the state is then what it was before. The message
/// uses the textbook's terms.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace displayfile
