#pragma once

#include <memory>
#include <optional>

#include "displayfile/files.h"
#include "displayfile/segments/surface_plan.h"
#include "interp/device/picture.h"
#include "interp/draw/draw.h"
#include "interp/draw/picture_formats.h"
#include "interp/files/page_row_file.h"

namespace displayfile {

/// The plan of one picture: a call's options completed by the application's settings, with format
/// and device. Made once per picture; all drawing code reads it.
struct PicturePlan {
  DrawOptions options;                    ///< with the background in force
  const RasterDevice* device;             ///< of pixels
  const PictureFormat* format = nullptr;  ///< of a file; null: a picture in memory
  int samples = 1;                        ///< per pixel side, for colours: the number in force
  std::optional<PixelPage> page = {};     ///< of pixels, with the picture on it
  SurfacePlan surfaces = {};
  HiddenMethod method =
      HiddenMethod::automatic;  ///< the drawing method; for vectors never `automatic`

  PictureKind kind() const {
    return format != nullptr && !format->is_of_pixels() ? PictureKind::vector : PictureKind::raster;
  }
  bool is_on_first_device() const { return device == &first_device(); }
  bool wants_fills() const {
    return options.with_ids || options.with_depth || !options.ids.empty() || !options.depth.empty();
  }

  /// Complete options for drawing without the system. The scope is irrelevant there.
  DrawOptions without_system() const;
};

/// The surface plan of a system's picture. Where the application set nothing about hidden surfaces
/// it is `automatic`, unless all points have one depth: then, as in a two-dimensional drawing, the
/// order of entry holds.
SurfacePlan surfaces_of_picture(const GraphicsSystem& system, const DrawOptions& options);

/// The plan of a picture without an application: of a given display file, or a view of a retained
/// scene. In memory, or in the file or stream `to` if not null. Throws Error for an option out of
/// range, an unknown format or device, and invalid combinations.
PicturePlan resolve(const DrawOptions& options, const Destination* to = nullptr);
/// The same for a system's picture. Its display file may be examined to choose the method for
/// vectors.
PicturePlan resolve(const GraphicsSystem& system, const DrawOptions& options,
                    const Destination* to = nullptr);

/// The same for a system's retained scene in another view, without a display file for choosing a
/// method: `automatic` is kept, except for pens. The application's settings are in the plan's
/// surface options. `system` may be null: nothing was set.
PicturePlan resolve_in_view(const GraphicsSystem* system, const DrawOptions& options,
                            const Destination* to = nullptr);

}  // namespace displayfile
