#pragma once

namespace displayfile {

/// While it lives, messages of limits do not say what may be done instead (WorkDone, of work that
/// this thread names): for commands that have no other method.
class WithoutChoice {
 public:
  WithoutChoice() noexcept;
  ~WithoutChoice();
  WithoutChoice(const WithoutChoice&) = delete;
  WithoutChoice& operator=(const WithoutChoice&) = delete;

 private:
  bool before_;
};

}  // namespace displayfile
