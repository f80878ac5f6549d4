// libFuzzer target: whatever a mesh file holds, reading it throws nothing but Error; and what was
// read is drawn as the truth says. The first byte chooses the format, and whether normals are read.

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "clip/error.h"
#include "displayfile/mesh/mesh.h"
#include "interp/raster/software.h"
#include "interp/truth/truth.h"
#include "tests/fuzz/fuzz_input.h"

namespace {

using namespace displayfile;

constexpr int kSize = 16;
constexpr std::size_t kMostPolygons = 2000;

std::string written(fuzz::FuzzInput input, Shading& shading) {
  constexpr const char* kFormats[] = {"obj", "off", "ply", "stl"};
  const int kind = input.below(12);
  const char* const format = kFormats[kind % 4];
  shading = kind < 4 ? Shading::flat : kind < 8 ? Shading::gouraud : Shading::phong;
  const auto path = std::filesystem::temp_directory_path() /
                    ("mesh_fuzz." + std::to_string(::getpid()) + "." + format);
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(input.rest().data()),
             static_cast<std::streamsize>(input.rest().size()));
  return path.string();
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
    if (system.display_file().polygons() != 0) {
      std::fprintf(stderr, "a refused mesh left polygons\n");
      std::abort();
    }
    return 0;
  }
  const DisplayFile& file = system.display_file();
  if (file.polygons() > kMostPolygons) return 0;
  const RasterRequest request{
      .width = kSize, .height = kSize, .method = HiddenMethod::z_buffer, .ids = true};
  if (draw_with_software(file, request).ids != truth(file, kSize, kSize, false).ids) {
    std::fprintf(stderr, "the picture is not the truth's\n");
    std::abort();
  }
  return 0;
}
