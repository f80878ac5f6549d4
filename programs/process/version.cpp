#include "programs/process/version.h"

#include <fmt/format.h>

#include "displayfile/mesh/import_library.h"
#include "interp/opengl/osmesa.h"
#include "programs/manual/licence.h"

namespace displayfile {

/// Names of libraries, empty if all are there.
constexpr const char* kLeftOut = DISPLAYFILE_LEFT_OUT;

const char* version_number() { return DISPLAYFILE_VERSION; }

std::string version() {
  const std::string assimp =
      import_library_version().value_or("not found: OBJ, OFF, PLY, STL only");
  return fmt::format(
      "displayfile {}\n"
      "import library (Assimp)  {}\n"
      "OSMesa                   {}\n"
      "licence                  {}{}",
      version_number(), assimp,
      osmesa_available() ? osmesa_description() : "not found: no --device osmesa", licence_text(),
      std::string_view(kLeftOut).empty() ? ""
                                         : fmt::format("\nbuilt without            {}", kLeftOut));
}

}  // namespace displayfile
