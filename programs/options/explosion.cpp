#include "programs/options/explosion.h"

#include <fmt/format.h>

#include <charconv>
#include <string_view>
#include <system_error>

#include "clip/base/error.h"

namespace displayfile {

Explosion explosion_of_option(const std::string& word) {
  const auto fail = [&] {
    throw Error(
        fmt::format("--explode {}: expected x, y, z, -x, -y, -z or radial, and after = a factor "
                    "above 0, at most 1000, such as z=0.5",
                    word));
  };
  constexpr double kLargestFactor = 1000.0, kUsualRadial = 1.0;
  const std::size_t equals = word.find('=');
  std::string_view direction = std::string_view(word).substr(0, equals);
  Explosion explosion;
  explosion.word = word;
  if (direction == "radial") {
    explosion.factor = kUsualRadial;
  } else {
    explosion.downward = direction.starts_with('-');
    if (explosion.downward) direction.remove_prefix(1);
    if (direction.size() != 1 || direction[0] < 'x' || direction[0] > 'z') fail();
    explosion.axis = direction[0] - 'x';
  }
  if (equals == std::string::npos) return explosion;
  const char* const end = word.data() + word.size();
  const auto [stop, failure] = std::from_chars(word.data() + equals + 1, end, explosion.factor);
  const bool is_number = failure == std::errc{} && stop == end;
  if (!is_number || !(explosion.factor > 0.0 && explosion.factor <= kLargestFactor)) fail();
  return explosion;
}

}  // namespace displayfile
