#pragma once

#include "interp/draw/draw.h"
#include "interp/draw/picture_plan.h"
#include "interp/visibility/auto_method.h"

namespace displayfile {

/// drawing_method (interp/draw/draw.h), and why it is that.
MethodChoice drawing_choice(const GraphicsSystem& system, const DrawOptions& options,
                            PictureKind kind);

/// The same of a plan, whose own method is not looked at.
MethodChoice choice_for(const GraphicsSystem& system, const PicturePlan& plan, PictureKind kind);

/// The method to bring a display file up to date with where nothing is to be sorted for
/// `automatic`: for pixels, whose renderer picks a method itself, and for dumps of what was
/// entered.
constexpr HiddenMethod unsorted_if_automatic(HiddenMethod method) {
  return surfaces_of(method) == HiddenMethod::automatic ? HiddenMethod::none : method;
}

}  // namespace displayfile
