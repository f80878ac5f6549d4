#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace displayfile {

/// How hidden surfaces or hidden lines are found. `automatic` lets the system pick.
enum class HiddenMethod {
  automatic,
  none,        ///< the heedless painter: polygons in the order they were entered
  back_face,   ///< the back-face check alone: right for a single convex object
  z_buffer,    ///< in image space, pixel by pixel
  bsp,         ///< in object space: a tree of the polygons' planes (hidden/sort/bsp.md)
  depth_sort,  ///< in object space: a graph of what must be drawn first (hidden/sort/depth_sort.md)
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
  colour_rule,  // not built yet
};

/// True for the methods that find which lines are seen: polygons hide, but their fills are not
/// drawn.
constexpr bool finds_lines(HiddenMethod method) {
  return method == HiddenMethod::roberts || method == HiddenMethod::appel ||
         method == HiddenMethod::franklin;
}

/// One line a name: that of a method in drawing programs and on the command line, and whether
/// this build can run it. A method's first name is the one it is written with.
struct HiddenMethodEntry {
  HiddenMethod method;
  std::string_view name;
  bool available;
};
std::span<const HiddenMethodEntry> hidden_methods();

/// The method of that name; throws Error if there is none or it is not built yet, naming
/// those that are.
HiddenMethod hidden_method(std::string_view name);
std::string_view name_of(HiddenMethod method);

}  // namespace displayfile
