#pragma once

namespace displayfile {

/// Suppresses the alternative method in messages of limits during its lifetime (WorkDone, for work
/// named by this thread), for commands with only one method.
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
