// A build without Cairo: no PDF and no EPS.

#include <string>

#include "clip/base/error.h"
#include "interp/vector/pdf_device.h"

namespace displayfile {

namespace {

[[noreturn]] void refuse_page(const std::string& name) {
  throw Error(name + ": PDF and EPS need Cairo, which this build was made without: expected .svg");
}

}  // namespace

void write_pdf(const DisplayFile&, int, int, const Destination& to, const Background&, bool,
               const VectorOptions&) {
  refuse_page(to.name());
}

void write_eps(const DisplayFile&, int, int, const Destination& to, const Background&, bool,
               const VectorOptions&) {
  refuse_page(to.name());
}

}  // namespace displayfile
