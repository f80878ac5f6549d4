#pragma once

#include "interp/draw/draw.h"
#include "interp/draw/picture_plan.h"
#include "interp/visibility/auto_method.h"

namespace displayfile {

/// The result of drawing_method (interp/draw/draw.h), and the reason.
MethodChoice drawing_choice(const GraphicsSystem& system, const DrawOptions& options,
                            PictureKind kind);

/// The same for a plan, whose own method is ignored.
MethodChoice choice_for(const GraphicsSystem& system, const PicturePlan& plan, PictureKind kind);

/// The method for updating a display file where `automatic` needs no sort: for pixels, whose
/// renderer chooses a method itself, and for dumps of the entered instructions.
constexpr HiddenMethod unsorted_if_automatic(HiddenMethod method) {
  return surfaces_of(method) == HiddenMethod::automatic ? HiddenMethod::none : method;
}

}  // namespace displayfile
