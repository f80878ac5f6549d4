#pragma once

#include <functional>
#include <string_view>

#include "displayfile/graphics_system.h"

namespace displayfile {

class CuttingPlanes;

/// Parts of a GraphicsSystem that are not in the application API: for meshes and shapes, which
/// enter polygons with defaults of their own, and for commands and bindings, whose options replace
/// settings of a drawing program.
class SystemInside {
 public:
  /// Calls set() if the application has not made that setting; what set() sets does not count as
  /// set by the application.
  static void by_default(GraphicsSystem& system, Setting setting, const std::function<void()>& set);
  /// Calls enter(), which may set fill styles for what it enters; the one in force before is in
  /// force afterwards, also if enter() throws.
  static void keep_fill_style(GraphicsSystem& system, const std::function<void()>& enter);
  /// Calls enter(), which opens and closes segments. Where touching is automatic the reach of what
  /// they hold is this one, in the coordinates of the input: that of numbers which are less exact
  /// than doubles.
  static void with_automatic_reach(GraphicsSystem& system, double reach,
                                   const std::function<void()>& enter);

  /// True if the call that enters a closed solid makes more of it than its polygons alone.
  static bool takes_whole_solids(const GraphicsSystem& system);
  /// Calls enter(), which enters the polygons of a closed solid: if takes_whole_solids(), as a
  /// solid of one part. If enter() throws, or end_solid(), the solid is discarded.
  static void as_solid(GraphicsSystem& system, const std::function<void()>& enter);

  /// Sets touching, and from now on HiddenSurfaceSettings::touching has no effect, but that its
  /// errors are reported. It is not recorded.
  static void replace_touching(GraphicsSystem& system, const Touching& touching);
  /// The same of lines.
  static void replace_lines(GraphicsSystem& system, const LineSelection& selection);

  static const CuttingPlanes& cutting_planes(const GraphicsSystem& system);

  /// A remark in the program that is recorded, on a line of its own.
  static void comment(GraphicsSystem& system, std::string_view text);

  /// Retains in the caller's scene, and what is drawn is kept there alone: the display file has its
  /// segments, with nothing in them. For callers that draw views of the scene
  /// (displayfile/views/scene_viewer.h), which write a display file on demand.
  static void retain_alone(GraphicsSystem& system, RetainedScene& scene);
  /// True if what is drawn is in the retained scene alone.
  static bool retains_alone(const GraphicsSystem& system);
};

}  // namespace displayfile
