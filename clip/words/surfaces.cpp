#include "clip/surfaces.h"

#include <fmt/format.h>

#include <charconv>
#include <system_error>

#include "clip/base/error.h"
#include "clip/base/words.h"

namespace displayfile {

namespace {

constexpr Word<HiddenScope> kScopes[] = {{HiddenScope::segment, "segment"},
                                         {HiddenScope::all, "all"}};
constexpr Word<HiddenLines> kHiddenLines[] = {{HiddenLines::none, "none"},
                                              {HiddenLines::dashed, "dashed"}};
constexpr Word<LineOrder> kLineOrders[] = {{LineOrder::entry, "entry"},
                                           {LineOrder::depth, "depth"}};

}  // namespace

HiddenScope hidden_scope(std::string_view text) {
  return value_of(kScopes, text, "the scope of hidden surfaces is");
}
std::string_view name_of(HiddenScope scope) { return word_of(kScopes, scope); }

HiddenLines hidden_lines(std::string_view text) {
  return value_of(kHiddenLines, text, "hidden lines are");
}
std::string_view name_of(HiddenLines lines) { return word_of(kHiddenLines, lines); }

LineOrder line_order(std::string_view text) {
  return value_of(kLineOrders, text, "the order of lines is");
}
std::string_view name_of(LineOrder order) { return word_of(kLineOrders, order); }

void require_line_halo(double halo) {
  if (halo >= 0.0 && halo <= kWidestHalo) return;
  throw Error(fmt::format("a line halo of {}: expected 0 to {} pixels", halo, kWidestHalo));
}

Precision precision(std::string_view text) {
  constexpr std::string_view kWithValue = "roundoff=";
  if (text == "exact") return {};
  if (text == "roundoff") return {.exact = false};
  Precision wanted{.exact = false};
  if (text.starts_with(kWithValue)) {
    const char* const end = text.data() + text.size();
    const auto [stop, failure] =
        std::from_chars(text.data() + kWithValue.size(), end, wanted.roundoff);
    const bool good =
        failure == std::errc() && stop == end && wanted.roundoff >= 0.0 && wanted.roundoff < 1.0;
    if (good) return wanted;
  }
  throw Error("the precision is exact, roundoff or roundoff=EPS with 0 <= EPS < 1, not '" +
              std::string(text) + "'");
}

std::string word_of(const Precision& precision) {
  return precision.exact ? "exact" : fmt::format("roundoff={}", precision.roundoff);
}

RootChoice root_choice(std::string_view name) {
  if (name == "last") return RootChoice::last;
  if (name == "first") return RootChoice::first;
  if (name == "sample") return RootChoice::sample;
  if (name == "free") return RootChoice::free;
  throw Error("root '" + std::string(name) +
              "' of a BSP tree: expected last, first, sample or free");
}

}  // namespace displayfile
