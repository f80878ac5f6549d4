#pragma once

#include <cfenv>

namespace displayfile {

/// Makes this thread round to nearest during its lifetime, whatever mode the host has set.
/// Constructed first in each public call that computes with doubles (work_budget.h has one too),
/// and in each task of another thread, so that no result depends on the host's mode.
class RoundToNearest {
 public:
  RoundToNearest() : before_(std::fegetround()) {
    if (before_ != FE_TONEAREST) std::fesetround(FE_TONEAREST);
  }
  ~RoundToNearest() {
    if (before_ != FE_TONEAREST) std::fesetround(before_);
  }
  RoundToNearest(const RoundToNearest&) = delete;
  RoundToNearest& operator=(const RoundToNearest&) = delete;

 private:
  const int before_;
};

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
