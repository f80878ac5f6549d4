#pragma once

#include <optional>
#include <string_view>

#include "clip/surfaces.h"
#include "displayfile/looks/background.h"
#include "displayfile/segments/display_file.h"
#include "interp/device/picture.h"

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
/// does not count. Vectors whose fills all have the background's colour, so that lines alone are
/// seen, are left to a method of lines; not without a background to know that by, as where fills
/// are asked for by themselves.
MethodChoice choose_method(const DisplayFile& display_file, PictureKind kind,
                           const std::optional<Background>& background = std::nullopt);

}  // namespace displayfile
