#include "programs/options/length_unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ostream>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "programs/process/warnings.h"

namespace displayfile {

namespace {

struct LengthUnit {
  const char* name;
  double millimetres;
};
constexpr std::array kUnitsOfLength{LengthUnit{"mm", 1.0}, LengthUnit{"cm", 10.0},
                                    LengthUnit{"m", 1000.0}, LengthUnit{"in", 25.4},
                                    LengthUnit{"inch", 25.4}};

}  // namespace

double millimetres_of_unit(const std::string& word) {
  const auto* const found = std::ranges::find(kUnitsOfLength, word, &LengthUnit::name);
  if (found != kUnitsOfLength.end()) return found->millimetres;
  throw Error(fmt::format("--unit {}: expected mm, cm, m or in", word));
}

void warn_of_metres(std::span<const std::string> inputs) {
  for (const std::string& input : inputs) {
    const std::string extension = extension_of(input);
    if (extension != ".gltf" && extension != ".glb") continue;
    warnings() << fmt::format(
        "{}: left out: its unit, metre: --unit m sets it, --unit mm if its numbers are "
        "millimetres\n",
        input);
  }
}

}  // namespace displayfile
