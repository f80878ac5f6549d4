#include "programs/pick_option.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

#include "clip/error.h"
#include "interp/renderer.h"

namespace displayfile {

PickOption pick_option(std::string_view text) {
  std::array<double, 3> numbers{};
  std::size_t count = 0;
  const char *p = text.data(), *const end = p + text.size();
  bool right = true;
  while (right && count < numbers.size()) {
    const auto [after, error] = std::from_chars(p, end, numbers[count]);
    right = error == std::errc{} && std::isfinite(numbers[count]);
    ++count;
    p = after;
    if (!right || p == end) break;
    right = *p == ',';
    ++p;
  }
  if (!right || p != end || text.ends_with(',') || count < 2 ||
      !(numbers[2] >= 0.0 && numbers[2] <= kLargestSide)) {
    throw Error(fmt::format(
        "--pick {}: expected X,Y or X,Y,REACH in pixels, such as 100,200 or 100,200,3", text));
  }
  return {numbers[0], numbers[1], numbers[2]};
}

std::string picked(const GraphicsSystem& system, const PickOption& at, const DrawOptions& options) {
  const auto pick = Renderer().pick(system, at.x, at.y, options, at.reach);
  const std::string where = fmt::format("at {},{}: ", at.x, at.y);
  if (!pick) return where + "nothing\n";
  const std::string what = pick->kind == Pick::Kind::polygon ? "polygon"
                           : pick->kind == Pick::Kind::edge  ? "an edge of polygon"
                                                             : "line";
  const std::string id = pick->id >= 0 ? fmt::format(" {}", pick->id) : "";
  return where +
         fmt::format("{}{} of segment {}, depth {}\n", what, id, pick->segment, pick->depth);
}

}  // namespace displayfile
