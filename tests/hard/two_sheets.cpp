#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>

#include "clip/base/error.h"
#include "hard/methods.h"
#include "interp/device/picture.h"
#include "interp/device/raster_request.h"
#include "interp/files/png_file.h"
#include "interp/opengl/osmesa.h"
#include "interp/raster/software.h"
#include "interp/truth/truth.h"
#include "interp/visibility/plain_z_buffer.h"
#include "mesa_leaks.h"

// Two tilted sheets 1e-15 apart that are in front in turn: an orange one and a blue one make a
// chequerboard. Prints each method's wrong pixels, and its picture.

namespace displayfile {
namespace {

constexpr int kSquares = 11;  // along a side

struct Options {
  int size = 4096;
  double gap = 1e-15;
  std::string picture;
  int picture_size = 480;
};

double depth_of_sheet(double x, double y) { return 0.2 + 0.43 * x + 0.31 * y; }

/// A square of the chequerboard, each sheet's divided by the other diagonal; the sheet lies nearer
/// by `lift`.
void enter_square(Segment& segment, int column, int row, double lift) {
  const auto corner = [&](int i, int j) {
    const double x = 0.05 + 0.9 * (column + i) / kSquares, y = 0.05 + 0.9 * (row + j) / kSquares;
    return Point3(x, y, depth_of_sheet(x, y) + lift);
  };
  const auto enter = [&](const Point3& a, const Point3& b, const Point3& c) {
    segment.enter_polygon(std::array{a, b, c}, std::array<std::uint8_t, 3>{0, 0, 0});
  };
  if (segment.name() == 1) {
    enter(corner(0, 0), corner(1, 0), corner(1, 1));
    enter(corner(0, 0), corner(1, 1), corner(0, 1));
  } else {
    enter(corner(0, 0), corner(1, 0), corner(0, 1));
    enter(corner(1, 0), corner(1, 1), corner(0, 1));
  }
}

/// A segment and a pick identifier for each sheet, device coordinates.
DisplayFile two_sheets(double gap) {
  DisplayFile file;
  for (const int sheet : {0, 1}) {
    Segment& segment = file.create(sheet + 1);
    segment.set_style(LineStyle{LineStyle::Kind::none});
    segment.set_style(FillStyle{FillStyle::Kind::solid,
                                sheet == 0 ? Colour(0.95, 0.55, 0.15) : Colour(0.15, 0.35, 0.75)});
    segment.set_pick(sheet);
    for (int row = 0; row < kSquares; ++row) {
      for (int column = 0; column < kSquares; ++column) {
        enter_square(segment, column, row, (row + column) % 2 == sheet ? gap / 2 : -gap / 2);
      }
    }
    segment.close();
  }
  return file;
}

RasterRequest request(int size) {
  RasterRequest r;
  r.width = r.height = size;
  r.surfaces.method = HiddenMethod::z_buffer;
  r.ids = true;
  return r;
}

void print(const std::string& method, const Picture& picture, const Picture& expected) {
  const long long wrong = wrong_pixels(picture, expected);
  fmt::print("{:<32} {:>10} wrong of {} pixels\n", method, wrong, expected.ids.size());
}

/// Ours on the left, the other on the right.
void write_side_by_side(const Picture& left, const Picture& right, const std::string& file) {
  constexpr int kBetween = 16;
  Picture both;
  both.width = left.width + kBetween + right.width;
  both.height = left.height;
  const auto columns = static_cast<std::size_t>(both.width);
  both.pixels.assign(columns * static_cast<std::size_t>(both.height), 0xFFFFFFFF);
  const auto copy = [&](const Picture& from, int column) {
    const auto width = static_cast<std::size_t>(from.width);
    for (std::size_t row = 0; row < static_cast<std::size_t>(from.height); ++row) {
      std::copy_n(from.pixels.data() + row * width, width,
                  both.pixels.data() + row * columns + static_cast<std::size_t>(column));
    }
  };
  copy(left, 0);
  copy(right, left.width + kBetween);
  write_png(both, file);
}

int run(const Options& options) {
  const DisplayFile sheets = two_sheets(options.gap);
  const Picture expected = truth(sheets, options.size, options.size, false);
  const RasterRequest large = request(options.size);
  const Picture exact = draw_with_software(sheets, large);
  print("z-buffer, exact", exact, expected);
  for (const DepthFormatEntry& entry : depth_formats()) {
    print(fmt::format("plain z-buffer, {}", entry.name),
          draw_with_plain_z_buffer(sheets, large, entry.format), expected);
  }
  if (osmesa_available()) {
    OsmesaBuffers peer(sheets, large);
    print(fmt::format("OSMesa, {} depth bits", peer.depth_bits()), peer.picture(), expected);
  }
  if (!options.picture.empty()) {
    const RasterRequest small = request(options.picture_size);
    const Picture other = osmesa_available()
                              ? draw_with_osmesa(sheets, small)
                              : draw_with_plain_z_buffer(sheets, small, DepthFormat::float_64);
    write_side_by_side(draw_with_software(sheets, small), other, options.picture);
  }
  return wrong_pixels(exact, expected) == 0 ? 0 : 1;
}

}  // namespace
}  // namespace displayfile

int main(int argc, char** argv) {
  displayfile::Options options;
  CLI::App app{"Two sheets that z-fight: wrong pixels of each method against the exact truth"};
  app.add_option("--size", options.size, "pixels a side")->check(CLI::Range(1, 16384));
  app.add_option("--gap", options.gap, "between the sheets, of a depth of 1");
  app.add_option("--picture", options.picture,
                 "the exact picture and the peer's, side by side (PNG)");
  app.add_option("--picture-size", options.picture_size, "pixels a side")
      ->check(CLI::Range(1, 4096));
  CLI11_PARSE(app, argc, argv);
  try {
    return displayfile::run(options);
  } catch (const displayfile::Error& error) {
    fmt::print(stderr, "two_sheets: {}\n", error.what());
    return 2;
  }
}
