#pragma once

/// A drawing, for programs that draw it by other means: handed to a device of their own polygon by
/// polygon and line by line, or as arrays of pieces.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/point.h"
#include "clip/surfaces.h"
#include "displayfile/looks/style.h"

namespace displayfile {

class DisplayFile;

// Devices.

/// A polygon as the interpreter meets it: normalised device coordinates (x, y in [0,1] over
/// the picture, y up; nearer is larger z) after the image transformation. sides[i] is kDrawnSide
/// if the edge that ends at vertex i is drawn, another number if not. It refers to arrays and
/// styles that stay during the call of the device.
struct DrawnPolygon {
  static constexpr std::int32_t kDrawnSide = 2;

  std::span<const Point3> vertices;
  std::span<const std::int32_t> sides;
  const FillStyle& fill;
  const LineStyle& line;
  std::int32_t pick;
  /// The intensities of the vertices of a shaded polygon, which was cut from one triangle: the fill
  /// colour is to be multiplied by the intensity, linear over the picture. Empty if the polygon is
  /// flat.
  std::span<const double> intensities = {};
  /// The kinds of line that the sides are, 0 of those that are not drawn. Empty if they were not
  /// looked for.
  std::span<const LineKinds> kinds = {};
  /// With Phong shading (displayfile/looks/phong.md) the normals of the vertices too, and the light
  /// that they are seen in, for a device that lights each pixel: to others it is Gouraud shading.
  std::span<const Point3> normals = {};
  const Light* light = nullptr;
  /// 1 for each vertex at which a drawn side was cut, by what may hide the rest of it. Empty if
  /// none was.
  std::span<const std::uint8_t> cuts = {};
};

/// Where a polygon is filled with one colour: a shaded one gets the mean of its
/// intensities.
FillStyle even_fill(const DrawnPolygon& polygon);

/// A line as the interpreter meets it; never in line style none.
struct DrawnLine {
  Point3 from, to;
  const LineStyle& style;
  LineKinds kinds = kDrawn;
  LineCuts cuts = {};
};

/// Where the interpreter draws: the one interface every output device has, those of an application
/// too (interp/device/README.md).
class OutputDevice {
 public:
  virtual ~OutputDevice() = default;
  /// The picture's size in pixels, or in whatever the widths of lines are: strokes that are shorter
  /// than their lines are wide, and join no other, are left out (hidden/lines/strokes_once.md). 0:
  /// all are drawn.
  virtual Point2 pixels() const { return Point2(0.0); }
  /// The instructions that follow, up to end_segment, are the segment's.
  virtual void begin_segment(int /*name*/) {}
  virtual void end_segment() {}
  /// The fills that follow, up to end_disjoint_fills, do not overlap: they tile what is seen. Sides
  /// of neighbours are the same, bit for bit, in opposite directions, and a vertex on a neighbour's
  /// side is a vertex of the neighbour too. Segments may begin and end in between; no lines do.
  virtual void begin_disjoint_fills() {}
  virtual void end_disjoint_fills() {}
  virtual void fill(const DrawnPolygon& polygon) = 0;   ///< the inside, in the fill style
  virtual void edges(const DrawnPolygon& polygon) = 0;  ///< the visible edges, in the line style
  virtual void line(const DrawnLine& line) = 0;
};

/// Which instructions to interpret. A device with a depth buffer draws all fills before any line,
/// so that a line meets the final depths (and wins where they are equal); otherwise everything is
/// drawn in order.
enum class Pass { everything, fills, lines };

/// Which order of the instructions: that of drawing, back to front where hidden surfaces were
/// sorted, or that of entry, every polygon whole, for a method that finds hidden surfaces itself.
enum class Order { drawn, entered };

/// Walks the visible segments in order of creation, applies their image transformations and
/// hands each instruction to the device. Where all visible segments were sorted together, a
/// segment may begin and end several times. The widths and dashes of lines are `line_scale` times
/// as large: they are in pixels, and a pixel may have several samples across.
void interpret(const DisplayFile& display_file, OutputDevice& device, Pass pass = Pass::everything,
               Order order = Order::drawn, double line_scale = 1.0);

// Pieces.

/// All that the visible segments of a display file draw, in the order of drawing, as arrays:
/// for programs that draw it by other means. Of a display file whose hidden surfaces were sorted
/// (sorted_display_file.h) they are
///  - by bsp or depth_sort all polygons from back to front, also those that others hide,
///  - by map, and by automatic, the visible pieces only,
///  - by a method that finds lines, the visible lines.
/// If they were not sorted these are all polygons and lines, as they were entered.
struct DrawnPieces {
  enum class Kind : std::uint8_t {
    solid,   ///< a polygon that is filled
    hollow,  ///< a polygon's sides alone
    line,    ///< from the first of its two points to the second
  };

  std::vector<Kind> kinds;
  /// Where each piece begins in points: piece k goes on to first[k + 1]. One more at the end.
  std::vector<std::uint32_t> first{0};
  /// Device coordinates: x and y in [0,1] over the picture, y up, larger z nearer to the viewer.
  std::vector<Point3> points;
  /// For each point 1 if the side that ends at it is drawn, or the kinds of line that it is
  /// (clip/surfaces.h), and 0 if it is not: sides that cuts made are not.
  std::vector<std::uint8_t> sides;
  /// For each point 1 if it is an end of a line, or of a side that is drawn, at which that is cut:
  /// it goes on there, but something may hide the rest. A thick line ends there without a cap.
  std::vector<std::uint8_t> cuts;
  /// One each piece: of solid polygons the colour that they are filled with, a shaded one with the
  /// mean of its shades; and how its sides, or the line, are drawn.
  std::vector<Colour> fills;
  enum class Line : std::uint8_t { solid, dashed, none };
  std::vector<Line> line_kinds;
  std::vector<Colour> line_colours;
  std::vector<double> line_widths, line_dashes, line_gaps;  ///< in pixels
  std::vector<std::int32_t> picks;     ///< pick identifiers; -1: a line without one
  std::vector<std::int32_t> segments;  ///< names

  std::size_t size() const { return kinds.size(); }
  /// Piece k but for its points.
  struct Looks {
    Kind kind;
    Colour fill;
    LineStyle line;
    std::int32_t pick, segment;
  };
  Looks looks(std::size_t k) const;
  /// The points since the last piece are one more.
  void end_piece(const Looks& looks);
};

DrawnPieces drawn_pieces(const DisplayFile& display_file);

}  // namespace displayfile
