#pragma once

#include "displayfile/files.h"
#include "displayfile/segments/viewed_scene.h"
#include "interp/draw/draw.h"
#include "interp/draw/picture_plan.h"
#include "interp/visibility/drawn_layers.h"
#include "interp/visibility/picker.h"

namespace displayfile {

/// How the item buffer of a system's picture is determined.
enum class ItemBufferIs {
  truth,   ///< the nearest fill, exactly; for methods that find lines, the fill that hides
  drawn,   ///< the fill drawn, by a method that rounds or by a device's own z-buffer
  layers,  ///< in layers (interp/visibility/drawn_layers.h)
};
ItemBufferIs item_buffer_of(const GraphicsSystem& system, const PicturePlan& plan);

/// The layers in which the display file is drawn, of which `scene` is the scene: its segments, each
/// sorted or in order of entry.
DrawnLayers layers_of(const DisplayFile& drawn, const ViewedScene& scene, HiddenMethod method);

/// Options for the row of one pixel, with ids and depths.
DrawOptions row_of_pixel(const DrawOptions& options, const Picker::Pixel& at);

}  // namespace displayfile
