#pragma once

#include <Standard_Handle.hxx>
#include <TDocStd_Document.hxx>
#include <string>
#include <vector>

#include "displayfile/mesh/cad_format.h"

namespace displayfile {

/// The shapes of a file as OpenCASCADE reads them: parts, instances, names and colours, with
/// lengths in the file's unit.
struct CadDocument {
  opencascade::handle<TDocStd_Document> shapes;
  std::vector<std::string> warnings;  ///< about contents that were not read, one sentence each
  double resolution = 0.0;            ///< IGES: within which its points coincide, in its unit
};

/// Throws Error, naming the file: invalid syntax, it ends too early, or nothing in it is a shape.
CadDocument read_cad_document(const std::string& path, CadFormat format);

/// Makes the library's tables of both formats.
void load_cad_readers();

}  // namespace displayfile
