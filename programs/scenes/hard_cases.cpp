#include "programs/scenes/hard_cases.h"

#include <string>

#include "clip/base/error.h"
#include "programs/scenes/families.h"

namespace displayfile {

namespace {

std::vector<HardCase> all_families() {
  std::vector<HardCase> all;
  for (const auto part : {coplanar_families, gap_families, cycle_families, crossing_families,
                          touching_families, coverage_families, degenerate_families, shape_families,
                          scale_families, view_families, contact_families}) {
    const std::vector<HardCase> of_part = part();
    all.insert(all.end(), of_part.begin(), of_part.end());
  }
  return all;
}

}  // namespace

std::span<const HardCase> hard_cases() {
  static const std::vector<HardCase> all = all_families();
  return all;
}

const HardCase& hard_case(std::string_view name) {
  for (const HardCase& family : hard_cases()) {
    if (family.name == name) return family;
  }
  throw Error("no hard case of the name " + std::string(name));
}

}  // namespace displayfile
