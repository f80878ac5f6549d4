// libFuzzer target: for a surface over a small grid, seen from anywhere, the perimeter method finds
// the visible parts of the truth, or throws Error.

#include <string>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/graphics_system.h"
#include "interp/truth/judged_lines.h"
#include "tests/fuzz/failed.h"
#include "tests/fuzz/fuzz_input.h"

namespace {

using namespace displayfile;

/// Heights and the eye are near grids, so that curves lie in line with it.
void enter_surface(fuzz::FuzzInput input, GraphicsSystem& system) {
  const int grid = 1 + input.below(8), nx = 2 + input.below(6), ny = 2 + input.below(6);
  const Point3 eye = input.point_near_grid(grid) * 8.0;
  system.set_view_up({0.0, 0.0, 1.0});
  system.set_view_plane_normal(-eye);
  if (input.below(2) == 0) {
    system.set_parallel(-eye);
  } else {
    system.set_perspective(eye);
  }
  system.set_window(-30, 30, -30, 30);
  std::vector<double> heights;
  for (int k = 0; k < nx * ny; ++k) heights.push_back(input.near_grid(grid));
  system.open_segment(1);
  system.surface_3({-1.0, 1.0, nx, -1.0, 1.0, ny, heights});
  system.close_segment();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  GraphicsSystem system;
  JudgedLines judged;
  try {
    enter_surface(fuzz::FuzzInput({data, size}), system);
    judged = judged_lines(system.display_file(), {.method = HiddenMethod::perimeter});
  } catch (const Error&) {
    return 0;  // no direction to look in, or some of it behind the eye
  }
  const double wrong = judged.errors.missing + judged.errors.extra;
  if (wrong > kLineCrumb * static_cast<double>(judged.lines)) {
    fuzz::failed("missing " + std::to_string(judged.errors.missing) + ", extra " +
                 std::to_string(judged.errors.extra));
  }
  return 0;
}
