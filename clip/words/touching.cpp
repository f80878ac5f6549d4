#include "clip/surfaces.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <system_error>

#include "clip/base/error.h"
#include "clip/point.h"

namespace displayfile {

double entered_reach(const Touching& touching, double largest, double unit) {
  constexpr double kUnits = 8.0;
  switch (touching.kind) {
    case Touching::Kind::automatic: return kUnits * unit * largest;
    case Touching::Kind::off: return 0.0;
    case Touching::Kind::length: return touching.length;
  }
  return 0.0;
}

namespace {

bool is_in_range(const Touching& touching) {
  return touching.kind != Touching::Kind::length ||
         (touching.length > 0.0 && touching.length <= kCoordinateLimit);
}

[[noreturn]] void out_of_range(std::string_view word) {
  throw Error(fmt::format("touching {}: expected a length above 0, at most 1e100", word));
}

}  // namespace

Touching touching(std::string_view word) {
  if (word == "auto") return {Touching::Kind::automatic};
  if (word == "off") return {Touching::Kind::off};
  double length = 0.0;
  const char* const end = word.data() + word.size();
  const auto [read, error] = std::from_chars(word.data(), end, length);
  if (error != std::errc() || read != end || std::isnan(length)) {
    throw Error(fmt::format("touching {}: expected auto, off or LENGTH", word));
  }
  const Touching of_length{Touching::Kind::length, length};
  if (!is_in_range(of_length)) out_of_range(word);
  return of_length;
}

void require_touching(const Touching& touching) {
  if (!is_in_range(touching)) out_of_range(word_of(touching));
}

std::string word_of(const Touching& touching) {
  switch (touching.kind) {
    case Touching::Kind::automatic: return "auto";
    case Touching::Kind::off: return "off";
    case Touching::Kind::length: return fmt::format("{}", touching.length);
  }
  return "auto";
}

}  // namespace displayfile
