#include "interp/vector/pens/dashes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace displayfile {

std::vector<Stroke> dashes(const std::vector<PenPath>& paths, double drawn, double left_out) {
  const bool whole = !(drawn + left_out >= kShortestDashes) || !(left_out > 0.0);
  std::vector<Stroke> strokes;
  for (const PenPath& path : paths) {
    bool draws = true;
    double rest = drawn;  // of the dash or gap
    const std::size_t n = path.points.size();
    if (n == 1) strokes.push_back({path.points[0], path.points[0]});
    for (std::size_t i = 1; i < n + (path.closed ? 1 : 0); ++i) {
      const SheetPoint &from = path.points[i - 1], &to = path.points[i % n];
      if (whole) {
        strokes.push_back({from, to});
        continue;
      }
      const double length = std::sqrt(static_cast<double>(squared_distance(from, to)));
      const auto at = [&](double along) {
        const double share = along / length;
        return SheetPoint{static_cast<std::int32_t>(std::lround(from.x + share * (to.x - from.x))),
                          static_cast<std::int32_t>(std::lround(from.y + share * (to.y - from.y)))};
      };
      double along = 0.0;
      SheetPoint here = from;
      while (along < length) {
        const bool goes_on = rest > length - along;  // round the corner
        const double end = goes_on ? length : std::min(along + rest, length);
        const SheetPoint there = end == length ? to : at(end);
        if (draws && here != there) strokes.push_back({here, there});
        if (goes_on) rest -= length - along;
        along = end;
        here = there;
        if (goes_on) continue;
        draws = !draws;
        rest = draws ? drawn : left_out;
      }
    }
  }
  return strokes;
}

}  // namespace displayfile
