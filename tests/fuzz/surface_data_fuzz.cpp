// libFuzzer target: whatever an expression or a text of heights holds, reading it throws nothing
// but Error; and a surface read from it can be entered and recorded. The first byte chooses.

#include <sstream>
#include <string>

#include "clip/base/error.h"
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "programs/surface/surface_data.h"
#include "tests/fuzz/failed.h"
#include "tests/fuzz/fuzz_input.h"
#include "tests/fuzz/written_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace displayfile;
  constexpr int kPoints = 5;
  fuzz::FuzzInput input({data, size});
  const bool is_text = input.below(2) == 0;
  const auto bytes = input.rest();
  const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (!is_text && is_grid_file(text)) return 0;  // another file's name
  const GridRange range{-1.0, 1.0, kPoints, -2.0, 2.0, kPoints};
  GraphicsSystem system;
  std::ostringstream recording;
  Recorder recorder(recording);
  system.set_recorder(&recorder);
  system.open_segment(1);
  try {
    const SurfaceData surface =
        read_surface(is_text ? fuzz::written_file(bytes, "txt") : text, range);
    if (surface.heights.size() != surface.range.points()) fuzz::failed("not a height a point");
    system.surface_3(surface.grid());
  } catch (const Error&) {
  }
  system.close_segment();
  return 0;
}
