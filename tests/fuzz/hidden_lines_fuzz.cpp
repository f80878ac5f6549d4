// libFuzzer target: for random polygons and lines, every method of lines finds the visible parts of
// the truth.

#include <string>

#include "interp/truth/judged_lines.h"
#include "tests/fuzz/failed.h"
#include "tests/fuzz/polygons_near_grid.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace displayfile;
  constexpr int kSize = 16, kMostPolygons = 12;
  const DisplayFile file = fuzz::display_file_of(
      fuzz::FuzzInput({data, size}), {kMostPolygons, kSize, LineStyle::Kind::solid, true});
  for (const HiddenMethod method :
       {HiddenMethod::roberts, HiddenMethod::appel, HiddenMethod::franklin}) {
    const JudgedLines judged = judged_lines(file, {.method = method});
    if (judged.are_right()) continue;
    fuzz::failed(std::string(name_of(method)) + ": missing " +
                 std::to_string(judged.errors.missing) + ", extra " +
                 std::to_string(judged.errors.extra));
  }
  return 0;
}
