#pragma once

#include <CLI/App.hpp>
#include <cstddef>
#include <optional>
#include <string>

#include "clip/base/work_budget.h"
#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

/// The limits of a command's resources, as words (clip/base/work_budget.md).
struct WorkLimitWords {
  std::string memory;
  std::optional<double> seconds;
  std::size_t pieces = kMostPieces;

  /// Adds --limit-seconds, --limit-memory and --limit-pieces; their help has figures of this
  /// machine, or holds for any.
  void add_to(CLI::App& command, bool for_this_machine = true);
};

/// The bytes of a word: a number, optionally followed by k, M or G (1024, 1024^2 and 1024^3 bytes).
/// Throws Error, naming the option, for another word.
std::size_t bytes_of_word(const std::string& option, const std::string& word);

/// Puts the limits of a command in force during its lifetime, on its thread and those that help it:
/// by a budget, and by the system, so that they hold in any library. The process gets no more
/// memory for data; and if the work continues for a fiftieth of its time after it should have
/// stopped, the process ends, with exit status 2, the message and nothing unfinished.
class WorkLimitsInForce {
 public:
  /// Throws Error for an invalid word.
  explicit WorkLimitsInForce(const WorkLimitWords& words);
  ~WorkLimitsInForce();
  WorkLimitsInForce(const WorkLimitsInForce&) = delete;
  WorkLimitsInForce& operator=(const WorkLimitsInForce&) = delete;

 private:
  WorkBudget budget_;
  BudgetInForce in_force_;
  bool is_timed_;
};

}  // namespace displayfile
