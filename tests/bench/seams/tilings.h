#pragma once

#include <string>
#include <vector>

#include "clip/point.h"
#include "displayfile/looks/style.h"

namespace displayfile::bench {

/// Pieces that do not overlap, each of one colour, in normalised device coordinates.
struct Tiling {
  struct Tile {
    std::vector<Point3> vertices;
    Colour colour;
  };
  std::string name;
  int side;  ///< of the picture, in pixels
  std::vector<Tile> tiles;
  bool apart = false;  ///< pieces of one colour are elements of their own too
};

/// A disc of random triangles: all of one colour, each of one of two, or each of its own.
Tiling one_colour_disc();
Tiling one_colour_disc_of_elements();  ///< each triangle an element of its own
Tiling two_colour_disc();
Tiling many_colour_disc();
/// Stripes of random colours, wide enough that no pixel is near three of them.
Tiling stripes();
/// A mesh's front faces, each in the grey of its slope, without those that another overlaps.
Tiling front_faces(const std::string& mesh);

/// The same pieces, all black.
Tiling in_black(const Tiling& tiling);

/// The colours of pieces, in the order of pixel_of.
std::vector<Colour> colours_of(const Tiling& tiling);

}  // namespace displayfile::bench
