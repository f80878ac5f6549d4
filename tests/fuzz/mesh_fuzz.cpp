// libFuzzer target: whatever a mesh file holds, reading it throws nothing but Error; and the mesh
// is drawn as the truth. The first byte chooses the format, and whether normals are read.

#include <string>

#include "clip/base/error.h"
#include "displayfile/graphics_system.h"
#include "displayfile/mesh/mesh.h"
#include "interp/device/raster_request.h"
#include "interp/raster/software.h"
#include "interp/truth/truth.h"
#include "tests/fuzz/failed.h"
#include "tests/fuzz/fuzz_input.h"
#include "tests/fuzz/written_file.h"

namespace {

using namespace displayfile;

constexpr int kSize = 16;
constexpr std::size_t kMostPolygons = 2000;

std::string written(fuzz::FuzzInput input, Shading& shading) {
  constexpr const char* kFormats[] = {"obj", "off", "ply", "stl"};
  const int kind = input.below(12);
  shading = kind < 4 ? Shading::flat : kind < 8 ? Shading::gouraud : Shading::phong;
  return fuzz::written_file(input.rest(), kFormats[kind % 4]);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Shading shading{};
  const std::string path = written(fuzz::FuzzInput({data, size}), shading);
  GraphicsSystem system;
  system.set_shading(shading);
  try {
    import_mesh(path, system);
  } catch (const Error&) {
    if (system.display_file().polygons() != 0) fuzz::failed("a refused mesh left polygons");
    return 0;
  }
  const DisplayFile& file = system.display_file();
  if (file.polygons() > kMostPolygons) return 0;
  const RasterRequest request{
      .width = kSize, .height = kSize, .surfaces = {.method = HiddenMethod::z_buffer}, .ids = true};
  if (draw_with_software(file, request).ids != truth(file, kSize, kSize, false).ids) {
    fuzz::failed("the picture is not the truth's");
  }
  return 0;
}
