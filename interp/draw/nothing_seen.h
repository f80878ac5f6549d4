#pragma once

#include <optional>
#include <string>

#include "clip/view.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/retained_scene.h"
#include "hidden/exact/pixel_centre.h"
#include "interp/draw/picture_plan.h"

namespace displayfile {

/// In what picture something is to be seen.
struct SeenIn {
  /// A picture of pixels, where a fill without lines is seen if it covers one's centre (with
  /// several samples a pixel, one of theirs); none: of vectors, where it is seen if it has an area.
  std::optional<PictureSize> pixels = std::nullopt;
  /// For a retained scene: this view, not those that its segments were drawn in.
  std::optional<View> view = std::nullopt;
};

SeenIn seen_in(const PicturePlan& plan);

/// True if the visible segments hold nothing that shows. Looks no further than the first segment
/// that does.
bool nothing_is_seen(const DisplayFile& display_file, const SeenIn& in = {});

/// The same of what the application drew, where that is not in the display file
/// (SystemInside::retain_alone). Looks no further than the first polygon or line that shows.
bool nothing_is_seen(const RetainedScene& scene, const DisplayFile& display_file,
                     const SeenIn& in = {});

/// Why that is so, from what the application drew, such as "all 6 polygons and lines are behind the
/// eye": the display file is that of the system that retained the scene.
std::string why_nothing_is_seen(const RetainedScene& scene, const DisplayFile& display_file,
                                const SeenIn& in = {});
/// The same where nothing is retained: it tells no more than what is in the view volume.
std::string why_nothing_is_seen(const DisplayFile& display_file, const SeenIn& in = {});

}  // namespace displayfile
