#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "displayfile/mesh/mesh.h"
#include "interp/draw/draw.h"
#include "interp/draw/turntable_renderer.h"
#include "programs/inputs/not_in_picture.h"
#include "programs/options/mesh_words.h"
#include "programs/options/shading_word.h"

namespace displayfile {

/// The number of views of a turntable. Throws Error for anything but an integer from 1 to 10000.
int turntable_views(const std::string& text);

/// The reports to print about a turntable.
struct TurntableReport {
  bool explanation = false, statistics = false;
};

/// Draws the inputs rotated about the view-up axis through their middle, in front of a fixed camera
/// and fixed lights, in views at equal angles, all from one BSP tree in world coordinates
/// (hidden/sort/world_tree.md), by rays from one tree of boxes (interp/visibility/ray_cast.md), or
/// each anew by a method that works in image space or finds lines (interp/draw/renderer.h). A view
/// fitted to a mesh is fitted to all views: the window, or the eye's distance.
///
/// The files are numbered: OUT-000.png, OUT-001.png and so on for OUT.png, and likewise the item
/// buffers and depths of the options; a view has the same number, and is the same, if it is drawn
/// without others. Each appears whole or not at all, and none if one of them
/// could not be written at the start. Throws Error for a hidden-surface method other than those,
/// and if the segments were drawn in several views.
///
/// Warns of contents that vectors omit. Returns the report.
std::string draw_turntable(std::span<const std::string> inputs, const std::filesystem::path& output,
                           const DrawOptions& options, const MeshWords& meshes,
                           const StartingShading& shading, const TurntableViews& views,
                           const TurntableReport& report, NotInPicture& left_out);

}  // namespace displayfile
