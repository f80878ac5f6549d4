// A build without QPDF: no layers in PDF.

#include "clip/base/error.h"
#include "interp/vector/pdf_layers.h"

namespace displayfile {

std::string with_layers(const std::string&, std::span<const std::string>) {
  throw Error(
      "the layers of a PDF need QPDF, which this build was made without: expected .svg, or no "
      "layers and lines of no kinds");
}

bool has_pdf_layers() { return false; }

}  // namespace displayfile
