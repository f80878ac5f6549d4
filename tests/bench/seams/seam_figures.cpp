// Writes a tiling of pieces that do not overlap, by our own devices, in one of several ways:
//   seam_figures one-path|overlaid|butted|stroked|trapped svg|pdf|eps OUTPUT <TILING
// A tiling is words: the picture's side in pixels, 1 if pieces of one colour are elements of their
// own and else 0, and for each piece its number of corners, its colour as red, green and blue from
// 0 to 1, and its corners' x and y in normalised device coordinates.

#include <fstream>
#include <iostream>
#include <string>

#include "interp/vector/pdf_device.h"
#include "interp/vector/svg_device.h"
#include "programs/process/exit_status.h"

namespace displayfile::bench {
namespace {

struct Tile {
  std::vector<Point3> vertices;
  Colour colour;
};

struct Tiling {
  int side = 0;
  bool apart = false;
  std::vector<Tile> tiles;
};

Tiling read(std::istream& in) {
  Tiling tiling;
  in >> tiling.side >> tiling.apart;
  Colour colour;
  for (std::size_t corners = 0; in >> corners >> colour.r >> colour.g >> colour.b;) {
    Tile tile{std::vector<Point3>(corners, Point3(0.5)), colour};
    for (Point3& p : tile.vertices) in >> p.x >> p.y;
    tiling.tiles.push_back(std::move(tile));
  }
  return tiling;
}

void hand_over(const std::vector<Tile>& tiles, VectorDevice& device) {
  const LineStyle none{LineStyle::Kind::none};
  std::int32_t pick = 0;
  for (const Tile& tile : tiles) {
    const std::vector<std::int32_t> sides(tile.vertices.size(), 0);
    device.fill({tile.vertices, sides, {FillStyle::Kind::solid, tile.colour}, none, pick++});
  }
}

void hand_over_disjoint(const std::vector<Tile>& tiles, VectorDevice& device) {
  device.begin_disjoint_fills();
  hand_over(tiles, device);
  device.end_disjoint_fills();
}

/// All in the first colour, over it all but those of the first in the second, and so on: inside, as
/// a viewer draws one colour that meets another.
void lay_over_each_other(std::vector<Tile> rest, VectorDevice& device) {
  while (!rest.empty()) {
    const Colour colour = rest.front().colour;
    std::vector<Tile> layer = rest;
    for (Tile& tile : layer) tile.colour = colour;
    hand_over_disjoint(layer, device);
    std::erase_if(rest, [&](const Tile& t) { return t.colour == colour; });
  }
}

void draw(std::vector<Tile> tiles, const std::string& way, VectorDevice& device) {
  device.begin_segment(1);
  if (way == "one-path") {
    for (Tile& tile : tiles) tile.colour = Colour(0.0);
  }
  if (way == "overlaid") {
    lay_over_each_other(tiles, device);
  } else if (way == "stroked") {
    hand_over(tiles, device);
  } else {
    hand_over_disjoint(tiles, device);
  }
  device.end_segment();
}

int run(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: seam_figures WAY FORMAT OUTPUT <TILING\n";
    return 2;
  }
  const std::string way = argv[1], format = argv[2];
  const Tiling tiling = read(std::cin);
  std::ofstream out(argv[3], std::ios::binary);
  VectorOptions options;
  options.seams = way == "trapped" ? Seams::trapped : Seams::butted;
  options.pick_ids = tiling.apart && (way == "butted" || way == "trapped");
  if (format == "svg") {
    SvgDevice device(tiling.side, tiling.side, {}, options);
    draw(tiling.tiles, way, device);
    device.finish(out);
  } else {
    PdfDevice device(out, tiling.side, tiling.side, {}, options,
                     format == "pdf" ? PageFormat::pdf : PageFormat::eps);
    draw(tiling.tiles, way, device);
    device.finish();
  }
  return out ? 0 : 1;
}

}  // namespace
}  // namespace displayfile::bench

int main(int argc, char** argv) {
  return displayfile::exit_status(displayfile::bench::run, argc, argv);
}
