#pragma once

#include <string>
#include <string_view>

#include "interp/draw/picture_plan.h"

namespace displayfile {

/// The point of `displayfile draw --pick`, in pixels from the upper left corner.
struct PickOption {
  double x = 0.0, y = 0.0;
  double reach = 0.0;  ///< of lines
};

/// Throws Error for a text that is not X,Y or X,Y,REACH.
PickOption pick_option(std::string_view text);

/// One line about the primitive visible there, in that picture.
std::string picked(const GraphicsSystem& system, const PickOption& at, const PicturePlan& plan);

}  // namespace displayfile
