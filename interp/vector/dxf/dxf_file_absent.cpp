// A build without dxflib: no DXF.

#include "clip/base/error.h"
#include "interp/vector/dxf/dxf_drawing.h"

namespace displayfile {

const bool kWritesDxf = false;

void write_dxf(const DxfDrawing&, const Destination& to) {
  throw Error(to.name() +
              ": DXF needs dxflib (Debian: libdxflib-dev), which this build was made without");
}

}  // namespace displayfile
