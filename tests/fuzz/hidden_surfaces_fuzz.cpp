// libFuzzer target: for random polygons, some concave or self-crossing, every exact method,
// including the sorts and the map, gives the truth's item buffer.

#include <string>
#include <vector>

#include "hard/methods.h"
#include "interp/truth/truth.h"
#include "tests/fuzz/failed.h"
#include "tests/fuzz/polygons_near_grid.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace displayfile;
  constexpr int kSize = 16, kMostPolygons = 24;
  static const std::vector<Method> all = methods();
  const DisplayFile file = fuzz::display_file_of(fuzz::FuzzInput({data, size}),
                                                 {kMostPolygons, kSize, LineStyle::Kind::none});
  const Picture right = truth(file, kSize, kSize, false);
  for (const Method& method : all) {
    if (!method.exact) continue;
    if (const auto wrong = wrong_pixels(method.draw(file, kSize), right); wrong > 0) {
      fuzz::failed(std::to_string(wrong) + " wrong pixels by " + method.name);
    }
  }
  return 0;
}
