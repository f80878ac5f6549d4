// A build without libpng: PNG files are neither read nor written.

#include <string>

#include "clip/base/error.h"
#include "interp/files/png_file.h"

namespace displayfile {

namespace {

[[noreturn]] void refuse_png(const std::string& name) {
  throw Error(name + ": PNG files need libpng, which this build was made without: expected .ppm");
}

}  // namespace

const bool kHasPng = false;

void write_png(const Picture&, const Destination& to) { refuse_png(to.name()); }

std::unique_ptr<RowFile> png_row_file(const Destination& to, int, int) { refuse_png(to.name()); }

std::unique_ptr<RowFile> png_alpha_row_file(const Destination& to, int, int) {
  refuse_png(to.name());
}

std::unique_ptr<RowFile> png_row_file_at(const Destination& to, int, int, Alpha,
                                         std::optional<double>) {
  refuse_png(to.name());
}

Picture read_png(const std::filesystem::path& path, Alpha) { refuse_png(path.string()); }

}  // namespace displayfile
