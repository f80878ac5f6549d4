#include "displayfile/mesh/format_not_read.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "clip/base/error.h"
#include "clip/base/files.h"

namespace displayfile {

namespace {

struct OtherFormat {
  std::string_view extension, name;
};

/// Formats of programs that can export meshes.
constexpr OtherFormat kOtherFormats[] = {{".3dm", "a Rhino model"},
                                         {".catpart", "a CATIA part"},
                                         {".catproduct", "a CATIA product"},
                                         {".dgn", "a MicroStation drawing"},
                                         {".dwg", "a DWG drawing"},
                                         {".f3d", "a Fusion design"},
                                         {".fcstd", "a FreeCAD document"},
                                         {".iam", "an Inventor assembly"},
                                         {".ipt", "an Inventor part"},
                                         {".jt", "a JT file"},
                                         {".max", "a 3ds Max scene"},
                                         {".prt", "a part of a CAD program"},
                                         {".rvt", "a Revit project"},
                                         {".sat", "an ACIS file"},
                                         {".scad", "an OpenSCAD program"},
                                         {".skp", "a SketchUp model"},
                                         {".sldasm", "a SOLIDWORKS assembly"},
                                         {".sldprt", "a SOLIDWORKS part"},
                                         {".x_b", "a Parasolid file"},
                                         {".x_t", "a Parasolid file"}};

}  // namespace

std::optional<std::string> format_not_read(const std::string& path) {
  const std::string extension = extension_of(path);
  const auto* const found = std::ranges::find(kOtherFormats, extension, &OtherFormat::extension);
  if (found == std::end(kOtherFormats)) return std::nullopt;
  return std::string(found->name);
}

namespace {

constexpr std::array<std::string_view, 8> kAllowed{".amf",  ".dxf", ".fbx", ".glb",
                                                   ".gltf", ".lwo", ".raw", ".xgl"};

}  // namespace

void require_allowed_format(const std::string& path) {
  const std::string extension = extension_of(path);
  if (std::ranges::find(kAllowed, extension) != kAllowed.end()) return;
  throw Error(
      fmt::format("{}: the import library's reader is not known to be safe, and this system cannot "
                  "confine it: expected OBJ, OFF, PLY, STL or one of {}; --any-format "
                  "(ImportLimits::any_format) reads it anyway",
                  path, fmt::join(kAllowed, " ")));
}

}  // namespace displayfile
