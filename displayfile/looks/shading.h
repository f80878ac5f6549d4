#pragma once

#include <string_view>

namespace displayfile {

/// How light is spread over a polygon.
enum class Shading {
  flat,     ///< one intensity a polygon
  gouraud,  ///< one a vertex, linear over the picture of a triangle (displayfile/looks/gouraud.md)
  phong,    ///< a normal a vertex, linear likewise, lit at each pixel (displayfile/looks/phong.md)
};

/// Reads `flat`, `gouraud` or `phong`; throws Error for anything else.
Shading shading(std::string_view text);
std::string_view name_of(Shading shading);

}  // namespace displayfile
