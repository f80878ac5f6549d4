#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "clip/point.h"
#include "clip/surfaces.h"
#include "displayfile/graphics_system.h"
#include "displayfile/looks/style.h"
#include "displayfile/segments/display_file.h"
#include "hidden/primitives.h"
#include "interp/scan/pixel_box.h"
#include "interp/steps/listing.h"

/// Algorithms as recorded steps, one after another, for people to watch (interp/steps/README.md).
namespace displayfile {

/// The role of a mark, or of a panel's entry, in the step. The reader decides how to draw it.
enum class StepRole : std::uint8_t {
  none,
  root,      ///< the plane, polygon or line against which all others are tested
  compared,  ///< tested against the root, and undecided so far
  front,     ///< found in front of it, or on the viewer's side
  back,      ///< found behind it
  on,        ///< found in its plane
  cut,       ///< crosses it, or was made by a cut
  active,    ///< being processed: an area, an edge, a row, a ray
  seen,      ///< found visible
  hidden,    ///< found hidden
  tagged,    ///< has been moved before
  upper,     ///< the upper perimeter
  lower,     ///< the lower perimeter
};
/// The word of a role, in lower case.
std::string_view name_of(StepRole role);

/// Something that a step points at over the picture.
struct StepMark {
  enum class Kind : std::uint8_t {
    piece,   ///< the outline of a piece
    points,  ///< points of the unit square
    line,    ///< a chain of such points
    box,     ///< pixels, rows from the bottom
  };
  Kind kind;
  StepRole role;
  std::uint32_t piece = 0;
  std::vector<Point2> points = {};
  PixelBox box = {};
  bool stays = false;  ///< in the steps after this, too
};

/// Pixels first <= i < end of a row, counted from the bottom, where a polygon becomes visible.
struct StepRun {
  int row, first, end;
  std::uint32_t polygon;
};

/// A piece of a line found visible or hidden, of the polygon's side or the line that ends at that
/// corner: between two fractions of its projection.
struct StepLine {
  std::uint32_t polygon, corner;
  double from, to;
  Point2 start, end;  ///< in the unit square
  bool hidden = false;
};

/// A row of a list or table.
struct StepRow {
  static constexpr std::uint32_t kNoPiece = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::string> cells;
  std::uint32_t piece = kNoPiece;
  StepRole role = StepRole::none;
};

/// A node added to a tree, or a change of an existing one.
struct StepNode {
  static constexpr int kNoParent = -1;
  int node;    ///< numbered by the algorithm
  int parent;  ///< kNoParent of the root
  int branch;  ///< 0: the first below its parent, and so on; -1: the node stays where it is
  std::string text;
  std::uint32_t piece = StepRow::kNoPiece;
  StepRole role = StepRole::none;
};

/// A segment of a profile: x as in the unit square, z as in device coordinates.
struct StepSegment {
  double x0, z0, x1, z1;
  std::uint32_t piece;
  StepRole role = StepRole::none;
};

/// A panel's contents from this step on. A tree keeps its nodes; its rows name, in their cell, the
/// nodes that the step highlights.
struct PanelChange {
  int panel;
  std::vector<StepRow> rows = {};
  std::vector<StepNode> nodes = {};
  std::vector<StepSegment> segments = {};
};

struct Step {
  int line;              ///< of the listing, from 0
  std::string sentence;  ///< what happened, with the names of polygons
  std::vector<StepMark> marks = {};
  std::vector<StepRun> gained = {};  ///< by the picture
  std::vector<StepLine> lines = {};  ///< that the picture gained
  std::vector<PanelChange> panels = {};
};

/// A polygon or line of the scene, or a piece of a polygon that a cut made.
struct StepPiece {
  std::string name;
  std::uint32_t polygon;       ///< which it is, or is a piece of: items of the scene, from 0
  std::vector<Point3> points;  ///< device coordinates; of a piece rounded
};

/// A polygon or line of the scene, in addition to its piece of the same number.
struct StepPolygon {
  Primitives::Kind kind;
  Colour colour;  ///< of its fill; of a line, its own
  std::int32_t pick;
  bool edge_on;
  /// Its depth, z = z0 + dz_dx x + dz_dy y, rounded; zeros if it has none.
  double z0 = 0.0, dz_dx = 0.0, dz_dy = 0.0;
};

/// All recorded steps of an algorithm on a scene.
struct Steps {
  HiddenMethod method;
  std::string_view title;
  std::string_view source;  ///< where the algorithm is from
  std::string_view code;    ///< the file whose code runs, a path in the repository
  std::span<const ListingLine> listing;
  std::span<const PanelEntry> panels;
  int width, height;
  Colour background{1.0, 1.0, 1.0};
  std::vector<StepPolygon> polygons;
  std::vector<StepPiece> pieces;  ///< first one for each polygon
  std::vector<Step> steps;
};

struct StepsOptions {
  HiddenMethod method = HiddenMethod::bsp;  ///< or its plain form, whose steps these are
  int width = 64, height = 64;              ///< pixels of the picture
  std::size_t most_steps = 20'000;          ///< Error, which names --limit-steps, for more
};

/// Runs the algorithm, in its plain form and exactly, on the visible segments, and returns its
/// steps. The resulting picture is the item buffer of truth (interp/truth/truth.md), or for a
/// method of lines the lines that it finds. Throws Error for a method without steps, listing those
/// with steps, and for an invalid size.
Steps tell_steps(const DisplayFile& file, const StepsOptions& options);
/// The same, with the system's background.
Steps tell_steps(const GraphicsSystem& system, const StepsOptions& options);

/// The same as a JSON document, whose members interp/steps/README.md describes.
std::string steps_as_json(const GraphicsSystem& system, const StepsOptions& options);
std::string as_json(const Steps& steps);

/// The methods that record steps.
std::vector<HiddenMethod> methods_with_steps();
/// Plain forms, which name the same steps as these methods.
std::vector<HiddenMethod> plain_forms_with_steps();

}  // namespace displayfile
