#pragma once

#include <memory>

#include "displayfile/files.h"
#include "displayfile/segments/surface_plan.h"
#include "interp/device/picture.h"
#include "interp/draw/draw.h"
#include "interp/draw/picture_formats.h"

namespace displayfile {

/// How one picture is made: a call's options, and what the application set where they leave it
/// open, with the format and the device that they name. Made once for each picture; whatever draws
/// it reads this.
struct PicturePlan {
  DrawOptions options;                    ///< with the background in force
  const RasterDevice* device;             ///< of pixels
  const PictureFormat* format = nullptr;  ///< of a file; null: a picture in memory
  int samples = 1;                        ///< along a pixel's side, of colours: what is in force
  SurfacePlan surfaces = {};
  HiddenMethod method = HiddenMethod::automatic;  ///< that draws: of vectors never `automatic`

  PictureKind kind() const {
    return format != nullptr && !format->is_of_pixels() ? PictureKind::vector : PictureKind::raster;
  }
  bool is_on_first_device() const { return device == &first_device(); }
  bool wants_fills() const {
    return options.with_ids || options.with_depth || !options.ids.empty() || !options.depth.empty();
  }

  /// For what is drawn without the system: options that leave nothing open. The scope has no
  /// meaning there.
  DrawOptions without_system() const;
};

/// How the surfaces of a system's picture are found. Where the application set nothing about hidden
/// surfaces that is `automatic`, unless all points have one depth: then, as in a drawing of two
/// dimensions, the order of entry holds.
SurfacePlan surfaces_of_picture(const GraphicsSystem& system, const DrawOptions& options);

/// The plan of a picture without an application: of a display file that is ready, or a view of a
/// retained scene. In memory, or if `to` is not null in that file or stream. Throws Error for an
/// option out of its range, an unknown format or device, and what these cannot do together.
PicturePlan resolve(const DrawOptions& options, const Destination* to = nullptr);
/// The same of a system's picture. Its display file may be looked at for the method that draws
/// vectors.
PicturePlan resolve(const GraphicsSystem& system, const DrawOptions& options,
                    const Destination* to = nullptr);

/// The same of what a system retained, in another view, for which there is no display file to
/// choose a method by: `automatic` stays, but for pens. What the application set stands in the
/// plan's options for surfaces. `system` may be null: nothing was set.
PicturePlan resolve_in_view(const GraphicsSystem* system, const DrawOptions& options,
                            const Destination* to = nullptr);

}  // namespace displayfile
