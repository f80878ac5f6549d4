// libFuzzer target: of random polygons, concave and crossing as they come, every exact method, the
// BSP sort among them, gives the truth's item buffer.

#include <cstdio>
#include <cstdlib>
#include <vector>

#include "hard/methods.h"
#include "interp/truth/truth.h"
#include "tests/fuzz/fuzz_input.h"

namespace {

using namespace displayfile;

constexpr int kSize = 16, kMostPolygons = 24;

DisplayFile file_of(fuzz::FuzzInput input) {
  constexpr int kGrids[] = {4, 8, 2 * kSize, 7, 10, 64};  // every second of 2 * kSize is a centre
  DisplayFile file;
  Segment* segment = nullptr;
  int grid = 4;
  for (int k = 0; k < kMostPolygons && !input.empty(); ++k) {
    const int kind = input.byte();
    if (segment == nullptr || kind % 16 == 0) {
      segment = &file.create(k + 1);
      segment->set_style(LineStyle{LineStyle::Kind::none});
    }
    if (kind % 4 == 0) grid = kGrids[static_cast<std::size_t>(input.below(6))];
    segment->set_style(FillStyle{kind >= 240 ? FillStyle::Kind::hollow : FillStyle::Kind::solid});
    segment->set_pick(k);
    std::vector<Point3> vertices;
    for (int sides = 3 + input.below(5); sides > 0; --sides) {
      vertices.push_back(input.point_near_grid(grid));
    }
    segment->enter_polygon(vertices, std::vector<std::uint8_t>(vertices.size(), 1));
  }
  return file;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::vector<Method> all = methods();
  const DisplayFile file = file_of(fuzz::FuzzInput({data, size}));
  const Picture right = truth(file, kSize, kSize, false);
  for (const Method& method : all) {
    if (!method.exact) continue;
    if (const auto wrong = wrong_pixels(method.draw(file, kSize), right); wrong > 0) {
      std::fprintf(stderr, "%lld wrong pixels by %s\n", wrong, method.name.c_str());
      std::abort();
    }
  }
  return 0;
}
