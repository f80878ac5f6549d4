#include "hidden/exact/precision.h"

#include <algorithm>
#include <charconv>
#include <string>

#include "clip/error.h"

namespace displayfile {

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

Roundoff Roundoff::relative(const Definitions& all, double part) {
  if (all.points.empty()) return {all, 0.0};
  Point3 low = all.points.front(), high = low;
  for (const Point3& p : all.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Point3 size = high - low;
  return {all, part * std::max({size.x, size.y, size.z})};
}

}  // namespace displayfile
