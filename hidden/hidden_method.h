#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace displayfile {

/// How hidden surfaces or hidden lines are found. `automatic` lets the system pick. Beside those
/// that have a name here there is the colour rule by each method of surfaces: colour_rule_by().
enum class HiddenMethod {
  automatic,
  none,        ///< the heedless painter: polygons in the order they were entered
  back_face,   ///< the back-face check alone: right for a single convex object
  z_buffer,    ///< in image space, pixel by pixel
  bsp,         ///< in object space: a tree of the polygons' planes (hidden/sort/bsp.md)
  depth_sort,  ///< in object space: a graph of what must be drawn first (hidden/sort/depth_sort.md)
  map,         ///< in object space: what is seen of each polygon (hidden/map/visible_map.md)
  scan_line,   ///< in image space, row by row, without a z-buffer (interp/visibility/scan_line.md)
  scan_line_z,  ///< in image space, row by row, with a z-buffer one row high
  ray_cast,     ///< in image space, a ray through each pixel centre (interp/visibility/ray_cast.md)
  world_ray_cast,  ///< in object space, before viewing: the same by rays in world coordinates
  warnock,         ///< in image space, areas subdivided until it is easy to tell
                   ///< (interp/visibility/warnock.md)
  plain_z_buffer,  ///< the z-buffer as textbooks give it, with the depths' rounding and all that it
                   ///< gets wrong (interp/visibility/plain_z_buffer.h): depths as floats;
  plain_z_buffer_16,      ///< as integers of 16 bits,
  plain_z_buffer_24,      ///< of 24,
  plain_z_buffer_32,      ///< of 32;
  plain_z_buffer_double,  ///< as doubles. Never what `automatic` picks
  roberts,      ///< lines in object space, each against all polygons (hidden/lines/roberts.md)
  appel,        ///< lines in object space, by the number of polygons before them
                ///< (hidden/lines/appel.md)
  franklin,     ///< lines in object space, by cells of the picture (hidden/lines/franklin.md)
  perimeter,    ///< the curves of one surface over a grid (hidden/lines/perimeter.md)
  colour_rule,  ///< fills in the background's colour, lines over them, by the surfaces that
                ///< `automatic` finds (interp/raster/colour_rule.md). The last of this list
};

/// The colour rule by a method of surfaces; by `automatic` it is HiddenMethod::colour_rule.
constexpr HiddenMethod colour_rule_by(HiddenMethod surfaces) {
  return static_cast<HiddenMethod>(static_cast<int>(HiddenMethod::colour_rule) +
                                   static_cast<int>(surfaces));
}
constexpr bool is_colour_rule(HiddenMethod method) { return method >= HiddenMethod::colour_rule; }
/// What finds the surfaces of a colour rule; of another method, that method.
constexpr HiddenMethod surfaces_of(HiddenMethod method) {
  if (!is_colour_rule(method)) return method;
  return static_cast<HiddenMethod>(static_cast<int>(method) -
                                   static_cast<int>(HiddenMethod::colour_rule));
}

/// True for the methods that find which lines are seen: polygons hide, but their fills are not
/// drawn.
constexpr bool finds_lines(HiddenMethod method) {
  return method == HiddenMethod::roberts || method == HiddenMethod::appel ||
         method == HiddenMethod::franklin || method == HiddenMethod::perimeter;
}
/// True for what draws surfaces over grids alone, and refuses other scenes.
constexpr bool needs_surface(HiddenMethod method) { return method == HiddenMethod::perimeter; }

/// True for the methods whose pictures are of lines: of fills nothing is seen but what they hide.
constexpr bool shows_lines_only(HiddenMethod method) {
  return finds_lines(method) || is_colour_rule(method);
}

/// One line a name: that of a method in drawing programs and on the command line. A method's first
/// name is the one it is written with. Of the colour rules only the first is in the list.
struct HiddenMethodEntry {
  HiddenMethod method;
  std::string_view name;
};
std::span<const HiddenMethodEntry> hidden_methods();

/// The method of that name; for colour-rule=METHOD the colour rule by that method of surfaces.
/// Throws Error for any other name, after colour-rule= also for a method that finds no surfaces,
/// and lists the names that are allowed there.
HiddenMethod hidden_method(std::string_view name);
std::string_view name_of(HiddenMethod method);

}  // namespace displayfile
