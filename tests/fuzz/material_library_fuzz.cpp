// libFuzzer target: whatever a material library holds, reading it throws nothing but Error, and
// every colour that it returns is valid.

#include <string>

#include "clip/base/error.h"
#include "displayfile/mesh/obj_materials.h"
#include "tests/fuzz/failed.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace displayfile;
  const MeshFile file{"a.mtl", std::string(reinterpret_cast<const char*>(data), size)};
  try {
    for (const auto& [name, material] : read_material_library(file)) {
      for (int part = 0; part < 3; ++part) {
        if (!material.colour) continue;
        if ((*material.colour)[part] >= 0.0 && (*material.colour)[part] <= 1.0) continue;
        fuzz::failed("'" + name + "' has a colour out of range");
      }
    }
  } catch (const Error&) {
  }
  return 0;
}
