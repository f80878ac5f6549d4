#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "clip/point.h"
#include "displayfile/mesh/mesh.h"
#include "programs/options/explosion.h"

namespace displayfile {

/// A part of an assembly, in world coordinates.
struct AssemblyPart {
  Point3 low, high;        ///< its box, before it is moved
  std::size_t points = 0;  ///< of its polygons and lines
  Point3 move{0.0};
  Point3 neighbour{0.0};  ///< the move of the part before it, from which its trace line starts
  /// An input's file name without folder and extension; a segment's title, otherwise the object's
  /// name, otherwise its number.
  std::string name{};
};

/// Sets the moves of two parts or more. Along an axis, the parts named by the explosion come first,
/// in its order, then the others in the order of the ends of their boxes at which the axis begins,
/// with ties by their other ends. Equal parts side by side move alike: parts of as many points
/// whose boxes begin and end along the axis at the same places, within a millionth of the longest
/// part, and do not overlap across it. The first part stays; the box of each other begins at the
/// end of those before it, or where it was if that is farther, and `factor` times the mean length
/// of the parts beyond it. Radially each part's middle is moved by `factor` times its distance from
/// the middle of the box of all. Throws Error if no part would move, for a name that no part has,
/// and for a part named twice.
void move_apart(std::vector<AssemblyPart>& parts, const Explosion& explosion);

/// The moves of segments, in the order in which the inputs open them, and the trace lines' dashes.
struct ExplodedParts {
  std::vector<Point3> places;
  std::vector<std::pair<Point3, Point3>> traces;
  std::vector<int> cut_off;  ///< segments that are moved out of a view that is set
};

/// The parts of the inputs: each that has visible polygons or lines, or of one alone its segments,
/// which are a mesh's objects. Throws Error if there are fewer than two, for standard input, and
/// for inputs that cannot be read. `aspect` is that of the picture.
ExplodedParts exploded_parts(std::span<const std::string> inputs, const Explosion& explosion,
                             const ImportLimits& limits, double aspect);

/// The pieces of a dash-dotted line from one point to another, of dashes, dots and gaps that
/// together are `period` long; it begins and ends with a dash.
void append_dash_dots(const Point3& from, const Point3& to, double period,
                      std::vector<std::pair<Point3, Point3>>& pieces);

}  // namespace displayfile
