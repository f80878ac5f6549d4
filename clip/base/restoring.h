#pragma once

namespace displayfile {

/// Calls restore() after enter(), also if enter() throws.
template <class Enter, class Restore>
void restoring(const Enter& enter, const Restore& restore) {
  try {
    enter();
  } catch (...) {
    restore();
    throw;
  }
  restore();
}

}  // namespace displayfile
