#include "clip/base/work_budget.h"

#include <fmt/format.h>

#include <cfenv>
#include <chrono>
#include <exception>
#include <string>
#include <utility>

#include "clip/base/budgeted_work.h"

namespace displayfile {

namespace {

thread_local WorkInForce in_force;
thread_local WorkDone left;
thread_local bool has_choice = true;

/// Throws LimitReached; the message begins with the current work and ends with an alternative
/// method.
[[noreturn]] void fail(const std::string& reached, const char* limit) {
  const auto& [what, instead] = in_force.done;
  throw LimitReached(fmt::format(
      "{}{}: expected a higher limit of {}{}{}", what == nullptr ? "" : std::string(what) + ": ",
      reached, limit, instead == nullptr ? "" : ", or ", instead == nullptr ? "" : instead));
}

std::int64_t steady_nanoseconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
}

/// Returns the thread's previous rounding mode.
int round_to_nearest() {
  const int before = std::fegetround();
  if (before != FE_TONEAREST) std::fesetround(FE_TONEAREST);
  return before;
}

}  // namespace

// ---- The budget ---------------------------------------------------------------------------------

void WorkBudget::start() {
  started_ = steady_nanoseconds();
  comparisons_.store(0);
  stopped_.store(false);
}

void WorkBudget::start(const WorkLimits& limits) {
  limits_ = limits;
  start();
}

double WorkBudget::seconds() const {
  return static_cast<double>(steady_nanoseconds() - started_) * 1e-9;
}

void WorkBudget::ask(std::uint64_t more_comparisons) {
  const std::uint64_t compared =
      comparisons_.fetch_add(more_comparisons, std::memory_order_relaxed) + more_comparisons;
  if (is_stopped()) {
    const char* const what = in_force.done.what;
    throw LimitReached(
        fmt::format("{}stopped on request", what == nullptr ? "" : std::string(what) + ": "));
  }
  if (compared > limits_.comparisons) {
    fail(fmt::format("{} comparisons are not enough, {} were made", limits_.comparisons, compared),
         "comparisons");
  }
  if (limits_.seconds == std::numeric_limits<double>::infinity()) return;
  if (const double passed = seconds(); passed > limits_.seconds) {
    fail(fmt::format("{} seconds are not enough, {:.3g} have passed", limits_.seconds, passed),
         "seconds");
  }
}

void WorkBudget::require_pieces(std::uint64_t pieces) const {
  if (pieces <= limits_.pieces) return;
  fail(fmt::format("{} pieces are not enough", limits_.pieces), "pieces");
}

void WorkBudget::require_bytes(std::uint64_t bytes) const {
  if (bytes <= limits_.bytes) return;
  fail(fmt::format("{} bytes of memory are not enough, {} are needed at least", limits_.bytes,
                   bytes),
       "memory");
}

// ---- The budget in force ------------------------------------------------------------------------

WorkInForce work_in_force() noexcept { return in_force; }

BudgetInForce::BudgetInForce(WorkBudget* budget) noexcept
    : before_(in_force), rounding_before_(round_to_nearest()) {
  NamedWork::begin_other();
  if (budget != nullptr) in_force.budget = budget;
}
BudgetInForce::BudgetInForce(const WorkInForce& as_on_another_thread) noexcept
    : before_(std::exchange(in_force, as_on_another_thread)),
      rounding_before_(round_to_nearest()) {}
BudgetInForce::~BudgetInForce() {
  in_force = before_;
  if (rounding_before_ != FE_TONEAREST) std::fesetround(rounding_before_);
}

WithoutChoice::WithoutChoice() noexcept : before_(std::exchange(has_choice, false)) {}
WithoutChoice::~WithoutChoice() { has_choice = before_; }

NamedWork::NamedWork(const WorkDone& done) noexcept : before_(std::exchange(in_force.done, done)) {
  begin_other();
  if (!has_choice) in_force.done.instead = nullptr;
}
NamedWork::~NamedWork() {
  if (std::uncaught_exceptions() > 0 && left.what == nullptr) left = in_force.done;
  in_force.done = before_;
}

WorkDone NamedWork::left_by_exception() noexcept { return std::exchange(left, {}); }

void NamedWork::begin_other() noexcept {
  if (std::uncaught_exceptions() == 0) left = {};
}

void ask_budget() {
  if (in_force.budget != nullptr) in_force.budget->ask();
}

void PieceCount::add(std::uint64_t more) {
  const WorkBudget* const budget = in_force.budget;
  if (budget == nullptr) return;
  const std::uint64_t pieces = pieces_.fetch_add(more, std::memory_order_relaxed) + more;
  if (pieces > allowed_) budget->require_pieces(pieces);
  budget->require_bytes(pieces * bytes_of_piece_);
}

void WorkSteps::ask() {
  left_ = kAtATime;
  if (in_force.budget != nullptr) in_force.budget->ask(kAtATime);
}

void RowsPainted::ask() {
  left_ = kAtATime;
  ask_budget();
}

void WorkSteps::ask_of(std::size_t steps) {
  const std::size_t all = kAtATime - left_ + steps;
  left_ = kAtATime;
  if (in_force.budget != nullptr) in_force.budget->ask(all);
}

}  // namespace displayfile
