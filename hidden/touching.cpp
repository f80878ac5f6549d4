#include "hidden/touching.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <system_error>

#include "clip/error.h"
#include "clip/point.h"

namespace displayfile {

double entered_reach(const Touching& touching, double largest) {
  constexpr double kUnits = 8.0, kDouble = 0x1p-52;  // of double precision
  switch (touching.kind) {
    case Touching::Kind::automatic: return kUnits * kDouble * largest;
    case Touching::Kind::off: return 0.0;
    case Touching::Kind::length: return touching.length;
  }
  return 0.0;
}

Touching touching(std::string_view word) {
  if (word == "auto") return {Touching::Kind::automatic};
  if (word == "off") return {Touching::Kind::off};
  double length = 0.0;
  const char* const end = word.data() + word.size();
  const auto [read, error] = std::from_chars(word.data(), end, length);
  if (error != std::errc() || read != end || std::isnan(length)) {
    throw Error(fmt::format("touching {}: expected auto, off or LENGTH", word));
  }
  if (!(length > 0.0 && length <= kCoordinateLimit)) {
    throw Error(fmt::format("touching {}: expected a length above 0, at most 1e100", word));
  }
  return {Touching::Kind::length, length};
}

}  // namespace displayfile
