#pragma once

#include <optional>
#include <string>

#include "clip/view.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/retained_scene.h"
#include "hidden/exact/pixel_centre.h"
#include "interp/draw/picture_plan.h"

namespace displayfile {

/// The picture in which visibility is checked.
struct SeenIn {
  /// A raster picture, where a fill without lines is visible if it covers a pixel centre (with
  /// several samples per pixel, a sample); none: vectors, where it is visible if it has an area.
  std::optional<PictureSize> pixels = std::nullopt;
  /// For a retained scene: this view instead of those in which its segments were drawn.
  std::optional<View> view = std::nullopt;
};

SeenIn seen_in(const PicturePlan& plan);

/// True if nothing in the visible segments is visible. Stops at the first segment with something
/// visible.
bool nothing_is_seen(const DisplayFile& display_file, const SeenIn& in = {});

/// The same for the application's primitives, if they are not in the display file
/// (SystemInside::retain_alone). Stops at the first visible polygon or line.
bool nothing_is_seen(const RetainedScene& scene, const DisplayFile& display_file,
                     const SeenIn& in = {});

/// The reason, from the application's primitives, such as "all 6 polygons and lines are behind the
/// eye". The display file is that of the system that retained the scene.
std::string why_nothing_is_seen(const RetainedScene& scene, const DisplayFile& display_file,
                                const SeenIn& in = {});
/// The same without a retained scene: only what is in the view volume is known.
std::string why_nothing_is_seen(const DisplayFile& display_file, const SeenIn& in = {});

}  // namespace displayfile
