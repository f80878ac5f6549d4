// libFuzzer target: whatever a PNG, PPM or NPY file holds, reading it throws nothing but Error; and
// the picture is the same when written and read again. The first byte chooses the format.

#include <string>
#include <variant>

#include "clip/base/error.h"
#include "interp/files/npy_file.h"
#include "interp/files/png_file.h"
#include "interp/files/ppm_file.h"
#include "tests/fuzz/failed.h"
#include "tests/fuzz/fuzz_input.h"
#include "tests/fuzz/written_file.h"

namespace {

using namespace displayfile;

bool are_equal(const Picture& a, const Picture& b) {
  return a.width == b.width && a.height == b.height && a.pixels == b.pixels;
}

void read_array(const std::string& path) {
  const NpyArray array = read_npy(path);
  const auto write = [&](const auto& values) {
    write_npy(values, array.width, array.height, path);
    const NpyArray again = read_npy(path);
    const auto* const same = std::get_if<std::decay_t<decltype(values)>>(&again.values);
    if (same == nullptr || same->size() != values.size()) fuzz::failed("another array came back");
    for (std::size_t k = 0; k < values.size(); ++k) {
      const bool are_nan = values[k] != values[k] && (*same)[k] != (*same)[k];
      if (!are_nan && values[k] != (*same)[k]) fuzz::failed("another value came back");
    }
  };
  std::visit(write, array.values);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::FuzzInput input({data, size});
  constexpr const char* kFormats[] = {"png", "ppm", "npy"};
  const int format = input.below(3);
  const std::string path = fuzz::written_file(input.rest(), kFormats[format]);
  try {
    if (format == 2) {
      read_array(path);
      return 0;
    }
    const Picture picture = format == 0 ? read_png(path) : read_ppm(path);
    format == 0 ? write_png(picture, path) : write_ppm(picture, path);
    if (!are_equal(format == 0 ? read_png(path) : read_ppm(path), picture)) {
      fuzz::failed("another picture came back");
    }
  } catch (const Error&) {
  }
  return 0;
}
