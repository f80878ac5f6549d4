#pragma once

#include <optional>
#include <string_view>

#include "clip/surfaces.h"
#include "displayfile/looks/style.h"
#include "displayfile/segments/display_file.h"
#include "interp/device/picture.h"

namespace displayfile {

/// The method chosen for `auto`, and the reason, a sentence for the user.
struct MethodChoice {
  HiddenMethod method;
  std::string_view reason;
};

/// Pixels are drawn by the z-buffer, whatever the scene: it sorts nothing, decides each pixel
/// exactly, and skips hidden fills (interp/visibility/z_buffer.md). `displayfile bench` compares it
/// with the best method of each scene.
inline constexpr HiddenMethod kMethodForPixels = HiddenMethod::z_buffer;

/// An exact method for this scene and kind of picture. Invisible and edge-on polygons are ignored.
/// Vectors whose fills all have the background's colour, so that only lines are visible, are drawn
/// by a method that finds lines; not without a background, or if ids or depths of fills are
/// requested.
MethodChoice choose_method(const DisplayFile& display_file, PictureKind kind,
                           const std::optional<Background>& background = std::nullopt);

}  // namespace displayfile
