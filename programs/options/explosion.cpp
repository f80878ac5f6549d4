#include "programs/options/explosion.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <string_view>
#include <system_error>

#include "clip/base/error.h"

namespace displayfile {

Explosion explosion_of_option(const std::string& word) {
  const auto fail = [&] {
    throw Error(
        fmt::format("--explode {}: expected x, y, z, -x, -y, -z or radial, and after = a factor "
                    "above 0, at most 1000, such as z=0.5; after : the first parts along the axis, "
                    "such as z=0.5:LID,BODY",
                    word));
  };
  constexpr double kLargestFactor = 1000.0, kUsualRadial = 1.0;
  const std::size_t colon = word.find(':');
  const std::string_view spread = std::string_view(word).substr(0, colon);
  const std::size_t equals = spread.find('=');
  std::string_view direction = spread.substr(0, equals);
  Explosion explosion;
  explosion.word = word;
  for (std::size_t at = colon; at < word.size();) {
    const std::size_t begin = at + 1;
    at = std::min(word.find(',', begin), word.size());
    explosion.order.push_back(word.substr(begin, at - begin));
    if (explosion.order.back().empty()) fail();
  }
  if (direction == "radial") {
    if (!explosion.order.empty()) fail();
    explosion.factor = kUsualRadial;
  } else {
    explosion.downward = direction.starts_with('-');
    if (explosion.downward) direction.remove_prefix(1);
    if (direction.size() != 1 || direction[0] < 'x' || direction[0] > 'z') fail();
    explosion.axis = direction[0] - 'x';
  }
  if (equals == spread.npos) return explosion;
  const char* const end = spread.data() + spread.size();
  const auto [stop, failure] = std::from_chars(word.data() + equals + 1, end, explosion.factor);
  const bool is_number = failure == std::errc{} && stop == end;
  if (!is_number || !(explosion.factor > 0.0 && explosion.factor <= kLargestFactor)) fail();
  return explosion;
}

}  // namespace displayfile
