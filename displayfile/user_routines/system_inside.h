#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "displayfile/graphics_system.h"
#include "displayfile/views/picture_windows.h"

namespace displayfile {

class CuttingPlanes;
class PlaneUses;

/// Parts of a GraphicsSystem that are not in the application API: for meshes and shapes, which
/// enter polygons with their own defaults, and for commands and bindings, whose options override a
/// drawing program's settings.
class SystemInside {
 public:
  /// Calls set() if the application has not made that setting; the result does not count as set by
  /// the application.
  static void by_default(GraphicsSystem& system, Setting setting, const std::function<void()>& set);
  /// Calls enter(), which may set fill styles, and restores the fill style in force, also if
  /// enter() throws.
  static void keep_fill_style(GraphicsSystem& system, const std::function<void()>& enter);
  /// Calls enter(), which opens and closes segments. Where touching is automatic they get this
  /// reach, in the coordinates of the input, for numbers less exact than doubles.
  static void with_automatic_reach(GraphicsSystem& system, double reach,
                                   const std::function<void()>& enter);

  /// True if a call that enters a closed solid must process it as a whole.
  static bool takes_whole_solids(const GraphicsSystem& system);
  /// Calls enter(), which enters the polygons of a closed solid; if takes_whole_solids(), as a
  /// solid of one part, which is discarded if enter() or end_solid() throws.
  /// `volume` is below 0 if its light faces are inward. Where cutting planes are on and the
  /// routines are recorded it is processed as a whole, too, so that a replay knows its faces.
  static void as_solid(GraphicsSystem& system, const std::function<void()>& enter,
                       double volume = 1.0);

  /// Polygons that are not planar are cut into triangles that tile them as seen along the z axis of
  /// world coordinates, where they do not cross themselves so: for a scene that is seen along it.
  static void cut_bent_polygons_as_seen_along_z(GraphicsSystem& system);

  /// Sets touching; from now on HiddenSurfaceOptions::touching has no effect, except that its
  /// errors are reported. Not recorded.
  static void replace_touching(GraphicsSystem& system, const Touching& touching);
  /// The same for the selection of lines.
  static void replace_lines(GraphicsSystem& system, const LineSelection& selection);

  /// The same for the width of line styles, in pixels, but not of those of kinds of lines. Error: a
  /// width that is not above 0 or exceeds 1e6.
  static void replace_line_width(GraphicsSystem& system, double pixels);
  /// The same for the style of one kind of lines.
  static void replace_line_kind_style(GraphicsSystem& system, StyledLines lines,
                                      const LineKindStyle& style);

  /// Sets or removes the exact scale of pictures, for segments opened from now on. Error: a segment
  /// is open.
  static void set_scale(GraphicsSystem& system, const std::optional<ExactScale>& scale);
  static const std::optional<ExactScale>& scale(const GraphicsSystem& system);

  static const CuttingPlanes& cutting_planes(const GraphicsSystem& system);
  /// Which cutting planes had an effect, since the system was made.
  static const PlaneUses& plane_uses(const GraphicsSystem& system);

  /// Moves the segments opened from now on by these offsets in world coordinates, in order of
  /// opening, regardless of their modelling transformations; those after the last are not moved.
  /// Not recorded.
  static void place_segments(GraphicsSystem& system, std::vector<Point3> places);
  static const std::vector<Point3>& places(const GraphicsSystem& system);
  /// The number of segments opened, counted from the call of place_segments if there was one.
  static std::size_t segments_opened(const GraphicsSystem& system);
  /// Enters lines in world coordinates as a segment of its own, with the first name above all names
  /// in use: solid, in the colour of the line style in force, `narrower` times as wide. Not
  /// recorded line by line. Throws Error as open_segment and close_segment.
  static void enter_segment_of_lines(GraphicsSystem& system,
                                     std::span<const std::pair<Point3, Point3>> lines,
                                     double narrower);

  /// Adds a comment line to the recorded program.
  static void comment(GraphicsSystem& system, std::string_view text);

  /// Retains primitives only in the caller's scene: the display file has its segments, empty. For
  /// callers that draw views of the scene (displayfile/views/scene_viewer.h), which make a display
  /// file on demand.
  static void retain_alone(GraphicsSystem& system, RetainedScene& scene);
  /// If on, primitives entered from now on are only in the system's retained scene until view_again
  /// views them: until then their segments in the display file are empty. Retains a scene if none
  /// is retained. Errors: a segment is open; those of GraphicsSystem::retain.
  static void view_on_demand(GraphicsSystem& system, bool on);
  /// Views the retained segments that were opened as the scene's numbers `opened`, as if the
  /// application had drawn them in this view, and sorts them as close_segment does. The view in
  /// force and the contents of the open segment are unchanged. Nothing is recorded. Returns the
  /// view, with its window as open_segment makes it. Errors: nothing is retained; those of
  /// ViewVolume and of close_segment; nothing is changed then.
  static View view_again(GraphicsSystem& system, const View& view,
                         std::span<const std::uint32_t> opened);
  /// Calls enter(), which opens and closes segments, in another view; that in force is restored.
  static void in_other_view(GraphicsSystem& system, const View& view,
                            const std::function<void()>& enter);
  /// Replaces the view in force, also while a segment is open, which keeps its own. Not recorded.
  static void replace_view(GraphicsSystem& system, const View& view);
  /// Turns the light in force, and retained lights with its direction, to a unit vector. Not
  /// recorded. No effect if there is no light.
  static void turn_light(GraphicsSystem& system, const Point3& toward);
  /// Calls enter(), which may set line styles, and restores the line style in force, as
  /// keep_fill_style.
  static void keep_line_style(GraphicsSystem& system, const std::function<void()>& enter);
  /// False if a point of the closed segments may lie outside of the view volume in which it was
  /// entered.
  static bool is_all_in_view(const GraphicsSystem& system);
  /// True if primitives are only in the retained scene.
  static bool retains_alone(const GraphicsSystem& system);
};

}  // namespace displayfile
