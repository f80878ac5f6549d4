#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "clip/base/nearest_word.h"
#include "clip/base/round_to_nearest.h"
#include "clip/base/words.h"
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/text/characters.h"
#include "displayfile/text/program_line.h"
#include "displayfile/text/routine.h"
#include "displayfile/text/routine_calls.h"

namespace displayfile {

void wrong_count(const ProgramLine& line, const Routine& routine) {
  const std::size_t count = line.arguments();
  std::string message =
      fmt::format("{}: {} argument{}, expected ", routine.name, count, count == 1 ? "" : "s");
  if (routine.arguments == 0) {
    message += "none";
  } else if (routine.arguments == UserRoutine::kVaries) {
    message += routine.expected;
  } else {
    message += fmt::format("{}: {}", routine.arguments, routine.expected);
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (const std::string_view hint = hint_at(line.argument(i)); !hint.empty()) {
      message += hint;
      break;
    }
  }
  const bool too_many =
      routine.arguments != UserRoutine::kVaries && std::cmp_greater(count, routine.arguments);
  if (too_many) {
    throw ErrorAt(line.argument(static_cast<std::size_t>(routine.arguments)).data(), message);
  }
  const std::string_view last = count == 0 ? line.name() : line.argument(count - 1);
  throw ErrorAt(last.data() + last.size(), message);
}

namespace {

using namespace routine_calls;
using G = GraphicsSystem;

// Every user routine, by topic. They are looked up in this order: the most frequent in programs
// come first.

constexpr auto kPrimitives = std::to_array<Routine>({
    varying<points<Point3, &G::polygon_abs_3>>(
        "polygon-abs-3", "a multiple of 3: x y z ...",
        "A polygon of 3 or more vertices. It may be concave or self-crossing and is filled by the "
        "even-odd rule. The current position becomes its last vertex."),
    fixed<&G::line_abs_3>(
        "line-abs-3", "x y z",
        "A line from the current position to the point, which becomes the current position."),
    fixed<&G::move_abs_3>("move-abs-3", "x y z", "Moves the current position to the point."),
    varying<points<Point2, &G::polygon_abs_2>>("polygon-abs-2", "a multiple of 2: x y ...",
                                               "As polygon-abs-3, at the current position's z."),
    fixed<&G::line_abs_2>("line-abs-2", "x y", "As line-abs-3, at the current position's z."),
    fixed<&G::move_abs_2>("move-abs-2", "x y", "As move-abs-3; keeps the current position's z."),
    varying<points<Point3, &G::polygon_rel_3>>("polygon-rel-3", "a multiple of 3: dx dy dz ...",
                                               "As polygon-abs-3, with each vertex relative to the "
                                               "one before, the first to the current position."),
    fixed<&G::line_rel_3>("line-rel-3", "dx dy dz",
                          "As line-abs-3, to a point relative to the current position."),
    fixed<&G::move_rel_3>("move-rel-3", "dx dy dz", "Moves the current position by this offset."),
    varying<points<Point2, &G::polygon_rel_2>>("polygon-rel-2", "a multiple of 2: dx dy ...",
                                               "As polygon-rel-3, at the current position's z."),
    fixed<&G::line_rel_2>("line-rel-2", "dx dy", "As line-rel-3, at the current position's z."),
    fixed<&G::move_rel_2>("move-rel-2", "dx dy",
                          "Moves the current position by this offset in x and y."),
    fixed<&G::text>("text", "\"characters\"",
                    "A text at the current position, which is unchanged: one line of UTF-8, at "
                    "most 65535 bytes. It is upright, in the text style and the line style's "
                    "colour, and visible where its anchor is."),
    varying<surface>(
        "surface-3", "6 and heights: x-min x-max x-points y-min y-max y-points z ...",
        "The surface z = F(x, y) over an even grid of x-points times y-points heights, x fastest. "
        "A height may be nan: the cells around it are omitted. Each cell has one pick identifier."),
    varying<axes>(
        "axes-3", "6 or 9: x-min x-max y-min y-max z-min z-max [\"x\" \"y\" \"z\"]",
        "The axes of a box with ticks, numbers and names, in the line style and the text style, "
        "each along an edge on the box's outline. An axis whose ends are equal is omitted."),
});

constexpr auto kShapes = std::to_array<Routine>({
    counted<of_corners<box_3>>("box-3", "x-min x-max y-min y-max z-min z-max", "A box."),
    counted<of_corners<wedge_3>>("wedge-3", "x-min x-max y-min y-max z-min z-max",
                                 "A wedge: the half of a box below the plane from its upper edge "
                                 "at x-min to its lower edge at x-max."),
    counted<of_lengths<prism_3>>("prism-3", "x y z radius height sides",
                                 "A prism along z over a regular polygon centred at x y z, whose "
                                 "first corner is in the direction of x."),
    counted<of_lengths<cylinder_3>>(
        "cylinder-3", "x y z radius height facets",
        "A cylinder along z with its base centred at x y z and 3 to 1000 facets around."),
    varying<cone>(
        "cone-3", "6 or 7: x y z radius height facets [top-radius]",
        "A cone along z with its base centred at x y z; truncated if top-radius is above 0."),
    counted<sphere>("sphere-3", "x y z radius facets",
                    "A sphere about x y z with 3 to 1000 facets around and half as many from pole "
                    "to pole, along z."),
    counted<of_lengths<torus_3>>(
        "torus-3", "x y z radius tube-radius facets",
        "A torus about the line along z through x y z, with half as many facets around the tube."),
    varying<extrude>("extrude-3", "2 and a multiple of 2: z-min z-max  x y ...",
                     "A profile in the x-y plane, extruded along z. It has 3 or more points in "
                     "either orientation, may be concave and must not cross itself."),
    varying<turn>("turn-3", "1 and a multiple of 2: facets  x z ...",
                  "A profile in the x-z plane with x of 0 or more, revolved about the z axis."),
    fixed<&G::begin_solid>("begin-solid", "union|intersection|difference",
                           "Begins a solid, ended by end-solid: its parts combined in their order. "
                           "A part is a shape, a solid, or closed polygons."),
    fixed<&G::end_solid>("end-solid", "",
                         "Combines the parts of the innermost solid and enters the result."),
    fixed<&G::discard_solid>("discard-solid", "", "Discards the innermost solid."),
});

constexpr auto kAttributes = std::to_array<Routine>({
    fixed<&G::set_pick_id>(
        "set-pick-id", "n",
        "The pick identifier of the polygons and lines that follow, 0 or more. -1 restores the "
        "default: each polygon's ordinal in the program, and none for lines."),
    varying<fill_style>(
        "set-fill-style", "solid r g b | hollow",
        "Fill style of the polygons that follow [solid 0.8 0.8 0.8]. A colour r g b may be "
        "one word: #rrggbb, #rgb or a CSS name, such as darkorange."),
    varying<line_style>("set-line-style",
                        "solid r g b [width] | dashed r g b [width [dash gap]] | none",
                        "Style of the lines and polygon sides that follow [solid 0 0 0 1]. Width, "
                        "dash and gap are in pixels."),
    varying<line_kind_style>(
        "set-line-kind-style",
        "outline|boundary|crease|material|intersection|all|hidden|hatch width|same [solid|dashed "
        "[dash gap]] [r g b]",
        "Style of polygon sides of one kind of set-lines, of hidden lines (kind hidden), or of the "
        "hatching of cut faces (kind hatch), in place of the line style, for primitives that "
        "follow. Hatching with a style is drawn where the line style is none, too. Lengths are in "
        "pixels; same alone "
        "restores the default [same; hidden: dashed and half as wide, at least 0.5]."),
    varying<text_style>("set-text-style", "size [left|centre|right] [always]",
                        "Size of the letters of texts that follow, as a fraction of the picture's "
                        "height, and the point of the base line at the current position [0.03 "
                        "left]. With always, nothing hides them."),
    varying<light>("set-light", "3 or 4: x y z [ambient]",
                   "Direction toward the light, in world coordinates and of any length, and the "
                   "share of ambient light [no light; ambient 0.2]."),
    fixed<&G::set_shading>(
        "set-shading", "flat|gouraud|phong",
        "Shading where there is light: flat, one intensity per polygon; gouraud, intensities "
        "interpolated between vertices; phong, normals interpolated and each pixel lit [flat]."),
    fixed<&G::set_crease_angle>(
        "set-crease-angle", "degrees",
        "Angle, 0 to 180 degrees, above which smooth shading keeps sides between facets of meshes "
        "that follow sharp; 180: one mean normal at each vertex [180]."),
    varying<points<Point3, &G::set_vertex_normals>>(
        "set-vertex-normals", "a multiple of 3: x y z ...",
        "Vertex normals of the next polygon, in the order of its vertices, for smooth shading. 0 0 "
        "0 is the polygon's own normal; no arguments discard normals set before."),
    varying<vertex_colours>(
        "set-vertex-colours", "r g b ...",
        "Colours of the vertices of the next polygon, in their order, in place of its fill style: "
        "linear in between, and lit where there is light. Each may be one word, as in "
        "set-fill-style; no arguments discard colours set before."),
    fixed<&G::set_shadows>("set-shadows", "on|off",
                           "Whether the polygons that follow show shadows of solid fills, where "
                           "there is light [off]."),
    varying<cutting_plane>("set-cutting-plane", "5: n a b c d, or 2: n off",
                           "Cutting plane n, 1 to 6: parts with a x + b y + c z + d < 0 in world "
                           "coordinates are cut away from the primitives that follow [off]."),
    varying<cut_faces>("set-cut-faces", "open | closed | hatched [spacing|usual [angle]]",
                       "The faces made where planes cut closed solids that follow. Spacing is in "
                       "world units, the angle in degrees [open]."),
    varying<background>("set-background", "r g b | none",
                        "Background colour of pictures, shared by all segments; transparent is "
                        "another word for none [1 1 1]."),
    fixed<&G::set_surface_curves>("set-surface-curves", "x|y|both",
                                  "Curves drawn on the surfaces that follow [both]."),
    fixed<&G::set_surface_sides>(
        "set-surface-sides", "upper|lower|both",
        "Sides on which curves of the surfaces that follow are drawn [both]."),
    varying<lower_line_style>("set-lower-line-style",
                              "solid r g b [width] | dashed r g b [width [dash gap]] | none | same",
                              "Line style of the lower side of the surfaces that follow [same]."),
});

constexpr auto kAnnotation = std::to_array<Routine>({
    varying<leader>("leader-3", "4 or 6: x y z \"characters\" [right up]",
                    "A leader: a line from the point to a text, which stands this far right and up "
                    "on paper, in the unit of set-annotation-size [three times the size, both]."),
    varying<balloon>("balloon-3", "4, 5 or 7: x y z number [\"name\" [right up]]",
                     "A balloon: a number in a circle, 1 or more, with a line from the point, as "
                     "leader-3. A part with a name is in the parts list."),
    counted<linear_dimension>(
        "linear-dimension-3", "x|y|z x1 y1 z1 x2 y2 z2 dx dy dz",
        "The distance of two points along an axis, at a dimension line through the first point "
        "moved by dx dy dz, whose part along the axis has no effect."),
    counted<aligned_dimension>(
        "aligned-dimension-3", "x1 y1 z1 x2 y2 z2 dx dy dz",
        "The distance of two points, at a dimension line between them, moved by dx dy dz."),
    counted<of_circle<DiameterDimension>>("diameter-dimension-3", "x1 y1 z1 x2 y2 z2",
                                          "The diameter between two opposite points of a circle."),
    counted<of_circle<RadiusDimension>>("radius-dimension-3", "x y z x1 y1 z1",
                                        "The radius of a circle, from its centre to a point."),
    counted<angle_dimension>(
        "angle-dimension-3", "x y z x1 y1 z1 x2 y2 z2 radius",
        "The angle at x y z between the directions to two points, above 0 and below 180 degrees, "
        "at an arc of that radius."),
    counted<title>("title", "\"characters\"",
                   "A line of text at the middle of the picture's upper margin."),
    varying<parts_list>("parts-list", "[top-left|top-right|bottom-left|bottom-right]",
                        "A table of the balloons that have names, with their quantities, in this "
                        "corner of the picture [bottom-right]."),
    counted<annotation_style<&AnnotationStyle::size, &AnnotationStyle::unit>>(
        "set-annotation-size", "size mm|px",
        "Height of the capital letters of annotation that follows; lines and arrows are in "
        "proportion. In millimetres on paper, or in pixels [3.5 mm]."),
    counted<annotation_style<&AnnotationStyle::ends>>(
        "set-annotation-ends", "arrow|dot", "Ends of leaders that follow, at the model [arrow]."),
    counted<annotation_style<&AnnotationStyle::decimals>>(
        "set-annotation-decimals", "n",
        "Most decimals of measures that follow, 0 to 9; trailing zeros are omitted [2]."),
    counted<annotation_style<&AnnotationStyle::dimension_text>>(
        "set-dimension-text", "\"characters\"",
        "Text of dimensions that follow, with <> in place of the measure, which is without its "
        "sign, as \"2x <> H7\"; \"\" for the measure with its sign [\"\"]."),
    counted<annotation_style<&AnnotationStyle::placement>>(
        "set-annotation-placement", "entered|auto",
        "Where annotation that follows stands: as entered, or outside of the figure, clear of "
        "other annotation, with leaders that do not cross [entered]."),
});

constexpr auto kSegments = std::to_array<Routine>({
    fixed<&G::open_segment>(
        "open-segment", "name",
        "Opens a segment, into which primitives are entered. Names start at 1."),
    fixed<&G::close_segment>("close-segment", "",
                             "Closes the open segment and, if hidden-line removal is on with a "
                             "method that sorts, sorts its contents."),
    fixed<&G::delete_segment>("delete-segment", "name", "Deletes a segment, which must be closed."),
    fixed<&G::delete_all_segments>("delete-all-segments", "",
                                   "Deletes all segments; none may be open."),
    fixed<&G::rename_segment>("rename-segment", "name new-name",
                              "Renames a segment, which must be closed."),
    fixed<&G::set_segment_title>(
        "set-segment-title", "name \"characters\"",
        "A segment's title, such as the name of a part: in vector files the name of its layer, "
        "and in SVG its title and id [none]."),
    fixed<&G::set_visibility>("set-visibility", "name on|off",
                              "Whether a segment is drawn and can be picked [on]."),
    fixed<&G::set_image_translation>("set-image-translation", "name tx ty",
                                     "Moves a segment's image, after its scale and rotation, in "
                                     "normalised device coordinates [0 0]."),
    fixed<&G::set_image_scale>("set-image-scale", "name sx sy",
                               "Scales a segment's image about the image's centre [1 1]."),
    fixed<&G::set_image_rotation>(
        "set-image-rotation", "name angle",
        "Rotates a segment's image counterclockwise about the image's centre, in degrees [0]."),
    fixed<&G::set_image_centre>(
        "set-image-centre", "name x y",
        "Centre of the image's scale and rotation, in normalised device coordinates [0 0]."),
});

constexpr auto kTransformation = std::to_array<Routine>({
    fixed<&G::create_transformation_3>(
        "create-transformation-3", "",
        "Resets the modelling transformation to the one saved last, or to the identity."),
    fixed<&G::translate_3>(
        "translate-3", "tx ty tz",
        "Translates primitives that follow, after the modelling transformation in force."),
    fixed<&G::scale_3>("scale-3", "sx sy sz",
                       "Scales primitives that follow about the origin, after the modelling "
                       "transformation in force."),
    fixed<&G::rotate_x_3>(
        "rotate-x-3", "angle",
        "Rotates primitives that follow about the x axis, after the modelling transformation in "
        "force: in degrees, counterclockwise seen from the axis's positive end."),
    fixed<&G::rotate_y_3>("rotate-y-3", "angle",
                          "Rotates about the y axis, as rotate-x-3 about the x axis."),
    fixed<&G::rotate_z_3>("rotate-z-3", "angle",
                          "Rotates about the z axis, as rotate-x-3 about the x axis."),
    fixed<&G::save_transformation_3>(
        "save-transformation-3", "",
        "Pushes the modelling transformation on a stack of at most 1024. It stays in force, and "
        "later routines act before it, in a part's own coordinates."),
    fixed<&G::restore_transformation_3>("restore-transformation-3", "",
                                        "Pops the modelling transformation saved last."),
});

constexpr auto kView = std::to_array<Routine>({
    fixed<&G::set_view_reference_point>("set-view-reference-point", "x y z",
                                        "Point in world coordinates from which window, view "
                                        "distance and view depth are measured [0 0 0]."),
    fixed<&G::set_view_plane_normal>(
        "set-view-plane-normal", "dx dy dz",
        "The direction away from the viewer, into the scene, of any length [0 0 -1]."),
    fixed<&G::set_view_distance>(
        "set-view-distance", "distance",
        "Distance from the reference point to the view plane, along the normal [0]."),
    fixed<&G::set_view_up>("set-view-up", "dx dy dz",
                           "A world direction that appears upright, of any length [0 1 0]."),
    fixed<&G::set_parallel>(
        "set-parallel", "dx dy dz",
        "Parallel projection along a world direction; oblique if it is not the normal's [0 0 1]."),
    fixed<&G::set_perspective>(
        "set-perspective", "x y z",
        "Perspective projection from a centre of projection in world coordinates."),
    fixed<&G::set_view_depth>("set-view-depth", "front back",
                              "Distances of the front and back planes from the reference point, "
                              "along the normal [-1 3]."),
    fixed<&G::set_front_plane_clipping>(
        "set-front-plane-clipping", "on|off",
        "Whether parts in front of the front plane are clipped [off]."),
    fixed<&G::set_back_plane_clipping>("set-back-plane-clipping", "on|off",
                                       "Whether parts behind the back plane are clipped [off]."),
    fixed<&G::set_window>("set-window", "x-min x-max y-min y-max",
                          "The visible rectangle in view-plane coordinates [-1 1 -1 1]."),
    fixed<&G::set_viewport>(
        "set-viewport", "x-min x-max y-min y-max",
        "The rectangle of the picture to which the window is mapped, within 0 to 1 [0 1 0 1]."),
    fixed<&G::set_window_fit>("set-window-fit", "widen|stretch",
                              "How a window is mapped to a viewport with another aspect ratio in "
                              "the picture [widen, unless window or viewport were set]."),
});

constexpr auto kHiddenSurfaces = std::to_array<Routine>({
    counted<setting<&HiddenSurfaceOptions::removal>>(
        "set-hidden-line-removal", "on|off",
        "Whether hidden surfaces and lines are removed by the hidden method, and back faces too "
        "[unset: pictures use auto and keep back faces, unless all points have one depth]."),
    fixed<&G::set_back_face_removal>(
        "set-back-face-removal", "on|off",
        "Whether polygons that face away from the viewer are removed [off]."),
    counted<setting<&HiddenSurfaceOptions::method>>(
        "set-hidden-method", "method",
        "Method for hidden surfaces or lines: auto, map, bsp, depth-sort, z-buffer, franklin and "
        "others [auto]."),
    counted<setting<&HiddenSurfaceOptions::scope>>(
        "set-hidden-scope", "segment|all",
        "Whether each segment is sorted by itself when it is closed, or all visible segments "
        "together when they are drawn [segment]."),
    varying<lines>("set-lines",
                   "one or more of all outline boundary crease[=DEGREES] material intersection",
                   "Kinds of polygon sides drawn as lines, for segments closed from now on. Any "
                   "value except all alone must be set before the first segment [all; crease 30]."),
    counted<setting<&HiddenSurfaceOptions::precision>>(
        "set-precision", "exact|roundoff[=EPS]",
        "Exact decisions, or the textbook's ROUNDOFF as a fraction of the scene's size; the map is "
        "always exact, but the lines over it use ROUNDOFF [exact; EPS 1e-9]."),
    counted<setting<&HiddenSurfaceOptions::hidden_lines>>(
        "set-hidden-lines", "none|dashed",
        "Whether hidden parts of lines are drawn dashed [none]."),
    counted<setting<&HiddenSurfaceOptions::line_order>>(
        "set-line-order", "entry|depth",
        "Which of two lines that overlap in the picture is drawn over the other: the one entered "
        "later, or the nearer one [entry]."),
    counted<setting<&HiddenSurfaceOptions::line_halo>>(
        "set-line-halo", "width",
        "With line order depth, the gap beside a line where another one crosses in front of it, in "
        "pixels [0]."),
    counted<setting<&HiddenSurfaceOptions::touching>>(
        "set-touching", "auto|off|LENGTH",
        "Distance within which polygons touch, for segments opened from now on: a polygon that "
        "touches a plane is taken to lie in it, and of coplanar polygons the one entered last is "
        "visible. auto: from the precision of the numbers; a LENGTH is before the modelling "
        "transformation [auto]."),
    counted<setting<&HiddenSurfaceOptions::z_buffer>>(
        "set-z-buffer", "on|off",
        "Whether to draw with the interpreter's z-buffer, whatever the method [off]."),
});

/// All routines, each with its section.
constexpr auto kRoutines = [] {
  constexpr std::size_t kCount = kPrimitives.size() + kShapes.size() + kAttributes.size() +
                                 kAnnotation.size() + kSegments.size() + kTransformation.size() +
                                 kView.size() + kHiddenSurfaces.size();
  std::array<Routine, kCount> all{};
  auto to = all.begin();
  const auto add = [&](std::string_view section, const auto& routines) {
    for (const Routine& routine : routines) {
      *to = routine;
      to++->section = section;
    }
  };
  add("Primitives", kPrimitives);
  add("Shapes and solids", kShapes);
  add("Attributes", kAttributes);
  add("Annotation", kAnnotation);
  add("Segments", kSegments);
  add("Modelling transformation", kTransformation);
  add("View", kView);
  add("Hidden surfaces", kHiddenSurfaces);
  return all;
}();

constexpr auto kUserRoutines = [] {
  std::array<UserRoutine, kRoutines.size()> all{};
  std::ranges::copy(kRoutines, all.begin());
  return all;
}();

[[noreturn]] void unknown_routine(std::string_view name) {
  std::array<std::string_view, kRoutines.size()> names;
  std::ranges::transform(kRoutines, names.begin(), &Routine::name);
  std::string message = fmt::format("unknown routine {}:", quoted(name));
  if (const std::string meant = did_you_mean(name, names); !meant.empty()) {
    message += meant + " expected a user routine";
  } else {
    message += " expected a user routine, such as open-segment or polygon-abs-3";
  }
  throw ErrorAt(name.data(), message);
}

}  // namespace

void call_routine(ProgramLine& line, GraphicsSystem& system) {
  const auto routine = std::ranges::find(kRoutines, line.name(), &Routine::name);
  if (routine == kRoutines.end()) unknown_routine(line.name());
  if (routine->arguments != UserRoutine::kVaries &&
      std::cmp_not_equal(routine->arguments, line.arguments())) {
    wrong_count(line, *routine);
  }
  routine->call(system, line, *routine);
}

std::span<const UserRoutine> user_routines() { return kUserRoutines; }

void call_user_routine(GraphicsSystem& system, std::string_view name, std::string_view arguments) {
  const RoundToNearest nearest;
  const std::string text = fmt::format("{} {}", name, arguments);
  const auto named = [&](std::string_view what) {
    const bool names_it = what.starts_with(name) || what.starts_with("unknown routine");
    return Error(names_it ? std::string(what) : fmt::format("{}: {}", name, what));
  };
  if (const std::size_t known = drawable_length(text); known < text.size()) {
    throw named(not_drawable(std::string_view(text).substr(known)));
  }
  ProgramLine line;
  line.split(text);
  try {
    if (line.empty() || line.name() != name) unknown_routine(name);
    call_routine(line, system);
  } catch (const ErrorAt& error) {  // its position is in this text
    throw named(error.what());
  }
}

}  // namespace displayfile
