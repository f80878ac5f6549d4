#pragma once

#include <string>

#include "interp/vector/dxf/dxf_drawing.h"

namespace displayfile {

/// The interface of the module `displayfile-dxf` (clip/base/module.h): it is compiled with dxflib,
/// which is under the GPL, and so is not part of the library.
struct DxfModule {
  const char* version;
  /// Writes the drawing in DXF of AutoCAD 2000. Throws exceptions of the standard library, whose
  /// `what` is a message; an incomplete file is not always noticed.
  void (*write)(const DxfDrawing& drawing, const std::string& path);
};

}  // namespace displayfile
