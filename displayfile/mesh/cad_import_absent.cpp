#include <fmt/format.h>

#include "clip/base/error.h"
#include "displayfile/mesh/cad_format.h"
#include "displayfile/mesh/cad_import.h"

namespace displayfile {

Mesh read_by_cad_process(const std::string& path, bool, const ImportLimits&) {
  const CadFormat format = cad_format(path).value_or(CadFormat::step);
  throw Error(fmt::format(
      "{}: {} {} file, which this build does not read: it has no OpenCASCADE (Debian: install "
      "libocct-data-exchange-dev and build again); or export it as STL, OBJ, PLY or glTF",
      path, format == CadFormat::step ? "a" : "an", name_of(format)));
}

std::vector<std::string> cad_extensions_read() { return {}; }

}  // namespace displayfile
