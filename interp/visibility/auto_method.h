#pragma once

#include <string_view>

#include "displayfile/display_file.h"
#include "hidden/hidden_method.h"
#include "interp/picture.h"

namespace displayfile {

/// What `auto` draws with, and why, in a sentence for the user.
struct MethodChoice {
  HiddenMethod method;
  std::string_view reason;
};

/// Pixels are drawn by the z-buffer, whatever the scene: it sorts nothing, decides each pixel
/// exactly, and passes over what lies behind (interp/visibility/z_buffer.md). `displayfile bench`
/// tells how far that is from the best method of each scene.
inline constexpr HiddenMethod kMethodForPixels = HiddenMethod::z_buffer;

/// An exact method for this scene and kind of picture. A polygon that is not visible, or edge-on,
/// does not count.
MethodChoice choose_method(const DisplayFile& display_file, PictureKind kind);

/// True if no fill can hide another: then any order of drawing is right. What it may cost is linear
/// in the number of fills; where more would be needed to find out, false.
bool nothing_hides(const ViewedScene& scene);

}  // namespace displayfile
