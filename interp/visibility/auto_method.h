#pragma once

#include <string_view>

#include "displayfile/display_file.h"
#include "displayfile/viewed_scene.h"
#include "hidden/exact/pixel_centre.h"
#include "hidden/hidden_method.h"
#include "interp/picture.h"

namespace displayfile {

/// What `auto` draws with, and why, in a sentence for the user.
struct MethodChoice {
  HiddenMethod method;
  std::string_view reason;
};

/// The cheapest method that is exact for this scene and picture. A polygon that is not visible, or
/// edge-on, does not count.
MethodChoice choose_method(const DisplayFile& display_file, PictureKind kind,
                           const PictureSize& size);

/// The same for a picture in pixels whose fills have been collected: an image-space method.
MethodChoice choose_method(const ViewedScene& scene, const PictureSize& size);

/// True if no fill can hide another: then any order of drawing is right. What it may cost is linear
/// in the number of fills; where more would be needed to find out, false.
bool nothing_hides(const ViewedScene& scene);

}  // namespace displayfile
