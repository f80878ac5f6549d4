// A build without Cairo: no PDF and no EPS.

#include "clip/error.h"
#include "interp/vector/pdf_device.h"

namespace displayfile {

namespace {

[[noreturn]] void refuse_page(const std::filesystem::path& path) {
  throw Error(path.string() +
              ": PDF and EPS need Cairo, which this build was made without: expected .svg");
}

}  // namespace

void write_pdf(const DisplayFile&, int, int, const std::filesystem::path& path, const Background&,
               bool, const VectorOptions&) {
  refuse_page(path);
}

void write_eps(const DisplayFile&, int, int, const std::filesystem::path& path, const Background&,
               bool, const VectorOptions&) {
  refuse_page(path);
}

}  // namespace displayfile
