#include "displayfile/mesh/format_not_read.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
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
                                         {".iges", "an IGES file"},
                                         {".igs", "an IGES file"},
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

/// The beginning of the file, long enough for a usual STEP header.
std::string beginning_of(const std::string& path) {
  constexpr std::size_t kBytes = std::size_t{1} << 16;
  std::string beginning(kBytes, '\0');
  std::ifstream in(path, std::ios::binary);
  in.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  beginning.resize(static_cast<std::size_t>(in.gcount()));
  return beginning;
}

/// ISO 10303-21: the header's FILE_SCHEMA names the schema of the data, such as IFC2X3 for a
/// building.
bool is_building(std::string_view beginning) {
  const std::size_t schema = beginning.find("FILE_SCHEMA");
  if (schema == beginning.npos) return false;
  const std::string_view names = beginning.substr(schema);
  return names.substr(0, names.find(';')).find("IFC") != names.npos;
}

bool is_step(std::string_view extension, std::string_view beginning) {
  const bool is_named = extension == ".step" || extension == ".stp" || extension == ".p21";
  return (is_named || beginning.starts_with("ISO-10303-21;")) && !is_building(beginning);
}

}  // namespace

std::optional<std::string> format_not_read(const std::string& path) {
  const std::string extension = extension_of(path);
  if (extension == ".ifc") return std::nullopt;
  if (is_step(extension, beginning_of(path))) return "a STEP file";
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
