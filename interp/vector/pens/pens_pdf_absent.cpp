// A build without Cairo.

#include "clip/base/error.h"
#include "interp/vector/pens/pen_files.h"

namespace displayfile {

void write_pens_pdf(const PenDrawing&, const Destination& to, const VectorOptions&) {
  throw Error(to.name() + ": PDF needs Cairo, which this build was made without: expected .svg");
}

}  // namespace displayfile
