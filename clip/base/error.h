#pragma once

#include <stdexcept>
#include <string>

namespace displayfile {

/// Thrown by every routine when the application's call cannot be carried out.
/// The message holds the textbook's words; the state is what it was before the call.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace displayfile
