#pragma once

#include <string>

#include "displayfile/segments/display_file.h"
#include "interp/draw/picture_plan.h"

namespace displayfile {

/// `displayfile draw --stats`: counts of the drawing, and the cost of hidden-surface removal.
/// `drawn` is the system's display file in drawing order.
std::string drawing_statistics(const GraphicsSystem& system, const DisplayFile& drawn,
                               const PicturePlan& plan);

/// `displayfile draw --explain`: the method that draws the picture, and why.
std::string explanation_of_method(const PicturePlan& plan);

/// The line of statistics that has the elapsed times, in seconds.
std::string times_of_drawing(double entering, double drawing);

}  // namespace displayfile
