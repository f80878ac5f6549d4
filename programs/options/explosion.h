#pragma once

#include <optional>
#include <string>
#include <vector>

namespace displayfile {

/// An exploded view, as --explode sets it.
struct Explosion {
  /// 0 to 2: parts are moved along x, y or z; none: away from the middle of all.
  std::optional<int> axis;
  bool downward = false;  ///< along the axis toward its negative end
  double factor = 0.5;
  std::vector<std::string> order;  ///< names of parts that come first along the axis
  std::string word;                ///< of the option, for messages
};

/// Reads x, y, z, -x, -y, -z or radial, after = a number above 0, at most 1000, and, for an axis,
/// after : names of parts, with commas between them. Without a number the factor is 0.5 along an
/// axis, and 1 for radial. Throws Error, naming --explode, for anything else.
Explosion explosion_of_option(const std::string& word);

}  // namespace displayfile
