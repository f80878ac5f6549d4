// A build without Cairo.

#include "clip/base/error.h"
#include "programs/sheet/drawing_sheet.h"

namespace displayfile {

void write_sheet_pdf(const DrawingSheet&, const std::string& file) {
  throw Error(file + ": PDF needs Cairo, which this build was made without: expected .svg");
}

}  // namespace displayfile
