#pragma once

#include <iosfwd>
#include <optional>
#include <string>

#include "displayfile/display_file.h"
#include "displayfile/looks/style.h"

namespace displayfile {

/// Writes the canonical dump: the instructions of every segment as the interpreter meets them,
/// one a line, points after the image transformation (normalised device coordinates), numbers
/// in the shortest form that reads back to the same double.
///
///   displayfile-dump 1
///   segment NAME visible|invisible       (per segment, in order of creation)
///   fill solid R G B | fill hollow
///   shadow R G B X Y Z W                 (of a fill that shows shadows, after it: its colour
///   there,
///                                        and the light as a homogeneous point)
///   line-style solid R G B WIDTH | line-style dashed R G B WIDTH DASH GAP | line-style none
///   pick N
///   intensities I1 I2 ...                (of a shaded polygon, which follows: one for each side's
///                                        end, in that order; they multiply the fill colour)
///   move X Y Z
///   line X Y Z
///   polygon SIDES X Y Z                  (its last vertex, where it starts; then SIDES lines)
///   line X Y Z | move X Y Z              (a side to that vertex; move: an invisible edge)
///   text-style SIZE left|centre|right [always]
///   text X Y Z "CHARACTERS"              (a backslash before quotation marks and backslashes; the
///                                        pen stays where it is)
///   end                                  (of the dump)
///
/// Sorted segments are dumped back to front, their texts after all else. Where all visible segments
/// were sorted together, a segment line stands wherever the segment changes, styles stay in force
/// across it, and the segments of which nothing is drawn follow at the end.
///
/// With `fills`, all solid fills have that colour, without shadows and intensities, as the colour
/// rule draws them (interp/raster/colour_rule.md).
///
/// The stream tells by its state if it could not be written.
void dump(const DisplayFile& display_file, std::ostream& out,
          const std::optional<Colour>& fills = {});
std::string dump(const DisplayFile& display_file, const std::optional<Colour>& fills = {});

}  // namespace displayfile
