#include "hidden/touching.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <system_error>

#include "clip/error.h"
#include "clip/point.h"

namespace displayfile {

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
