#pragma once

#include <string>

#include "programs/sheet/drawing_sheet.h"

namespace displayfile {

/// The interface of the module `displayfile-dxf` (clip/base/module.h): it is compiled with dxflib,
/// which is under the GPL, and so is not part of the command.
struct DxfModule {
  const char* version;
  /// Writes the sheet in DXF of AutoCAD 2000. Throws exceptions of the standard library, whose
  /// `what` is a message; an incomplete file is not always noticed.
  void (*write)(const DrawingSheet& sheet, const std::string& path);
};

}  // namespace displayfile
