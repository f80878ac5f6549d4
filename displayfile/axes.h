#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "clip/point.h"
#include "displayfile/graphics_system.h"

namespace displayfile {

/// The numbers from low to high (low < high) at which an axis has ticks: multiples of the least of
/// 1, 2 and 5 times a power of ten that makes so many steps at most.
std::vector<double> axis_ticks(double low, double high, int most_steps);
/// Such a number as it stands at an axis, with a minus sign in place of the hyphen.
std::string axis_number(double value);

/// Draws the axes of a box of the model into the open segment: of each axis the line from its low
/// end to its high one, ticks and numbers at about five multiples of 1, 2 or 5 times a power of
/// ten, and its name. Of the edges of the box that are parallel to an axis and on its outline in
/// the view in force, it stands on the lowest, or, where they are steep, on the one to the left:
/// ticks, numbers and names are outside of the box as it is seen there, where nothing in the box
/// hides them. A name is beside the middle of its axis, or where that is not in the picture beside
/// another place of it or beyond its end. A number stands farther out where another axis' number is
/// in the way, or is left out. An axis whose ends are equal is left out, and one of which no edge
/// is on the outline, as it is seen end on or nearly so.
///
/// It is made of move_abs_3, line_abs_3, set_text_style and text, and recorded so: lines are in the
/// line style in force, texts of the size in force. It leaves the text style as it was and the
/// current position at `low`. Another view that is drawn of a retained scene has the same axes.
///
/// low and high are in the coordinates of the primitives. Errors, before anything is drawn: no
/// segment open; an end that is above its other, all equal; a name that is no text; a place that
/// is out of range or not before the eye.
void axes_3(GraphicsSystem& system, const Point3& low, const Point3& high,
            const std::array<std::string_view, 3>& names = {"x", "y", "z"});

}  // namespace displayfile
