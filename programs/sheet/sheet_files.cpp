#include <fmt/format.h>

#include "clip/base/error.h"
#include "clip/base/file_extension.h"
#include "programs/sheet/drawing_sheet.h"

namespace displayfile {

void require_sheet_file(const std::string& file) {
  const std::string extension = extension_of(file);
  if (extension == ".svg" || extension == ".pdf") return;
  if (extension != ".dxf") {
    throw Error(fmt::format("{}: expected a sheet that ends in .svg, .pdf or .dxf", file));
  }
  if (!kWritesDxf) {
    throw Error(
        fmt::format("{}: this build has no dxflib, which writes DXF: install it (Debian: "
                    "libdxflib-dev) and build again",
                    file));
  }
}

void write_sheet(const DrawingSheet& sheet, const std::string& file) {
  require_sheet_file(file);
  const std::string extension = extension_of(file);
  if (extension == ".svg") return write_sheet_svg(sheet, file);
  if (extension == ".pdf") return write_sheet_pdf(sheet, file);
  write_sheet_dxf(sheet, file);
}

}  // namespace displayfile
