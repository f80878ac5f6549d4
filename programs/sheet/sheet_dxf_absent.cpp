#include "clip/base/error.h"
#include "programs/sheet/drawing_sheet.h"

namespace displayfile {

const bool kWritesDxf = false;

void write_sheet_dxf(const DrawingSheet&, const std::string& file) {
  throw Error(file + ": this build has no dxflib, which writes DXF");
}

}  // namespace displayfile
