#pragma once

#include <memory>
#include <optional>

#include "displayfile/files.h"
#include "displayfile/segments/surface_plan.h"
#include "interp/device/picture.h"
#include "interp/draw/draw.h"
#include "interp/draw/picture_formats.h"
#include "interp/files/page_row_file.h"
#include "interp/visibility/auto_method.h"

namespace displayfile {

struct InView;

/// The plan of one picture: a call's options completed by the application's settings, with format
/// and device. Made once per picture; all drawing code reads it. It is made in two steps where the
/// options are to be checked before the scene is there: resolve_call and settle.
struct PicturePlan {
  DrawOptions options;                    ///< with the background in force
  const Destination* to = nullptr;        ///< null: a picture in memory. Must outlive the plan
  const RasterDevice* device;             ///< of pixels
  const PictureFormat* format = nullptr;  ///< of a file
  int samples = 1;                        ///< per pixel side, for colours: the number in force
  std::optional<PixelPage> page = {};     ///< of pixels, with the picture on it
  SurfacePlan surfaces = {};
  HiddenMethod method =
      HiddenMethod::automatic;  ///< the drawing method; for vectors never `automatic`
  MethodChoice choice = {};     ///< of a system's picture: in place of `automatic`, and why

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
SurfacePlan surfaces_of_picture(const GraphicsSystem& system, const HiddenSurfaceOptions& options);

/// Resolves the call alone: looks up format and device, and checks numbers; the plan is to be
/// settled. The picture is in memory, or in the file or stream `to` if not null. Throws Error for
/// an option out of range, an unknown format or device, and invalid combinations, here and below.
PicturePlan resolve_call(const DrawOptions& options, const Destination* to = nullptr);
/// Completes it by the application's settings; nothing was set if there is no system. The display
/// file may be examined to choose the method for vectors.
void settle(PicturePlan& plan, const GraphicsSystem* system);
/// The same for a system's retained scene in another view, without a display file for choosing a
/// method: `automatic` is kept, except for pens. The application's settings are in the plan's
/// surface options.
void settle_in_view(PicturePlan& plan, const GraphicsSystem* system);

/// Both steps: of a picture without an application, such as of a given display file,
PicturePlan resolve(const DrawOptions& options, const Destination* to = nullptr);
/// of a system's picture,
PicturePlan resolve(const GraphicsSystem& system, const DrawOptions& options,
                    const Destination* to = nullptr);
/// and of its retained scene in another view.
PicturePlan resolve_in_view(const GraphicsSystem* system, const DrawOptions& options,
                            const Destination* to = nullptr);

/// Draws the visible segments as draw of a system does (interp/draw/draw.h), by its settled plan.
void draw(const GraphicsSystem& system, const PicturePlan& plan, SortedDisplayFile& kept);
/// Draws a retained scene in a view as Renderer::draw does, by its plan, settled in view.
void draw(const InView& scene, const PicturePlan& plan);

}  // namespace displayfile
