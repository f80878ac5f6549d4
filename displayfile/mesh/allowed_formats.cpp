#include "displayfile/mesh/allowed_formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "clip/base/error.h"
#include "clip/base/file_extension.h"

namespace displayfile {

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
