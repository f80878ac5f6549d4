// A build without libpng: PNG files are neither read nor written.

#include "clip/error.h"
#include "interp/files/png_file.h"

namespace displayfile {

namespace {

[[noreturn]] void refuse_png(const std::filesystem::path& path) {
  throw Error(path.string() +
              ": PNG files need libpng, which this build was made without: expected .ppm");
}

}  // namespace

const bool kHasPng = false;

void write_png(const Picture&, const std::filesystem::path& path) { refuse_png(path); }

std::unique_ptr<RowFile> png_row_file(const std::filesystem::path& path, int, int) {
  refuse_png(path);
}

std::unique_ptr<RowFile> png_alpha_row_file(const std::filesystem::path& path, int, int) {
  refuse_png(path);
}

Picture read_png(const std::filesystem::path& path, Alpha) { refuse_png(path); }

}  // namespace displayfile
